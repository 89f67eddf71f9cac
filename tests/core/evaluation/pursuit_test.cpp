#include "core/evaluation/pursuit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace echotrail {
namespace {

/// A strong target that goes round slowly in deep clean water, and a vehicle at rest 25 m behind it.
Scenario roundabout(double seconds) {
    Scenario scenario;
    scenario.name = "roundabout";
    scenario.duration_s = seconds;
    scenario.water_depth_m = 60;
    scenario.altitude_m = 40;
    scenario.targets.push_back({.path = {{0, 25, 0}, {60, 40, 15}, {120, 40, 35}, {180, 25, 45}}, .strength_db = 5});
    return scenario;
}

ScanningSonarPipeline::Params following(bool on) {
    ScanningSonarPipeline::Params params;
    params.follow.follow_target = on;
    return params;
}

TEST(Pursuit, TheVehicleKeepsItsRangeByReportsAlone) {
    for (const bool on : {false, true}) {
        const PursuitResult result = runPursuit(roundabout(180), following(on), {}, 1);
        EXPECT_EQ(result.picks, 1);
        EXPECT_GT(result.valid, 800u);
        const auto& samples = result.record.samples();
        ASSERT_GT(samples.size(), 1700u);
        for (std::size_t i = samples.size() / 2; i < samples.size(); ++i)
            EXPECT_NEAR(samples[i].range_m(), 20, 4) << samples[i].time_s;
        const auto figures = result.record.figures();
        ASSERT_TRUE(figures);
        EXPECT_LE(figures->mean_m, figures->percentile_95_m);
        EXPECT_LE(figures->percentile_95_m, figures->greatest_m);
    }
}

TEST(Pursuit, AHeadThatFollowsLooksSeveralTimesAsOften) {
    const PursuitResult open = runPursuit(roundabout(120), following(false), {}, 1);
    const PursuitResult closed = runPursuit(roundabout(120), following(true), {}, 1);
    EXPECT_GT(closed.looks, 2 * open.looks);
    EXPECT_LE(closed.pings, open.pings) << "the same head";
}

TEST(Pursuit, SameSeedSamePaths) {
    const auto paths = [](std::uint64_t seed) {
        return runPursuit(roundabout(60), following(true), {}, seed).record.csv();
    };
    EXPECT_EQ(paths(3), paths(3));
    EXPECT_NE(paths(3), paths(4));
}

TEST(Pursuit, WithoutAnythingToFollowTheVehicleStaysAndThereAreNoFigures) {
    Scenario scenario = roundabout(60);
    scenario.targets[0].strength_db = -80;
    const PursuitResult result = runPursuit(scenario, following(true), {}, 1);
    EXPECT_EQ(result.valid, 0u);
    EXPECT_FALSE(result.record.figures());
    EXPECT_EQ(result.record.samples().back().vehicle, result.record.samples().front().vehicle);
    EXPECT_GE(result.picks, 2) << "the operator points again";
}

TEST(PursuitRecord, FiguresCountFromWhereTheVehicleIsSteered) {
    Scenario scenario;
    scenario.targets.push_back({.path = {{0, 30, 0}}});
    PursuitRecord record(20);
    record.take(scenario, 0.95, false);
    EXPECT_FALSE(record.figures());
    record.take(scenario, 1.95, true);
    ASSERT_TRUE(record.figures());
    EXPECT_NEAR(record.figures()->seconds, 1.0, 1e-9);
    EXPECT_NEAR(record.figures()->mean_m, 10, 1e-9);
    EXPECT_FALSE(record.figuresSinceReached()) << "it is 30 m away all the time";
    const std::string csv = record.csv();
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 21);
    EXPECT_NE(csv.find("\n1.5,0.000,0.000,0.000,30.000,0.000,30.000,1\n"), std::string::npos) << csv;
    EXPECT_NE(record.svg("a title").find("<polyline"), std::string::npos);
}

}  // namespace
}  // namespace echotrail
