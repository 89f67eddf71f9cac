#include "core/simulation/ping_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace echotrail {
namespace {

/// Sand 2.5 m below with patches, averaged so much that speckle hides nothing of them.
Scenario patchyBottom() {
    Scenario scene;
    scene.gain_db = 30.0;
    scene.altitude_m = 2.5;
    scene.bottom_strength_db = -10.0;
    scene.bottom_texture = 0.7;
    scene.looks = 16;
    return scene;
}

double meanOf(const std::vector<std::uint8_t>& levels, std::size_t from, std::size_t to) {
    return std::accumulate(levels.begin() + static_cast<std::ptrdiff_t>(from),
                           levels.begin() + static_cast<std::ptrdiff_t>(to), 0.0) /
           static_cast<double>(to - from);
}

double correlation(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    const double mean_a = meanOf(a, 200, 700), mean_b = meanOf(b, 200, 700);
    double ab = 0.0, aa = 0.0, bb = 0.0;
    for (std::size_t i = 200; i < 700; ++i) {
        ab += (a[i] - mean_a) * (b[i] - mean_b);
        aa += (a[i] - mean_a) * (a[i] - mean_a);
        bb += (b[i] - mean_b) * (b[i] - mean_b);
    }
    return ab / std::sqrt(aa * bb);
}

TEST(SceneEcho, AStandingVehicleSeesTheSamePatchesInTheNextSweep) {
    const Scenario scene = patchyBottom();
    const auto first = simulatePing(scene, 1, 20).levels, next = simulatePing(scene, 1, 120).levels;
    EXPECT_NE(first, next);
    EXPECT_GT(correlation(first, next), 0.7);
    EXPECT_LT(correlation(first, simulatePing(scene, 2, 20).levels), 0.3);
}

TEST(SceneEcho, PatchesStayWhereTheyAreWhenTheVehicleGoesOn) {
    Scenario scene = patchyBottom();
    scene.vehicle.speed_mps = 1.0;
    const HeadSetup head;
    const auto before = simulateEcho(scene, 1, head, 0.0, 0), after = simulateEcho(scene, 1, head, 4.0, 1);
    std::vector<std::uint8_t> shifted(after.size());  // 4 m nearer: 64 bins of 1/16 m
    std::copy(after.begin(), after.end() - 64, shifted.begin() + 64);
    EXPECT_GT(correlation(before, shifted), 0.5);
    EXPECT_LT(correlation(before, after), 0.3);
}

TEST(SceneEcho, DebrisCastsAShadow) {
    Scenario scene = patchyBottom();
    scene.bottom_texture = 0.0;
    scene.debris = {{.north_m = 15, .size_m = 1.0, .strength_db = -20}};  // hides the bottom from 15 to 25 m
    const HeadSetup head;
    const double lit = meanOf(simulateEcho(scene, 1, head, 0.0, 0), 280, 380);
    scene.shadows = true;
    EXPECT_LT(meanOf(simulateEcho(scene, 1, head, 0.0, 0), 280, 380), lit - 3.0 * levels_per_db);
    HeadSetup aside;
    aside.bearing = Bearing::degrees(10);
    EXPECT_NEAR(meanOf(simulateEcho(scene, 1, aside, 0.0, 0), 280, 380), lit, 1.0 * levels_per_db);
}

TEST(SceneEcho, TheHighChannelHasTheNarrowerBeam) {
    Scenario scene;
    scene.targets = {{.path = {{0, 20, 0}}, .strength_db = 0.0}};
    const auto peakAt = [&](double frequency_hz, double degrees) {
        double sum = 0.0;
        for (std::uint64_t number = 0; number < 50; ++number) {
            HeadSetup head;
            head.frequency_hz = frequency_hz;
            head.bearing = Bearing::degrees(degrees);
            sum += meanOf(simulateEcho(scene, number, head, 0.0, number), 318, 322) / levels_per_db / 50.0;
        }
        return sum;
    };
    EXPECT_NEAR(peakAt(325e3, 0.0) - peakAt(325e3, 1.5), 6.0, 0.5);
    EXPECT_NEAR(peakAt(675e3, 0.0) - peakAt(675e3, 1.5), 24.1, 0.5);
}

TEST(SceneEcho, TheTargetStandsOutFromTheBottomByTimeVariedGainAtEveryRange) {
    for (const double range_m : {10.0, 25.0, 45.0}) {
        Scenario scene;
        scene.targets = {{.path = {{0, range_m, 0}}, .strength_db = -10.0}};
        double sum = 0.0;
        const auto bin = static_cast<std::size_t>(range_m * 16.0);
        for (std::uint64_t number = 0; number < 100; ++number)
            sum += simulateEcho(scene, number, HeadSetup{}, 0.0, number)[bin] / levels_per_db / 100.0;
        EXPECT_NEAR(sum, 50.0 - 2.5 - 1.2, 1.0) << range_m;  // in the mean of dB, speckle takes 2.5, shape 2 takes 1.2
    }
}

TEST(SceneEcho, AnyHeadSettingGivesItsBins) {
    const Scenario& scene = scenarios().front();
    for (const double range_m : {2.0, 50.0, 450.0})
        for (const int bins : {0, 1, 200, 1500})
            for (const double frequency_hz : {0.0, 325e3, 675e3}) {
                HeadSetup head;
                head.range_m = range_m;
                head.bins = bins;
                head.bin_interval_s = 2.0 * range_m / head.sound_speed / std::max(bins, 1);
                head.frequency_hz = frequency_hz;
                for (const double time_s : {-1.0, 0.0, 1e6})
                    EXPECT_EQ(simulateEcho(scene, 1, head, time_s, 7).size(), static_cast<std::size_t>(bins));
            }
}

}  // namespace
}  // namespace echotrail
