#include "core/tracking/beam_pass.hpp"

#include <gtest/gtest.h>

namespace echotrail {
namespace {

constexpr double step_deg = 1.8;

BeamMoment beamAt(double bearing_deg, int ping) {
    BeamMoment beam;
    beam.time = Timestamp(Microseconds(100'000 * ping));
    beam.azimuth = Bearing::degrees(bearing_deg);
    beam.step_rad = radiansFromDegrees(step_deg);
    beam.beam_width_rad = radiansFromDegrees(3);
    beam.far_m = 50;
    return beam;
}

ExpectedPlace placeAt(double range_m, double bearing_deg, double sigma_m = 0.5) {
    GaussianState state;
    const double azimuth = radiansFromDegrees(bearing_deg);
    state.mean << range_m * std::cos(azimuth), range_m * std::sin(azimuth), 0, 0;
    state.covariance = sigma_m * sigma_m * Eigen::Matrix4d::Identity();
    return expectedPlace(state, {});
}

TEST(BeamPass, BeginsInTheGateEndsBeyondItAndKnowsWhenTheBeamWasOnThePlace) {
    BeamPass pass;
    const ExpectedPlace place = placeAt(20, 0);
    const double half_width = radiansFromDegrees(8);
    for (int i = 0; i < 50 && !pass.ended(); ++i) pass.follow(beamAt(-45 + step_deg * i, i), place, half_width);
    EXPECT_TRUE(pass.ended());
    EXPECT_EQ(pass.nearestTime(), beamAt(0, 25).time);  // −45 + 25 · 1.8 = 0
    EXPECT_GT(pass.coverage(), 0.99);
}

TEST(BeamPass, BrokenOffBeforeThePlaceCoversLittle) {
    BeamPass pass;
    const ExpectedPlace place = placeAt(20, 5, 0.3);  // σ is 0.86°
    for (int i = 0; i < 4; ++i) pass.follow(beamAt(-4 + step_deg * i, i), place, radiansFromDegrees(10));
    pass.breakOff();
    EXPECT_TRUE(pass.ended());
    EXPECT_LT(pass.coverage(), 0.05);
}

TEST(BeamPass, PlaceBeyondTheEndOfTheLineIsNotCovered) {
    BeamPass pass;
    for (int i = 0; i < 50; ++i) pass.follow(beamAt(-45 + step_deg * i, i), placeAt(60, 0), radiansFromDegrees(8));
    EXPECT_LT(pass.coverage(), 1e-6);
}

TEST(BeamPass, BeamThatNeverComesByIsNoPass) {
    BeamPass pass;
    for (int i = 0; i < 20; ++i) pass.follow(beamAt(-45 + step_deg * i, i), placeAt(20, 100), radiansFromDegrees(8));
    pass.breakOff();
    EXPECT_FALSE(pass.ended());
    EXPECT_EQ(pass.coverage(), 0.0);
}

TEST(ExpectedPlace, SplitsTheSpreadAlongAndAcrossTheLineOfSight) {
    GaussianState state;
    state.mean << 0, 10, 0, 0;  // due east
    state.covariance = Eigen::Vector4d(4, 1, 1, 1).asDiagonal();
    const ExpectedPlace place = expectedPlace(state, {});
    EXPECT_NEAR(place.azimuth.inDegrees(), 90, 1e-9);
    EXPECT_NEAR(place.across_sigma_m, 2, 1e-12);
    EXPECT_NEAR(place.along_sigma_m, 1, 1e-12);
}

}  // namespace
}  // namespace echotrail
