#include "core/simulation/scenario.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace echotrail {
namespace {

const SimulatedTarget bent{.path = {{0, 10, 0}, {10, 14, 0}, {30, 14, 8}}};

const Scenario& named(std::string_view name) {
    return *std::find_if(scenarios().begin(), scenarios().end(), [&](const Scenario& s) { return s.name == name; });
}

TEST(TargetMotion, PassesThroughItsWaypoints) {
    for (const Waypoint& w : bent.path)
        EXPECT_TRUE(targetMotion(bent, w.time_s).position_m.isApprox(Eigen::Vector2d(w.north_m, w.east_m)));
}

TEST(TargetMotion, VelocityIsTheChangeOfPlaceAndHasNoJumps) {
    for (double t = 0.5; t < 30.0; t += 0.5) {
        const Eigen::Vector2d before = targetMotion(bent, t - 1e-4).position_m;
        const Eigen::Vector2d after = targetMotion(bent, t + 1e-4).position_m;
        EXPECT_LT((targetMotion(bent, t).velocity_mps - (after - before) / 2e-4).norm(), 1e-4) << t;
    }
}

TEST(TargetMotion, RestsBeforeItsFirstAndAfterItsLastWaypoint) {
    EXPECT_EQ(targetMotion(bent, -1.0).velocity_mps, Eigen::Vector2d(0, 0));
    EXPECT_EQ(targetMotion(bent, 31.0).velocity_mps, Eigen::Vector2d(0, 0));
    EXPECT_EQ(targetMotion(bent, 31.0).position_m, Eigen::Vector2d(14, 8));
}

TEST(Demonstration, BringsItsTargetFromFortyMetresToTwelveAtASteadyPace) {
    const Scenario& scene = named("demonstration");
    const auto range = [&](double t) {
        const Pose vehicle = vehiclePose(scene.vehicle, t);
        return (targetMotion(scene.targets[0], t).position_m - Eigen::Vector2d(vehicle.north_m, vehicle.east_m)).norm();
    };
    EXPECT_NEAR(range(0.0), 40.0, 1.0);
    EXPECT_NEAR(range(scene.duration_s), 12.0, 1.0);
    for (double t = 0.0; t < scene.duration_s; t += 1.0) {
        EXPECT_GT(targetMotion(scene.targets[0], t).velocity_mps.norm(), 0.25) << t;
        EXPECT_LT(targetMotion(scene.targets[0], t).velocity_mps.norm(), 0.55) << t;
    }
}

TEST(EmptyScenario, HoldsNoObject) {
    EXPECT_TRUE(named("empty").targets.empty());
    EXPECT_TRUE(named("empty").debris.empty());
}

}  // namespace
}  // namespace echotrail
