#include "core/data/area.hpp"

#include "core/data/pose.hpp"

#include <gtest/gtest.h>

namespace echotrail {
namespace {

const std::vector<Eigen::Vector2f> box_ahead{{5.0F, -2.0F}, {10.0F, -2.0F}, {10.0F, 2.0F}, {5.0F, 2.0F}};
const Pose eastward{100.0, 50.0, Bearing::degrees(90.0)};

TEST(Area, OnTheGroundStaysWhereItIsWhateverTheVehicleDoes) {
    const Area area{Area::Kind::Guard, "quay", false, box_ahead};
    EXPECT_TRUE(holds(area, {7.0F, 0.0F}, {}));
    EXPECT_TRUE(holds(area, {7.0F, 0.0F}, eastward));
    EXPECT_FALSE(holds(area, {7.0F, 3.0F}, eastward));
}

TEST(Area, WithTheVehicleItMovesAndTurns) {
    const Area area{Area::Kind::Guard, "ahead", true, box_ahead};
    EXPECT_TRUE(holds(area, {100.0F, 57.0F}, eastward)) << "seven metres ahead of a bow that points east";
    EXPECT_FALSE(holds(area, {107.0F, 50.0F}, eastward)) << "that is to port";
}

TEST(Area, CornersComeBackFromTheGround) {
    const Area area{Area::Kind::Veto, "", true, box_ahead};
    for (const Eigen::Vector2f& corner : box_ahead)
        EXPECT_LT((cornerAt(area, placeOf(area, corner, eastward), eastward) - corner).norm(), 1e-4F);
}

TEST(Area, TwoCornersHoldNothing) {
    EXPECT_FALSE(holds({Area::Kind::Guard, "", false, {}}, {0.0F, 0.0F}, {}));
    EXPECT_FALSE(holds({Area::Kind::Guard, "", false, {{-1.0F, 0.0F}, {1.0F, 0.0F}}}, {0.0F, 0.0F}, {}));
}

}  // namespace
}  // namespace echotrail
