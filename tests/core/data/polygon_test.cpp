#include "core/data/polygon.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace echotrail {
namespace {

using Polygon = std::vector<Eigen::Vector2f>;

TEST(PointInPolygon, FollowsTheEvenOddRule) {
    const Polygon hook{{0, 0}, {4, 0}, {4, 4}, {3, 4}, {3, 1}, {0, 1}};
    EXPECT_TRUE(isInside({1.0f, 0.5f}, hook));
    EXPECT_TRUE(isInside({3.5f, 3.0f}, hook));
    EXPECT_FALSE(isInside({1.0f, 2.0f}, hook));
    EXPECT_FALSE(isInside({5.0f, 0.5f}, hook));
    EXPECT_FALSE(isInside({1.0f, 0.5f}, Polygon{}));
}

}  // namespace
}  // namespace echotrail
