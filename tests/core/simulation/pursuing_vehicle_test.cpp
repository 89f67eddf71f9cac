#include "core/simulation/pursuing_vehicle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace echotrail {
namespace {

/// Tells the vehicle ten times a second of a target where it truly is; gives the range at the end.
double follow(PursuingVehicle& vehicle, Eigen::Vector2d start, Eigen::Vector2d velocity, double seconds) {
    double range = 0;
    for (double t = 0.1; t < seconds; t += 0.1) {
        vehicle.moveTo(t);
        const Pose own = vehicle.path()->at(t).pose;
        const Eigen::Vector2d sight = start + t * velocity - Eigen::Vector2d(own.north_m, own.east_m);
        range = sight.norm();
        const Bearing from_bow = Bearing::radians(std::atan2(sight.y(), sight.x()) - own.heading.inRadians());
        vehicle.hear({.valid = true, .range_m = range, .from_bow = from_bow, .velocity_mps = velocity}, t);
    }
    return range;
}

TEST(PursuingVehicle, WaitsUntilItHearsOfATarget) {
    Scenario scenario;
    scenario.vehicle.current_east_mps = 0.4;
    PursuingVehicle vehicle({}, scenario);
    vehicle.moveTo(10);
    EXPECT_EQ(vehicle.path()->at(10).pose, Pose{});
    vehicle.hear({.valid = false, .range_m = 50}, 10);
    vehicle.moveTo(20);
    EXPECT_EQ(vehicle.path()->at(20).pose, Pose{});
}

TEST(PursuingVehicle, KeepsItsRangeToATargetThatGoesAwayAsideOrInACurrent) {
    using Velocity = Eigen::Vector2d;
    for (const Velocity& velocity : {Velocity(0.4, 0), Velocity(0, 0.4), Velocity(-0.1, 0.3)})
        for (const double current : {0.0, 0.3}) {
            Scenario scenario;
            scenario.vehicle.current_north_mps = -current;
            PursuingVehicle vehicle({}, scenario);
            EXPECT_NEAR(follow(vehicle, {30, 5}, velocity, 400), 20, 1.0) << velocity.transpose() << " " << current;
        }
}

TEST(PursuingVehicle, KeepsToItsLimits) {
    const PursuitParams params;
    PursuingVehicle vehicle(params, {});
    follow(vehicle, {-60, 40}, {0, 0}, 60);
    VehiclePath::Moment last = vehicle.path()->at(0);
    for (double t = 0.05; t < 60; t += 0.05) {
        const VehiclePath::Moment now = vehicle.path()->at(t);
        EXPECT_LE(now.over_ground_mps.norm(), params.vehicle_top_speed_mps + 1e-9);
        EXPECT_LE(std::abs(now.pose.heading - last.pose.heading),
                  radiansFromDegrees(params.vehicle_turn_rate_deg) * 0.05 + 1e-9);
        EXPECT_LE(std::abs(now.over_ground_mps.norm() - last.over_ground_mps.norm()),
                  params.vehicle_acceleration_mps2 * 0.05 + 1e-9);
        last = now;
    }
}

TEST(PursuingVehicle, StopsAndKeepsItsHeadingWhenItHearsNoMore) {
    PursuingVehicle vehicle({}, {});
    follow(vehicle, {40, 10}, {0.3, 0.1}, 60);
    EXPECT_GT(vehicle.path()->at(60).over_ground_mps.norm(), 0.2);
    vehicle.moveTo(90);
    EXPECT_LT(vehicle.path()->at(90).over_ground_mps.norm(), 1e-9);
    EXPECT_EQ(vehicle.path()->at(90).pose.heading, vehicle.path()->at(70).pose.heading);
}

TEST(SteeringReport, IsReadFromAReportAndNothingElse) {
    const std::string line = R"({"time":"2026-01-01T00:00:00Z","state":"confirmed","range_m":21.5,"bearing_deg":-12.5,)"
                             R"("velocity_north_mps":0.25,"velocity_east_mps":-0.5,"age_s":0.4,"valid":true})";
    const auto report = readSteeringReport(line);
    ASSERT_TRUE(report) << report.error();
    EXPECT_TRUE(report->valid);
    EXPECT_EQ(report->range_m, 21.5);
    EXPECT_NEAR(report->from_bow.inDegrees(), -12.5, 1e-12);
    EXPECT_EQ(report->velocity_mps, Eigen::Vector2d(0.25, -0.5));
    for (const std::string other :
         {"", "{}", "[1]", "nonsense", R"({"valid":true})", R"({"valid":1,"range_m":2,"bearing_deg":3})"})
        EXPECT_FALSE(readSteeringReport(other)) << other;
    for (const char* bad : {"-1", "1e9", "null", "\"20\"", "1e400"}) {
        std::string changed = line;
        changed.replace(changed.find("21.5"), 4, bad);
        EXPECT_FALSE(readSteeringReport(changed)) << bad;
    }
}

TEST(VehiclePath, IsStraightBetweenMomentsWaitsBeforeAndGoesOnAfter) {
    VehiclePath path;
    path.add({1, {0, 0, Bearing::degrees(170)}, {1, 0}});
    path.add({2, {1, 0, Bearing::degrees(-170)}, {3, 0}});
    EXPECT_EQ(path.at(0).pose, (Pose{0, 0, Bearing::degrees(170)}));
    EXPECT_EQ(path.at(0).over_ground_mps.norm(), 0);
    EXPECT_NEAR(path.at(1.5).pose.north_m, 0.5, 1e-12);
    EXPECT_NEAR(std::abs(path.at(1.5).pose.heading.inDegrees()), 180, 1e-9);
    EXPECT_NEAR(path.at(1.5).over_ground_mps.x(), 2, 1e-12);
    EXPECT_NEAR(path.at(4).pose.north_m, 7, 1e-12);
}

}  // namespace
}  // namespace echotrail
