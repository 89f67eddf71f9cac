#include "core/simulation/scenario.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

TEST(TargetMotion, GoesRoundAClosedPathWithoutJumps) {
    const SimulatedTarget round{.path = {{-5, 0, 0}, {5, 10, 0}, {12, 10, 10}, {25, 0, 0}}, .loop = true};
    for (double t = -40.0; t < 80.0; t += 0.5) {
        const TargetMotion now = targetMotion(round, t), later = targetMotion(round, t + 30.0);
        EXPECT_LT((now.position_m - later.position_m).norm(), 1e-9) << t;
        const Eigen::Vector2d before = targetMotion(round, t - 1e-4).position_m;
        const Eigen::Vector2d after = targetMotion(round, t + 1e-4).position_m;
        EXPECT_LT((now.velocity_mps - (after - before) / 2e-4).norm(), 2e-3) << t;
    }
}

TEST(VehicleThatFollows, BeginsAtTheOriginAndStaysBehindItsTarget) {
    for (const char* name : {"S1", "S2", "S3", "S4", "S5"}) {
        const Scenario& scene = named(name);
        double range_sum = 0.0;
        int count = 0;
        VehicleState before = vehicleState(scene, 0.0);
        EXPECT_NEAR(std::hypot(before.pose.north_m, before.pose.east_m), 0.0, 0.01);
        for (double t = 0.5; t < scene.duration_s; t += 0.5, ++count) {
            const VehicleState now = vehicleState(scene, t);
            const TargetMotion target = targetMotion(scene.targets[0], t);
            const Eigen::Vector2d way = target.position_m - Eigen::Vector2d(now.pose.north_m, now.pose.east_m);
            range_sum += way.norm();
            ASSERT_LT(std::abs(now.pose.heading - before.pose.heading), radiansFromDegrees(2.5)) << name << t;
            ASSERT_LT(std::abs(Bearing::radians(std::atan2(way.y(), way.x())) - now.pose.heading),
                      radiansFromDegrees(44.0))
                << name << t;
            ASSERT_LT(now.over_ground_mps.norm(), 1.0) << name;
            ASSERT_GT(target.velocity_mps.norm(), 0.1) << name << t;
            ASSERT_LT(target.velocity_mps.norm(), 0.7) << name << t;
            before = now;
        }
        EXPECT_NEAR(range_sum / count, 20.0, 3.0) << name;
    }
}

TEST(VehicleInACurrent, MovesThroughTheWaterByWhatTheCurrentDoesNotGive) {
    Scenario scene;
    scene.vehicle = {.speed_mps = 0.5, .current_east_mps = 0.5, .crab_share = 1.0};
    const VehicleState state = vehicleState(scene, 3.0);
    EXPECT_TRUE(state.over_ground_mps.isApprox(Eigen::Vector2d(0.5, 0.0)));
    EXPECT_TRUE(state.through_water_mps.isApprox(Eigen::Vector2d(0.5, -0.5)));
    EXPECT_NEAR(state.pose.heading.inDegrees(), -45.0, 1e-9);
}

TEST(DebrisField, IsStrewnBySeedWithinItsBounds) {
    const Scenario& scene = named("S2");
    const auto first = allDebris(scene, 1), again = allDebris(scene, 1), other = allDebris(scene, 2);
    ASSERT_EQ(first.size(), 25U);
    EXPECT_EQ(first.back().north_m, again.back().north_m);
    EXPECT_NE(first.back().north_m, other.back().north_m);
    const DebrisField& field = scene.debris_fields.at(0);
    for (std::size_t i = scene.debris.size(); i < first.size(); ++i) {
        EXPECT_GE(first[i].north_m, field.south_m);
        EXPECT_LE(first[i].north_m, field.north_m);
        EXPECT_GE(first[i].strength_db, field.weakest_db);
        EXPECT_LE(first[i].size_m, field.largest_m);
    }
}

TEST(Demonstration, BringsItsTargetFromFortyMetresToTwelveAtASteadyPace) {
    const Scenario& scene = named("demonstration");
    const auto range = [&](double t) {
        const Pose vehicle = vehiclePose(scene, t);
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
