#include "core/imaging/wedge_painter.hpp"

#include "core/base/random.hpp"
#include "tests/core/imaging/fan_fixture.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace echotrail
