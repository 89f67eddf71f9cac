#include "core/base/angles.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace echotrail {
namespace {

TEST(Bearing, DifferenceAcrossTheSternIsTheShortWay) {
    EXPECT_NEAR(Bearing::degrees(-179) - Bearing::degrees(179), radiansFromDegrees(2.0), 1e-12);
    EXPECT_NEAR(Bearing::degrees(179) - Bearing::degrees(-179), radiansFromDegrees(-2.0), 1e-12);
}

TEST(Bearing, IsAlwaysInTheHalfOpenTurn) {
    for (int degrees = -1440; degrees <= 1440; degrees += 45) {
        const double value = Bearing::degrees(degrees).inDegrees();
        EXPECT_GE(value, -180.0) << degrees;
        EXPECT_LT(value, 180.0) << degrees;
        EXPECT_NEAR(std::remainder(value - degrees, 360.0), 0.0, 1e-9) << degrees;
    }
}

TEST(Bearing, TurnsAddUp) {
    const Bearing start = Bearing::degrees(170);
    EXPECT_NEAR((start + radiansFromDegrees(20)).inDegrees(), -170.0, 1e-9);
}

}  // namespace
}  // namespace echotrail
