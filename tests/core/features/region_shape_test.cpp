#include "core/features/region_shape.hpp"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include <cmath>

namespace echotrail {
namespace {

/// The pixels of a filled, turned ellipse (full axes in pixels) about (200, 200).
RegionPixels ellipse(double length, double width, double angle_deg) {
    RegionPixels region;
    const double c = std::cos(angle_deg * M_PI / 180), s = std::sin(angle_deg * M_PI / 180);
    for (int row = 0; row < 400; ++row)
        for (int column = 0; column < 400; ++column) {
            const double x = column - 200.0, y = row - 200.0;
            const double u = (c * x + s * y) / (length / 2), v = (-s * x + c * y) / (width / 2);
            if (u * u + v * v <= 1)
                region.pixels.push_back({static_cast<std::int16_t>(row), static_cast<std::int16_t>(column), 100, 50});
        }
    region.peak = region.pixels.front();
    return region;
}

FanImage picture(double pixel_m = 0.125) {
    return {cv::Mat(400, 400, CV_8U, cv::Scalar(100)), cv::Mat(400, 400, CV_32S, cv::Scalar(2500)), pixel_m, 30.0,
            -20.0};
}

double m2Of(const RegionPixels& region) { return huInvariants(region.pixels)[1]; }

TEST(HuInvariants, FollowTheWrittenEquations) {
    RegionPixels region = ellipse(60, 25, 20);
    region.pixels.resize(region.pixels.size() / 2);  // no symmetry left, so that all seven count
    double n = 0, mx = 0, my = 0;
    for (const auto& p : region.pixels) n += 1, mx += p.column, my += p.row;
    mx /= n, my /= n;
    const auto eta = [&](int p, int q) {
        double mu = 0;
        for (const auto& pixel : region.pixels) mu += std::pow(pixel.column - mx, p) * std::pow(pixel.row - my, q);
        return mu / std::pow(n, (p + q) / 2.0 + 1);
    };
    const double a = eta(3, 0) + eta(1, 2), b = eta(2, 1) + eta(0, 3), c = eta(3, 0) - 3 * eta(1, 2),
                 d = 3 * eta(2, 1) - eta(0, 3), e20 = eta(2, 0), e02 = eta(0, 2), e11 = eta(1, 1);
    const std::array<double, 7> expected{e20 + e02,
                                         (e20 - e02) * (e20 - e02) + 4 * e11 * e11,
                                         c * c + d * d,
                                         a * a + b * b,
                                         c * a * (a * a - 3 * b * b) + d * b * (3 * a * a - b * b),
                                         (e20 - e02) * (a * a - b * b) + 4 * e11 * a * b,
                                         d * a * (a * a - 3 * b * b) - c * b * (3 * a * a - b * b)};
    const auto measured = huInvariants(region.pixels);
    for (int i = 0; i < 7; ++i) EXPECT_NEAR(measured[i], expected[i], 1e-9) << "M" << i + 1;
}

TEST(RegionShape, MomentFeatureIsThatOfTheSecondInvariant) {
    const RegionPixels region = ellipse(60, 20, 33);
    EXPECT_NEAR(measureRegion(region, picture(), {}).features.moment, std::log10(m2Of(region) + 1e-3), 1e-9);
}

TEST(RegionShape, TurningAndScalingLeaveTheMomentWithinFivePercent) {
    const double upright = m2Of(ellipse(60, 20, 0));
    EXPECT_NEAR(m2Of(ellipse(60, 20, 30)), upright, 0.05 * upright);
    EXPECT_NEAR(m2Of(ellipse(60, 20, 90)), upright, 0.05 * upright);
    EXPECT_NEAR(m2Of(ellipse(120, 40, 15)), upright, 0.05 * upright);
    const double e = 3.0, root = (e - 1 / e) / (4 * M_PI);
    EXPECT_NEAR(upright, root * root, 0.05 * root * root);
}

TEST(RegionShape, PlaceTimeAndAreaAreInMetresAndUtc) {
    const Timestamp epoch(Microseconds(1'000'000));
    const Region region = measureRegion(ellipse(40, 20, 0), picture(), epoch);
    EXPECT_NEAR(region.position_m.x(), 30.0 - 200 * 0.125, 1e-9);   // rows run south
    EXPECT_NEAR(region.position_m.y(), -20.0 + 200 * 0.125, 1e-9);  // columns run east
    EXPECT_EQ(region.time, epoch + Microseconds(2'500'000));
    EXPECT_NEAR(region.features.area_m2, M_PI / 4 * 5.0 * 2.5, 0.2);
    EXPECT_FALSE(region.outline_m.empty());
}

TEST(RegionShape, WidthsAreAlongAndAcrossTheLineOfSight) {
    const FanImage image = picture();
    const RegionPixels region = ellipse(40, 16, 0);  // long axis east–west: 5 m by 2 m
    Region measured = measureRegion(region, image, {});
    // From a head 20 m south of it, looking north, east–west is across; the bow points east.
    const Pose south{measured.position_m.x() - 20, measured.position_m.y(), Bearing::degrees(90)};
    seenFromHead(measured, region, image, south);
    EXPECT_NEAR(measured.range_m, 20, 1e-9);
    EXPECT_NEAR(measured.bearing.inDegrees(), -90, 1e-9);
    EXPECT_NEAR(measured.features.across_range_m, 5.0, 0.1);
    EXPECT_NEAR(measured.features.along_range_m, 2.0, 0.1);
    seenFromHead(measured, region, image, {measured.position_m.x(), measured.position_m.y() - 20, {}});
    EXPECT_NEAR(measured.features.along_range_m, 5.0, 0.1);
}

}  // namespace
}  // namespace echotrail
