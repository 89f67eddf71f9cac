#include "core/simulation/ping_model.hpp"

#include "core/simulation/echo_model.hpp"
#include "core/simulation/simulated_source.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace echotrail {
namespace {

/// Still water without an object, seen from a vehicle at rest.
Scenario stillWater() {
    Scenario scene;
    scene.gain_db = 30.0;
    return scene;
}

Scenario withTarget(double range_m, double bearing_deg) {
    Scenario scene = stillWater();
    scene.gain_db = 0.0;
    const double bearing = radiansFromDegrees(bearing_deg);
    scene.targets = {{.path = {{0, range_m * std::cos(bearing), range_m * std::sin(bearing)}}}};
    return scene;
}

struct Peak {
    std::uint64_t ping = 0;
    double range_m = 0.0;
    int level = -1;
};

/// The strongest bin beyond the ring-down, of all pings of a sweep.
Peak strongest(const Scenario& scene, std::uint64_t seed, std::uint64_t first_ping, std::uint64_t last_ping) {
    Peak peak;
    for (std::uint64_t number = first_ping; number <= last_ping; ++number) {
        const Ping ping = simulatePing(scene, seed, number);
        for (std::size_t i = 32; i < ping.levels.size(); ++i)
            if (ping.levels[i] > peak.level)
                peak = {number, (static_cast<double>(i) + 0.5) * ping.binSize(), ping.levels[i]};
    }
    return peak;
}

double meanLevelDb(const Ping& ping, double near_m, double far_m) {
    const auto first = static_cast<std::ptrdiff_t>(near_m / ping.binSize());
    const auto last = static_cast<std::ptrdiff_t>(far_m / ping.binSize());
    const int sum = std::accumulate(ping.levels.begin() + first, ping.levels.begin() + last, 0);
    return sum / levels_per_db / static_cast<double>(last - first);
}

TEST(PingModel, PingsFollowEachOtherByTheSoundsWayAndTheHeadsRest) {
    const Scenario scene;
    EXPECT_NEAR(pingInterval(scene), 100.0 / 1490.0 + 0.035, 1e-9);
    EXPECT_NEAR(secondsBetween(simulatePing(scene, 1, 0).time, simulatePing(scene, 1, 1000).time),
                1000.0 * pingInterval(scene), 1e-6);
}

TEST(PingModel, SectorIsScannedToAndFroWithEachEndOnce) {
    const Scenario scene;
    const auto degrees = [&](std::uint64_t number) { return pingBearing(scene, number).inDegrees(); };
    EXPECT_NEAR(degrees(0), -45.0, 1e-9);
    EXPECT_NEAR(degrees(49), 43.2, 1e-9);
    EXPECT_NEAR(degrees(50), 45.0, 1e-9);
    EXPECT_NEAR(degrees(51), 43.2, 1e-9);
    EXPECT_NEAR(degrees(100), -45.0, 1e-9);
    EXPECT_NEAR(degrees(101), -43.2, 1e-9);
    EXPECT_TRUE(simulatePing(scene, 1, 10).clockwise);
    EXPECT_FALSE(simulatePing(scene, 1, 60).clockwise);
}

TEST(PingModel, BinsCoverTheRangeScale) {
    const Ping ping = simulatePing(Scenario{}, 1, 0);
    EXPECT_EQ(ping.levels.size(), 800U);
    EXPECT_NEAR(ping.binSize() * 800.0, 50.0, 1e-9);
    EXPECT_NEAR(ping.step_rad, radiansFromDegrees(1.8), 1e-12);
}

TEST(PingModel, APingIsTheSameInWhateverOrderPingsAreMade) {
    const Scenario scene = withTarget(20.0, 0.0);
    const Ping alone = simulatePing(scene, 3, 26);
    for (std::uint64_t number = 0; number < 26; ++number) simulatePing(scene, 3, number);
    EXPECT_EQ(simulatePing(scene, 3, 26), alone);
}

TEST(PingModel, WhatAModelRemembersChangesNothing) {
    for (const char* name : {"S1", "S2", "S3"}) {  // rock, debris with shadows, a bottom that rises and falls
        const Scenario scene = *findScenario(name);
        EchoModel model(scene, 3);
        for (const std::uint64_t number : {500, 20, 21, 5000, 20})
            EXPECT_EQ(simulatePing(scene, model, number), simulatePing(scene, 3, number)) << name << " " << number;
        HeadSetup other;
        other.range_m = 30.0;
        other.bins = 500;
        other.bin_interval_s = 2.0 * 30.0 / 1490.0 / 500;
        EXPECT_EQ(model.echo(other, 7.0, 3), simulateEcho(scene, 3, other, 7.0, 3)) << name;
        EXPECT_EQ(simulatePing(scene, model, 21), simulatePing(scene, 3, 21)) << name;
    }
}

TEST(PingModel, TargetsEchoIsAtItsRangeAndBearing) {
    for (const double range_m : {12.0, 25.0, 40.0})
        for (const double bearing_deg : {-36.0, 0.0, 27.0}) {
            const Scenario scene = withTarget(range_m, bearing_deg);
            const Peak peak = strongest(scene, 5, 0, 50);
            EXPECT_NEAR(peak.range_m, range_m, 0.5);
            EXPECT_NEAR(pingBearing(scene, peak.ping).inDegrees(), bearing_deg, 2.0);
        }
}

TEST(PingModel, EchoOfAMovingTargetIsWhereItIsWhenTheSoundMeetsIt) {
    Scenario scene = withTarget(20.0, 0.0);
    scene.targets[0].path = {{0, 40, 0}, {10, 10, 0}};  // 3 m/s towards the head
    scene.targets[0].size_m = 0.2;
    for (const std::uint64_t number : {25U, 75U}) {  // the two pings straight ahead
        const double met_s = pingTime(scene, number) + 0.5 * (pingInterval(scene) - 0.035);
        EXPECT_NEAR(strongest(scene, 5, number, number).range_m, targetMotion(scene.targets[0], met_s).position_m.x(),
                    0.2);
    }
}

TEST(PingModel, BearingsTurnWithTheVehicle) {
    Scenario scene = withTarget(20.0, 10.0);
    scene.vehicle = {.yaw_amplitude_deg = 10.0, .yaw_period_s = 4.0 * pingTime(scene, 25)};  // +10 deg at ping 25
    EXPECT_NEAR(pingBearing(scene, strongest(scene, 5, 15, 35).ping).inDegrees(), 0.0, 2.0);
}

TEST(PingModel, TargetFadesWithTheBeamsPattern) {
    const Scenario scene = withTarget(20.0, 0.0);
    double on_axis = 0.0, half_width_off = 0.0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {  // ping 25 looks straight at it, ping 26 is 1.8 deg off
        on_axis += strongest(scene, seed, 25, 25).level;
        half_width_off += strongest(scene, seed, 26, 26).level;
    }
    const double two_way_db = 2.0 * 10.0 * std::log10(2.0) * (2.0 * 1.8 / 3.0) * (2.0 * 1.8 / 3.0);
    EXPECT_NEAR((on_axis - half_width_off) / 200.0 / levels_per_db, two_way_db, 1.0);
}

TEST(PingModel, ReverberationIsSingleLookSpeckle) {
    // The log of an exponential power has a deviation of 5.57 dB. Few bins, so that the mean is the same in all.
    const Scenario scene = stillWater();
    double sum = 0.0, squares = 0.0;
    int count = 0;
    for (std::uint64_t number = 0; number < 300; ++number) {
        const Ping ping = simulatePing(scene, 9, number);
        for (std::size_t i = 480; i < 500; ++i, ++count) {
            const double db = ping.levels[i] / levels_per_db;
            sum += db;
            squares += db * db;
        }
    }
    const double mean = sum / count;
    EXPECT_GT(mean, 20.0);  // clipping at level 0 would narrow it
    EXPECT_NEAR(std::sqrt(squares / count - mean * mean), 5.57, 0.3);
}

/// Correlation of the levels of neighbouring bins that have the same mean over many pings.
double likenessOfNeighbours(const Scenario& scene) {
    constexpr int count = 3000;
    double sum = 0.0, product = 0.0, square = 0.0;
    for (std::uint64_t number = 0; number < count; ++number) {
        const auto levels = simulateEcho(scene, 9, HeadSetup{}, 0.0, number);
        const double first = levels[480], second = levels[481];
        sum += (first + second) / 2.0;
        product += first * second;
        square += (first * first + second * second) / 2.0;
    }
    const double mean_square = sum / count * sum / count;
    return (product / count - mean_square) / (square / count - mean_square);
}

TEST(PingModel, NeighbouringBinsAreAlikeByTheLengthOfThePulse) {
    Scenario scene = stillWater();
    scene.pulse_us = 0.0;
    EXPECT_NEAR(likenessOfNeighbours(scene), 0.0, 0.06);
    scene.pulse_us = 400.0;  // nearly 5 bins: (1 - 1/4.8)^2 = 0.63 of powers
    EXPECT_GT(likenessOfNeighbours(scene), 0.45);
}

TEST(PingModel, SeveralLooksNarrowTheSpeckle) {
    Scenario scene = stillWater();
    const auto spread = [&] {
        double sum = 0.0, squares = 0.0;
        for (std::uint64_t number = 0; number < 2000; ++number) {
            const double db = simulateEcho(scene, 9, HeadSetup{}, 0.0, number)[490] / levels_per_db;
            sum += db / 2000.0;
            squares += db * db / 2000.0;
        }
        return std::sqrt(squares - sum * sum);
    };
    EXPECT_NEAR(spread(), 5.57, 0.3);
    scene.looks = 4;
    EXPECT_NEAR(spread(), 2.31, 0.2);  // 4.343 sqrt(trigamma(4))
}

TEST(PingModel, TransducerRingsInTheFirstMetreOnly) {
    const Ping ping = simulatePing(Scenario{}, 1, 0);
    EXPECT_EQ(ping.levels[0], std::lround(255.0 * (1.0 - 0.5 / 16.0)));
    EXPECT_GT(meanLevelDb(ping, 0.0, 0.5), 50.0);
    EXPECT_LT(meanLevelDb(ping, 1.1, 2.0), 5.0);
}

TEST(PingModel, BottomIsHeardFromItsDistanceOn) {
    Scenario scene = stillWater();
    scene.surface_strength_db = -200.0;
    scene.bottom_strength_db = 20.0;
    scene.altitude_m = 5.0;
    const Ping ping = simulatePing(scene, 1, 0);
    EXPECT_GT(meanLevelDb(ping, 5.5, 7.0), meanLevelDb(ping, 3.0, 4.5) + 10.0);
}

TEST(Echo, HasTheBinsAskedForOverTheRangeAskedFor) {
    HeadSetup head;
    head.range_m = 20.0;
    head.bins = 300;
    head.bin_interval_s = 2.0 * head.range_m / head.sound_speed / head.bins;
    const Scenario scene = withTarget(12.0, 0.0);
    const auto levels = simulateEcho(scene, 1, head, 5.0, 0);
    ASSERT_EQ(levels.size(), 300U);
    const auto strongest = std::max_element(levels.begin() + 60, levels.end()) - levels.begin();
    EXPECT_NEAR((static_cast<double>(strongest) + 0.5) * head.binSize(), 12.0, 0.5);
}

TEST(Echo, HeadsGainAddsToTheScenarios) {
    Scenario scene = stillWater();
    HeadSetup louder;
    louder.gain_db += 10.0;
    const auto raised = simulateEcho(scene, 1, louder, 0.0, 0);
    scene.gain_db += 10.0;
    EXPECT_EQ(raised, simulateEcho(scene, 1, HeadSetup{}, 0.0, 0));
}

TEST(PingModel, GainRaisesEveryLevelAlike) {
    Scenario scene = stillWater();
    const double before = meanLevelDb(simulatePing(scene, 1, 0), 30.0, 40.0);
    scene.gain_db += 10.0;
    EXPECT_NEAR(meanLevelDb(simulatePing(scene, 1, 0), 30.0, 40.0) - before, 10.0, 0.2);
}

}  // namespace
}  // namespace echotrail
