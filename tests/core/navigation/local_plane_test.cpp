#include "core/navigation/local_plane.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace echotrail {
namespace {

GeographicPosition at(double latitude_deg, double longitude_deg) {
    return {radiansFromDegrees(latitude_deg), radiansFromDegrees(longitude_deg)};
}

// Lengths of a minute of arc on WGS-84 from the radii of curvature a(1-e²)/(1-e²sin²φ)^1.5 and a·cosφ/(1-e²sin²φ)^0.5.
TEST(LocalPlane, MinutesOfArcHaveTheirLengthOnTheEllipsoid) {
    EXPECT_NEAR(LocalPlane(at(0, 10)).toLocal(at(1.0 / 60.0, 10)).north_m, 1842.905, 0.002);
    EXPECT_NEAR(LocalPlane(at(0, 10)).toLocal(at(0, 10 + 1.0 / 60.0)).east_m, 1855.325, 0.002);
    EXPECT_NEAR(LocalPlane(at(45 - 0.5 / 60.0, 10)).toLocal(at(45 + 0.5 / 60.0, 10)).north_m, 1852.196, 0.002);
    EXPECT_NEAR(LocalPlane(at(-60, 10)).toLocal(at(-60, 10 + 1.0 / 60.0)).east_m, 930.000, 0.002);
}

TEST(LocalPlane, OriginIsZeroAndSouthAndWestAreNegative) {
    const LocalPlane plane(at(-33, 151));
    EXPECT_EQ(plane.toLocal(at(-33, 151)).north_m, 0.0);
    EXPECT_EQ(plane.toLocal(at(-33, 151)).east_m, 0.0);
    EXPECT_LT(plane.toLocal(at(-33.01, 151)).north_m, -1000.0);
    EXPECT_LT(plane.toLocal(at(-33, 150.99)).east_m, -900.0);
}

TEST(LocalPlane, TheDateLineIsNoEdge) {
    const double across = LocalPlane(at(10, 179.995)).toLocal(at(10, -179.995)).east_m;
    const double elsewhere = LocalPlane(at(10, 0)).toLocal(at(10, 0.01)).east_m;
    EXPECT_NEAR(across, elsewhere, 1e-6);
}

TEST(LocalPlane, ThereAndBackIsLessThanAMillimetre) {
    const LocalPlane plane(at(69.5, 179.9), {120.0, -40.0});
    EXPECT_NEAR(plane.toLocal(at(69.5, 179.9)).north_m, 120.0, 1e-9) << "the origin may lie elsewhere";
    for (const LocalPosition place : {LocalPosition{0, 0}, {100, 20'000}, {-60'000, -60'000}, {99'000, 3}}) {
        const GeographicPosition found = plane.toGeographic(place);
        EXPECT_LE(std::abs(found.longitude_rad), std::numbers::pi);
        EXPECT_NEAR(plane.toLocal(found).north_m, place.north_m, 1e-3);
        EXPECT_NEAR(plane.toLocal(found).east_m, place.east_m, 1e-3);
    }
}

}  // namespace
}  // namespace echotrail
