#include "core/simulation/acoustics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace echotrail::acoustics {
namespace {

TEST(Absorption, IsThatOfSeaWaterAtBothChannels) {
    EXPECT_NEAR(absorption(325e3) * 1000.0, 95.0, 1.0);
    EXPECT_NEAR(absorption(675e3) * 1000.0, 198.0, 1.0);
}

TEST(Absorption, IsLessInFreshWater) { EXPECT_LT(absorption(325e3, {.salinity_psu = 0.0}), 0.5 * absorption(325e3)); }

TEST(Lobe, HasHalfItsPowerAtHalfItsWidth) {
    for (const double frequency_hz : {325e3, 675e3}) {
        const Lobe lobe = lobeAt(frequency_hz);
        EXPECT_DOUBLE_EQ(lobe.across(lobe.width_rad / 2.0), 0.5);
        EXPECT_DOUBLE_EQ(lobe.above(-lobe.height_rad / 2.0), 0.5);
        EXPECT_DOUBLE_EQ(lobe.across(0.0), 1.0);
    }
    EXPECT_LT(lobeAt(675e3).width_rad, lobeAt(325e3).width_rad);
}

TEST(Lobe, IntegralWidthIsTheAreaUnderTheTwoWayPattern) {
    const Lobe lobe;
    double area = 0.0;
    for (double angle = -0.3; angle < 0.3; angle += 1e-4) area += lobe.across(angle) * lobe.across(angle) * 1e-4;
    EXPECT_NEAR(lobe.integralWidth() / area, 1.0, 0.001);
}

TEST(Lobe, SideLobesKeepEverythingAudible) { EXPECT_NEAR(decibels(twoWay(1e-9, 1e-9)), -45.0, 1e-9); }

TEST(Reflector, IsLimitedByItsMirrorImageWithinTheSonarsRange) {
    EXPECT_NEAR(reflectorStrength(1.0, 20.0, 325e3, 1490.0), 10.0, 1e-9);
    EXPECT_NEAR(reflectorStrength(1.0, 50.0, 325e3, 1490.0), 17.96, 0.01);
    EXPECT_NEAR(reflectorStrength(0.1, 50.0, 325e3, 1490.0), 20.0 * std::log10(0.01 / std::sqrt(3.0) * 218.12) - 10.0,
                0.01);
}

/// The two depths of the method's note on what tells the channels apart.
double bottomDb(double frequency_hz, double altitude_m) {
    return decibels(boundaryPower(lobeAt(frequency_hz), 20.0, 0.125, altitude_m, -22.0, false));
}

TEST(Bottom, FadesWithAltitudeInTheLowChannelOnly) {
    EXPECT_NEAR(bottomDb(325e3, 2.5), -53.0, 0.5);
    EXPECT_NEAR(bottomDb(325e3, 8.0), -73.0, 0.5);
    EXPECT_NEAR(bottomDb(675e3, 2.5), -54.0, 0.5);
    EXPECT_NEAR(bottomDb(675e3, 8.0), -51.0, 0.5);
}

TEST(Bottom, IsSilentNearerThanItIsAndKeepsItsFloorFarOut) {
    EXPECT_EQ(boundaryPower({}, 4.9, 0.1, 5.0, -20.0, true), 0.0);
    const double bare = boundaryPower({}, 50.0, 0.1, 2.0, -20.0, false);
    const double floored = boundaryPower({}, 50.0, 0.1, 2.0, -20.0, true);
    EXPECT_NEAR(decibels(floored / bare), 20.0 * std::log10(std::sin(radiansFromDegrees(6.0)) / 0.04), 1e-6);
}

}  // namespace
}  // namespace echotrail::acoustics
