#include "core/imaging/fan_projector.hpp"

#include "core/base/random.hpp"
#include "core/imaging/wedge_painter.hpp"
#include "tests/core/imaging/fan_fixture.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <deque>

namespace echotrail {
namespace {

constexpr double range_m = 50.0;
constexpr int bins = 200;

/// A turn of the beam seen from a vehicle that moves and yaws; a ping lasts 70 ms.
std::deque<OwnedRay> turnWhileMoving(double north_mps, double east_mps, double yaw_dps, std::uint8_t constant = 0) {
    std::deque<OwnedRay> rays;
    for (int k = 0; k <= 200; ++k) {
        RandomStream random(3, 2, k);
        std::vector<std::uint8_t> levels(bins, constant);
        if (constant == 0)
            for (auto& level : levels) level = static_cast<std::uint8_t>(random.bits() & 0xFF);
        const double time = 0.07 * k;
        rays.emplace_back(std::move(levels), 1.8 * k, range_m / bins);
        Ray& ray = rays.back().ray;
        ray.azimuth_rad = wrapRadians(radiansFromDegrees(1.8 * k + yaw_dps * time));
        ray.turn_rad_per_m = radiansFromDegrees(yaw_dps) / 1500.0;
        ray.origin_north_m = north_mps * time;
        ray.origin_east_m = east_mps * time;
        ray.drift_north = north_mps / 1500.0;
        ray.drift_east = east_mps / 1500.0;
        ray.time_ms = static_cast<std::int32_t>(70 * k);
    }
    return rays;
}

bool sameBytes(const FanImage& a, const FanImage& b) {
    return a.levels.size() == b.levels.size() && a.north_m == b.north_m && a.east_m == b.east_m &&
           std::memcmp(a.levels.data, b.levels.data, a.levels.total()) == 0 &&
           std::memcmp(a.beam_time_ms.data, b.beam_time_ms.data, 4 * a.beam_time_ms.total()) == 0;
}

TEST(FanProjector, APictureThatFollowedTheVehicleEqualsOnePaintedAtOnce) {
    const auto rays = turnWhileMoving(1.0, -0.8, 4.0);
    FanProjector projector({});
    for (const OwnedRay& owned : rays) projector.add(owned.ray, range_m, false);

    FanImage whole = projector.image().clone();
    ASSERT_NE(whole.north_m, 60.0) << "the picture is meant to have moved";
    whole.levels.setTo(0);
    whole.beam_time_ms.setTo(FanImage::never_scanned);
    for (std::size_t k = 1; k < rays.size(); ++k) paintWedge(rays[k - 1].ray, rays[k].ray, {0, range_m}, whole);
    EXPECT_TRUE(sameBytes(projector.image(), whole));
}

}  // namespace
}  // namespace echotrail
