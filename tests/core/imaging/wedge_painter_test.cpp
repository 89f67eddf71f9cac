#include "core/imaging/wedge_painter.hpp"

#include "core/base/random.hpp"
#include "tests/core/imaging/fan_fixture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace echotrail {
namespace {

constexpr double pixel_m = 0.125, bin_m = 0.0625;
constexpr int bins = 160;  // 10 m, 80 pixels

std::vector<std::uint8_t> noise(std::uint64_t index) {
    RandomStream random(7, 1, index);
    std::vector<std::uint8_t> levels(bins);
    for (auto& level : levels) level = static_cast<std::uint8_t>(random.bits() & 0xFF);
    return levels;
}

/// The method card's rule, pixel by pixel, with the library's arc tangent; for a head that stands still.
void expectAsTheCardSays(const OwnedRay& a, const OwnedRay& b, RangeInterval metres, const FanImage& tile) {
    const double sign = b.ray.head_bearing - a.ray.head_bearing > 0 ? 1.0 : -1.0;
    const auto sample = [](const Ray& ray, double range) {
        const double bin = std::clamp(range / ray.bin_size_m - 0.5, 0.0, static_cast<double>(ray.levels.size() - 1));
        const auto i = std::min(static_cast<std::size_t>(bin), ray.levels.size() - 2);
        const double f = bin - static_cast<double>(i);
        return (1 - f) * ray.levels[i] + f * ray.levels[i + 1];
    };
    int painted = 0;
    for (int row = 0; row < tile.levels.rows; ++row) {
        for (int column = 0; column < tile.levels.cols; ++column) {
            const double north = tile.northOf(row) - a.ray.origin_north_m;
            const double east = tile.eastOf(column) - a.ray.origin_east_m;
            const double range = std::hypot(north, east), azimuth = std::atan2(east, north);
            const double alpha1 = sign * wrapRadians(azimuth - a.ray.azimuth_rad);
            const double alpha2 = sign * wrapRadians(b.ray.azimuth_rad - azimuth);
            const double margin = 1e-3 * pixel_m / std::max(range, pixel_m) * 1.1;
            const bool in_range = range >= metres.near_m && range <= std::min(metres.far_m, a.ray.farEnd());
            const bool surely_outside = alpha1 < -margin || alpha2 < -margin || !in_range;
            const bool surely_inside = alpha1 > margin && alpha2 > margin && in_range;
            if (surely_outside) {
                EXPECT_FALSE(isPainted(tile, row, column)) << row << ' ' << column;
            }
            if (!surely_inside) continue;
            ++painted;
            ASSERT_TRUE(isPainted(tile, row, column)) << row << ' ' << column;
            const double u = alpha1 / (alpha1 + alpha2);
            const double level = (1 - u) * sample(a.ray, range) + u * sample(b.ray, range);
            EXPECT_NEAR(tile.levels.at<std::uint8_t>(row, column), level, 1.0) << row << ' ' << column;
            EXPECT_EQ(tile.beam_time_ms.at<std::int32_t>(row, column), u < 0.5 ? a.ray.time_ms : b.ray.time_ms);
        }
    }
    EXPECT_GT(painted, 0);
}

TEST(WedgePainter, PaintsWhatTheCardSaysInEveryDirectionEitherWayRound) {
    for (int degrees = -180; degrees < 180; degrees += 7) {
        for (const double step : {1.8, -1.8, 3.6}) {
            OwnedRay a(noise(1), degrees, bin_m), b(noise(2), degrees + step, bin_m);
            a.ray.time_ms = 100;
            b.ray.time_ms = 170;
            for (Ray* ray : {&a.ray, &b.ray}) {
                ray->origin_north_m = 300.03;
                ray->origin_east_m = -77.7;
            }
            FanImage tile = emptyTile(2400 + 90, -622 - 90, 181, 181, pixel_m);
            paintWedge(a.ray, b.ray, {1.0, 9.5}, tile);
            expectAsTheCardSays(a, b, {1.0, 9.5}, tile);
        }
    }
}

TEST(WedgePainter, APatchGetsTheSameBytesAsTheWholeFan) {
    const OwnedRay a(noise(1), 40, bin_m), b(noise(2), 41.8, bin_m);
    FanImage whole = emptyTile(90, -90, 181, 181, pixel_m);
    paintWedge(a.ray, b.ray, {0, 10}, whole);
    FanImage patch = emptyTile(52, 31, 20, 25, pixel_m);
    paintWedge(a.ray, b.ray, {5, 8}, patch);
    int painted = 0;
    for (int row = 0; row < patch.levels.rows; ++row)
        for (int column = 0; column < patch.levels.cols; ++column) {
            if (!isPainted(patch, row, column)) continue;
            ++painted;
            EXPECT_EQ(patch.levels.at<std::uint8_t>(row, column),
                      whole.levels.at<std::uint8_t>(row + 38, column + 121));
        }
    EXPECT_GT(painted, 20);
}

int paintedPixels(const FanImage& tile) { return cv::countNonZero(tile.beam_time_ms != FanImage::never_scanned); }

int pixelsBetween(double from_deg, double to_deg, double step_deg) {
    const OwnedRay a(noise(1), from_deg, bin_m, step_deg), b(noise(2), to_deg, bin_m, step_deg);
    FanImage tile = emptyTile(90, -90, 181, 181, pixel_m);
    paintWedge(a.ray, b.ray, {0, 10}, tile);
    return paintedPixels(tile);
}

TEST(WedgePainter, FillsGapsOfTwoStepsButNotOfThree) {
    EXPECT_GT(pixelsBetween(10, 11.8, 1.8), 50);
    EXPECT_GT(pixelsBetween(10, 13.6, 1.8), 100);
    EXPECT_EQ(pixelsBetween(10, 15.4, 1.8), 0);
    EXPECT_GT(pixelsBetween(179.9, -178.3, 1.8), 50) << "through the head's own back";
    EXPECT_EQ(pixelsBetween(-90, 90, 1.8), 0) << "a flyback";
}

TEST(WedgePainter, PaintsNothingBetweenEqualBearings) { EXPECT_EQ(pixelsBetween(33.3, 33.3, 1.8), 0); }

TEST(WedgePainter, AWholeTurnLeavesNoGapsAndNothingOutsideItsCircle) {
    for (const double origin : {0.0, 0.037, -51.2345}) {
        FanImage tile = emptyTile(static_cast<int>(std::lround(origin / pixel_m)) + 90,
                                  static_cast<int>(std::lround(origin / pixel_m)) - 90, 181, 181, pixel_m);
        for (int k = 0; k < 400; ++k) {
            OwnedRay a(noise(k), 0.9 * k, bin_m, 0.9), b(noise(k + 1), 0.9 * (k + 1), bin_m, 0.9);
            for (Ray* ray : {&a.ray, &b.ray}) ray->origin_north_m = ray->origin_east_m = origin;
            paintWedge(a.ray, b.ray, {0, 10}, tile);
        }
        for (int row = 0; row < 181; ++row)
            for (int column = 0; column < 181; ++column) {
                const double range = std::hypot(tile.northOf(row) - origin, tile.eastOf(column) - origin);
                if (std::abs(range - 10.0) < 1e-4) continue;
                EXPECT_EQ(isPainted(tile, row, column), range < 10.0) << row << ' ' << column << ' ' << origin;
            }
    }
}

TEST(WedgePainter, ConstantLevelsStayConstantThroughMotionAndInterpolation) {
    for (const int value : {0, 1, 100, 254, 255}) {
        const auto level = static_cast<std::uint8_t>(value);
        OwnedRay a(std::vector<std::uint8_t>(bins, level), 30, bin_m),
            b(std::vector<std::uint8_t>(97, level), 31.8, 0.1);
        a.ray.drift_north = b.ray.drift_north = 0.002;
        a.ray.turn_rad_per_m = b.ray.turn_rad_per_m = -1e-4;
        b.ray.origin_north_m = 0.07;
        FanImage tile = emptyTile(90, -90, 181, 181, pixel_m);
        tile.levels.setTo(77);
        paintWedge(a.ray, b.ray, {0, 10}, tile);
        const cv::Mat scanned = tile.beam_time_ms != FanImage::never_scanned;
        EXPECT_GT(cv::countNonZero(scanned), 50);
        EXPECT_EQ(cv::countNonZero((tile.levels != level) & scanned), 0);
        EXPECT_EQ(cv::countNonZero((tile.levels != 77) & ~scanned), 0);
    }
}

TEST(WedgePainter, TheNewestWins) {
    const OwnedRay a(noise(1), 10, bin_m), b(std::vector<std::uint8_t>(bins, 50), 11.8, bin_m);
    OwnedRay c(std::vector<std::uint8_t>(bins, 50), 10, bin_m);
    c.ray.time_ms = 9000;
    FanImage tile = emptyTile(90, -90, 181, 181, pixel_m), once = tile.clone();
    paintWedge(a.ray, b.ray, {0, 10}, tile);
    paintWedge(b.ray, c.ray, {0, 10}, tile);
    paintWedge(b.ray, c.ray, {0, 10}, once);
    EXPECT_EQ(cv::countNonZero(tile.levels != once.levels), 0);
    EXPECT_EQ(cv::countNonZero(tile.beam_time_ms != once.beam_time_ms), 0);
}

TEST(WedgePainter, AHeadThatOutrunsItsBeamLeavesNoHoleBeforeTheCrossing) {
    // Abeam to starboard, scanning aft, while the head moves ahead 0.2 m per ping: the lines cross 6.4 m off.
    FanImage tile = emptyTile(90, -90, 181, 181, pixel_m);
    for (int k = 0; k < 6; ++k) {
        OwnedRay a(noise(k), 90 + 1.8 * k, bin_m), b(noise(k + 1), 90 + 1.8 * (k + 1), bin_m);
        a.ray.origin_north_m = 0.2 * k;
        b.ray.origin_north_m = 0.2 * (k + 1);
        paintWedge(a.ray, b.ray, {0, 10}, tile);
    }
    // On the line 1 m to starboard the beam went from 0 to 1.2 m north, less 1 m * tan(10.8 degrees).
    for (int north = 0; north <= 8; ++north) EXPECT_TRUE(isPainted(tile, 90 - north, 90 + 8)) << north;
    EXPECT_FALSE(isPainted(tile, 90 - 9, 90 + 8));
    EXPECT_FALSE(isPainted(tile, 90 + 1, 90 + 8));
}

TEST(WedgePainter, WhatMakesNoSenseIsNotPainted) {
    const OwnedRay good(noise(1), 10, bin_m), short_line({5}, 11.8, bin_m);
    OwnedRay no_bins(noise(2), 11.8, 0.0), lost(noise(2), 11.8, bin_m), unknown(noise(2), 11.8, bin_m);
    lost.ray.origin_north_m = 1e9;
    unknown.ray.origin_east_m = std::numeric_limits<double>::quiet_NaN();
    FanImage tile = emptyTile(90, -90, 181, 181, pixel_m);
    for (const OwnedRay* bad : std::initializer_list<const OwnedRay*>{&short_line, &no_bins, &lost, &unknown}) {
        paintWedge(good.ray, bad->ray, {0, 10}, tile);
        paintWedge(bad->ray, good.ray, {0, 10}, tile);
    }
    EXPECT_EQ(paintedPixels(tile), 0);
}

TEST(WedgePainter, APartlyOrWhollyMissedTileIsPaintedOnlyWhereItIsMet) {
    const OwnedRay a(noise(1), 40, bin_m), b(noise(2), 41.8, bin_m);
    FanImage beside = emptyTile(-20, -60, 30, 30, pixel_m), far_away = emptyTile(9000, 9000, 30, 30, pixel_m);
    paintWedge(a.ray, b.ray, {0, 10}, beside);
    paintWedge(a.ray, b.ray, {0, 10}, far_away);
    EXPECT_EQ(paintedPixels(beside) + paintedPixels(far_away), 0);
}

}  // namespace
}  // namespace echotrail
