#include "core/filters/lookup_filter.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace echotrail {
namespace {

using Polygon = std::vector<Eigen::Vector2f>;

Polygon square(float north, float east, float half) {
    return {{north - half, east - half},
            {north - half, east + half},
            {north + half, east + half},
            {north + half, east - half}};
}

GaussianState prior() {
    GaussianState state{.mean = {10.0, 5.0, 0.0, 0.0}};
    state.covariance.topLeftCorner<2, 2>() = 4.0 * Eigen::Matrix2d::Identity();
    return state;
}

TEST(LookupFilter, GoesWhereTheScoredRegionIs) {
    const Polygon region = square(11, 6, 0.5f);
    const std::array areas{ScoredArea{region, 0.8}};
    ParticleCloud cloud;
    const LookupUpdate update = lookupUpdate(prior(), areas, 4000, 0.05, RandomStream(1, 2, 3), &cloud);
    ASSERT_FALSE(update.posterior.missed);
    EXPECT_NEAR(update.posterior.state.mean.x(), 11.0, 0.1);
    EXPECT_NEAR(update.posterior.state.mean.y(), 6.0, 0.1);
    // Spread evenly over a square of side 1: its deviation is 1/√12, whatever the error of the place may be.
    EXPECT_NEAR(std::sqrt(update.posterior.state.covariance(0, 0)), 1.0 / std::sqrt(12.0), 0.03);
    EXPECT_EQ(cloud.position_m.size(), 4000u);
}

TEST(LookupFilter, SharesGoByScoreAndParticles) {
    const Polygon here = square(10, 4, 0.5f), there = square(10, 6, 0.5f);
    const std::array areas{ScoredArea{here, 0.9}, ScoredArea{there, 0.3}};
    const LookupUpdate update = lookupUpdate(prior(), areas, 20000, 0.05, RandomStream(1, 2, 3), nullptr);
    EXPECT_NEAR(update.share[0], 0.75, 0.05);
    EXPECT_NEAR(update.share[0] + update.share[1], 1.0, 1e-9);
}

TEST(LookupFilter, LosesTheCueWhereNoParticleLiesInARegion) {
    const Polygon far = square(60, 60, 0.5f);
    const std::array areas{ScoredArea{far, 1.0}};
    const LookupUpdate update = lookupUpdate(prior(), areas, 500, 0.05, RandomStream(1, 2, 3), nullptr);
    EXPECT_TRUE(update.posterior.missed);
    EXPECT_EQ(update.posterior.state.mean, prior().mean);
    EXPECT_TRUE(lookupUpdate(prior(), {}, 500, 0.05, RandomStream(1, 2, 3), nullptr).posterior.missed);
}

}  // namespace
}  // namespace echotrail
