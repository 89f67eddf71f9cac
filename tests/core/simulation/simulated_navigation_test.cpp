#include "core/simulation/simulated_navigation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace echotrail {
namespace {

/// Going north at 0.5 m/s, the bow swaying.
Scenario underWay() {
    Scenario scene;
    scene.vehicle = {.speed_mps = 0.5, .yaw_amplitude_deg = 5.0, .yaw_period_s = 20.0};
    return scene;
}

TEST(SimulatedNavigation, IsTheTruthWithoutErrors) {
    const Scenario scene = underWay();
    SimulatedNavigation navigation(scene, 1);
    for (int i = 0; i < 100; ++i) {
        const NavigationSample sample = navigation.next();
        EXPECT_NEAR(sample.time_s, 0.05 * i, 1e-12);
        EXPECT_EQ(sample.pose, vehiclePose(scene, sample.time_s));
        EXPECT_EQ(sample.over_ground_mps, Eigen::Vector2d(0.5, 0.0));
        EXPECT_EQ(sample.depth_m, 5.0);
    }
}

TEST(SimulatedNavigation, HeadingHasItsBiasAndItsNoise) {
    Scenario scene = underWay();
    scene.navigation = {.heading_bias_deg = 0.5, .heading_noise_deg = 0.2};
    SimulatedNavigation navigation(scene, 1);
    double sum = 0.0, squares = 0.0;
    constexpr int count = 4000;
    for (int i = 0; i < count; ++i) {
        const NavigationSample sample = navigation.next();
        const double error = degreesFromRadians(sample.pose.heading - vehiclePose(scene, sample.time_s).heading);
        sum += error;
        squares += error * error;
    }
    EXPECT_NEAR(sum / count, 0.5, 0.02);
    EXPECT_NEAR(std::sqrt(squares / count - sum / count * sum / count), 0.2, 0.02);
}

TEST(SimulatedNavigation, AVelocityErrorBecomesAPositionErrorThatFixesHold) {
    Scenario scene;
    scene.navigation = {.velocity_bias_mps = 0.02, .position_hold_s = 60.0};
    SimulatedNavigation navigation(scene, 1);
    for (int i = 0; i < 100; ++i) navigation.next();  // 5 s
    EXPECT_NEAR(navigation.next().pose.north_m, 60.0 * 0.02 * (1.0 - std::exp(-5.0 / 60.0)), 1e-3);
    for (int i = 0; i < 20'000; ++i) navigation.next();
    EXPECT_NEAR(navigation.next().pose.north_m, 1.2, 0.01);
}

TEST(SimulatedNavigation, PosesAreAsOldAsItsLatency) {
    Scenario scene = underWay();
    scene.navigation = {.least_latency_s = 0.02, .most_latency_s = 0.05};
    SimulatedNavigation navigation(scene, 1);
    for (int i = 0; i < 200; ++i) {
        const NavigationSample sample = navigation.next();
        const double age_s = sample.time_s - sample.pose.north_m / 0.5;
        EXPECT_GE(age_s, 0.02 - 1e-9);
        EXPECT_LE(age_s, 0.05 + 1e-9);
    }
}

TEST(SimulatedNavigation, SameSeedTellsTheSame) {
    Scenario scene = underWay();
    scene.navigation = {.heading_noise_deg = 1.0, .velocity_noise_mps = 0.1};
    SimulatedNavigation first(scene, 7), again(scene, 7), other(scene, 8);
    for (int i = 0; i < 10; ++i) {
        const Pose pose = first.next().pose;
        EXPECT_EQ(pose, again.next().pose);
        EXPECT_FALSE(pose == other.next().pose);
    }
}

}  // namespace
}  // namespace echotrail
