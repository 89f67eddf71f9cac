#include "core/runtime/scene_builder.hpp"

#include "sector_scan.hpp"

#include <gtest/gtest.h>

namespace echotrail {
namespace {

/// Feeds a scan whose sweeps begin every `sweep_pings` pings; a region at 4° is reported right after the beam left it.
SceneBuilder built(const std::vector<Ping>& scan, std::uint64_t sweep_pings) {
    SceneBuilder builder;
    std::uint32_t id = 0;
    for (const Ping& ping : scan) {
        Update update{.ping = ping.sequence, .time = ping.time, .beam = ping.bearing};
        update.sweep_ended = ping.sequence > 0 && ping.sequence % sweep_pings == 0;
        if (std::abs(ping.bearing.inDegrees() - (ping.clockwise ? 6.0 : 2.0)) < 0.1) {
            Region region;
            region.id = ++id;
            region.time = ping.time - std::chrono::milliseconds(50);
            region.bearing = Bearing::degrees(4);
            update.regions.push_back(region);
        }
        builder.add(ping, update, 1e-6);
    }
    return builder;
}

Scene sceneAfter(std::uint64_t pings) {
    const auto scan = test::sectorScan(pings);
    const ScanningSonarPipeline pipeline({}, 1);
    return built(scan, 21).build(pipeline, scan.back(), {});
}

TEST(SceneBuilder, KeepsARegionUntilTheBeamReturnsToIt) {
    const Scene before = sceneAfter(21 + 5);
    ASSERT_EQ(before.regions.size(), 1U);
    EXPECT_EQ(before.regions[0].id, 1U);
    EXPECT_TRUE(sceneAfter(21 + 9).regions.empty()) << "the beam is on it now";
    const Scene after = sceneAfter(21 + 11);
    ASSERT_EQ(after.regions.size(), 1U);
    EXPECT_EQ(after.regions[0].id, 2U);
}

TEST(SceneBuilder, TellsTheSweepDurationAndTheEdgesOfTheSector) {
    EXPECT_EQ(sceneAfter(20).sweep_s, 0.0);
    const Scene scene = sceneAfter(50);
    EXPECT_NEAR(scene.sweep_s, 21 * 0.05, 1e-9);
    EXPECT_NEAR(scene.sector_left.inDegrees(), -20.0, 1e-9);
    EXPECT_NEAR(scene.sector_right.inDegrees(), 20.0, 1e-9);
    EXPECT_NEAR(sceneAfter(5).sector_right.inDegrees(), -12.0, 1e-9) << "as far as the first sweep has come";
}

TEST(SceneBuilder, AFullTurnReachesAllBearings) {
    auto scan = test::sectorScan(400);
    for (Ping& ping : scan) ping.bearing = Bearing::degrees(100.0 + 2.0 * static_cast<double>(ping.sequence));
    const ScanningSonarPipeline pipeline({}, 1);
    const Scene scene = built(scan, 180).build(pipeline, scan.back(), {});
    EXPECT_NEAR(scene.sector_left.inDegrees(), -180.0, 1e-6);
    EXPECT_NEAR(scene.sector_right.inDegrees(), 180.0, 1e-6);
}

}  // namespace
}  // namespace echotrail
