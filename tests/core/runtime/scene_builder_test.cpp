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

TEST(SceneBuilder, TellsForHowLongEchoesHaveBeenLeftOut) {
    auto scan = test::sectorScan(40);
    FanImage fan{cv::Mat(4, 4, CV_8U, cv::Scalar(1)), cv::Mat(4, 4, CV_32S, cv::Scalar(0))};
    EXPECT_EQ(built(scan, 21).build(fan, {}, scan.back(), {}).picture_age_s, 0.0);
    for (std::size_t i = 30; i < scan.size(); ++i) scan[i].levels.clear();
    EXPECT_NEAR(built(scan, 21).build(fan, {}, scan.back(), {}).picture_age_s, 10 * 0.05, 1e-9);
}

TEST(SceneBuilder, AFullTurnReachesAllBearings) {
    auto scan = test::sectorScan(400);
    for (Ping& ping : scan) ping.bearing = Bearing::degrees(100.0 + 2.0 * static_cast<double>(ping.sequence));
    const ScanningSonarPipeline pipeline({}, 1);
    const Scene scene = built(scan, 180).build(pipeline, scan.back(), {});
    EXPECT_NEAR(scene.sector_left.inDegrees(), -180.0, 1e-6);
    EXPECT_NEAR(scene.sector_right.inDegrees(), 180.0, 1e-6);
}

TEST(SceneBuilder, TellsTheTurnFromTheBearingsNotFromTheHead) {
    auto scan = test::sectorScan(10);
    for (Ping& ping : scan) ping.clockwise = false;  // as an inverted head sees it
    const ScanningSonarPipeline pipeline({}, 1);
    EXPECT_TRUE(built(scan, 21).build(pipeline, scan.back(), {}).turns_clockwise);
}

TEST(SceneBuilder, KeepsTheLastLineOfEachBearingWithItsThreshold) {
    const auto scan = test::sectorScan(3 * 21);
    ScanningSonarPipeline pipeline({}, 1);
    SceneBuilder builder;
    for (const Ping& ping : scan) builder.add(ping, pipeline.process(ping, {}), 0.0, pipeline);
    const Scene scene = builder.build(pipeline, scan.back(), {});
    ASSERT_NE(scene.live_line, nullptr);
    EXPECT_NEAR(scene.live_line->from_bow.inDegrees(), 20.0, 1e-6);
    ASSERT_EQ(scene.lines.size(), 360U);
    const auto ahead = scene.lines[180 + 4];
    ASSERT_NE(ahead, nullptr);
    EXPECT_GT(ahead->time, scan[2 * 21].time) << "the third sweep's, not the first's";
    ASSERT_EQ(ahead->threshold.size(), ahead->level.size());
    const auto cell = static_cast<std::size_t>((300 - 0.1 * 54) * 20.0 / 400.0 / ahead->cell_m);
    EXPECT_GT(ahead->level[cell], ahead->threshold[cell]) << "the target";
    EXPECT_LT(ahead->level[cell / 2], ahead->threshold[cell / 2]);
    EXPECT_EQ(ahead->threshold[0], BeamLine::never) << "the transducer rings there";
    EXPECT_EQ(scene.lines[0], nullptr) << "outside the sector";
}

TEST(SceneBuilder, RemembersEarlierSweepsAndPaths) {
    const auto scan = test::sectorScan(4 * 21);
    ScanningSonarPipeline pipeline({}, 1);
    SceneBuilder builder;
    for (const Ping& ping : scan) builder.add(ping, pipeline.process(ping, {}), 0.0, pipeline);
    const Scene scene = builder.build(pipeline, scan.back(), {});
    ASSERT_NE(scene.remembered, nullptr);
    double looks = 0.0;
    cv::minMaxLoc(scene.remembered->looks, nullptr, &looks);
    EXPECT_GE(looks, 3.0);
    ASSERT_NE(scene.paths, nullptr);
    EXPECT_GE(scene.paths->vehicle.size(), 3U);
    EXPECT_FALSE(scene.course) << "it lies still";
}

TEST(SceneBuilder, ALineWithoutDetectionHasItsLevelsAndNoThreshold) {
    Ping ping = test::sectorScan(1).front();
    ping.levels.assign(1001, 40);
    const BeamLine line = lineOf(ping, {});
    EXPECT_EQ(line.level.size(), 400U);
    EXPECT_EQ(line.level[399], 40);
    EXPECT_NEAR(line.cell_m * 400.0, ping.binSize() * 1001.0, 1e-9);
    EXPECT_TRUE(line.threshold.empty());
}

}  // namespace
}  // namespace echotrail
