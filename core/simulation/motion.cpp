#include "core/base/random.hpp"
#include "core/simulation/scenario.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace echotrail {

namespace {

constexpr std::uint64_t debris_numbers = 2;

Eigen::Vector2d placeOf(const Waypoint& waypoint) { return {waypoint.north_m, waypoint.east_m}; }

double directionOf(const Eigen::Vector2d& way) { return std::atan2(way.y(), way.x()); }

/// Velocity at a waypoint: that from its neighbour before to its neighbour after (Catmull–Rom). Where the path closes,
/// its ends are one waypoint.
Eigen::Vector2d velocityAt(const SimulatedTarget& target, std::size_t i) {
    const auto& path = target.path;
    const std::size_t last = path.size() - 1;
    if (target.loop && (i == 0 || i == last))
        return (placeOf(path[1]) - placeOf(path[last - 1])) /
               (path[1].time_s - path[0].time_s + path[last].time_s - path[last - 1].time_s);
    const Waypoint& before = path[i == 0 ? 0 : i - 1];
    const Waypoint& after = path[std::min(i + 1, last)];
    return (placeOf(after) - placeOf(before)) / (after.time_s - before.time_s);
}

/// The time of a path that goes round, brought into it.
double timeOnPath(const SimulatedTarget& target, double time_s) {
    if (!target.loop) return time_s;
    const double first_s = target.path.front().time_s, round_s = target.path.back().time_s - first_s;
    const double rounds = std::floor((time_s - first_s) / round_s);
    return std::min(time_s - rounds * round_s, target.path.back().time_s);
}

double swayRadians(const VehicleMotion& vehicle, double time_s) {
    return radiansFromDegrees(vehicle.yaw_amplitude_deg) *
           std::sin(2.0 * std::numbers::pi * time_s / vehicle.yaw_period_s);
}

/// The turn of the bow against what of a current goes across the course; what goes along it only changes the thrust.
double crabRadians(const VehicleMotion& vehicle, const Eigen::Vector2d& over_ground) {
    constexpr double slowest_mps = 0.3;  // below it the thrusters hold the bow
    const double speed_mps = over_ground.norm();
    if (speed_mps == 0.0) return 0.0;
    const double across_mps =
        (vehicle.current_east_mps * over_ground.x() - vehicle.current_north_mps * over_ground.y()) / speed_mps;
    return -vehicle.crab_share * std::atan(across_mps / std::max(speed_mps, slowest_mps));
}

}  // namespace

double altitudeAt(const Scenario& scenario, double time_s) {
    return scenario.altitude_m +
           scenario.altitude_swing_m * std::sin(2.0 * std::numbers::pi * time_s / scenario.altitude_period_s);
}

VehicleState vehicleState(const Scenario& scenario, double time_s) {
    const VehicleMotion& vehicle = scenario.vehicle;
    const double depth_m = scenario.water_depth_m - scenario.altitude_m;
    const Eigen::Vector2d current(vehicle.current_north_mps, vehicle.current_east_mps);
    if (vehicle.steered) {
        const VehiclePath::Moment at = vehicle.steered->at(time_s);
        return {at.pose, at.over_ground_mps, at.over_ground_mps - current, altitudeAt(scenario, time_s), depth_m};
    }
    TargetMotion own{{vehicle.speed_mps * time_s, 0.0}, {vehicle.speed_mps, 0.0}};
    double ahead_rad = 0.0;
    if (vehicle.follow_lag_s > 0.0) {
        own = targetMotion(scenario.targets.front(), time_s - vehicle.follow_lag_s);
        ahead_rad = directionOf(targetMotion(scenario.targets.front(), time_s).position_m - own.position_m);
    }
    const double turn_rad = swayRadians(vehicle, time_s) + crabRadians(vehicle, own.velocity_mps);
    return {.pose = {own.position_m.x(), own.position_m.y(), Bearing::radians(ahead_rad + turn_rad)},
            .over_ground_mps = own.velocity_mps,
            .through_water_mps = own.velocity_mps - current,
            .altitude_m = altitudeAt(scenario, time_s),
            .depth_m = depth_m};
}

Pose vehiclePose(const Scenario& scenario, double time_s) { return vehicleState(scenario, time_s).pose; }

TargetMotion targetMotion(const SimulatedTarget& target, double time_s) {
    const auto& path = target.path;
    assert(!path.empty());
    time_s = timeOnPath(target, time_s);
    if (time_s < path.front().time_s) return {placeOf(path.front()), {0, 0}};
    if (time_s >= path.back().time_s && !target.loop) return {placeOf(path.back()), {0, 0}};
    const auto next = std::upper_bound(path.begin() + 1, path.end() - 1, time_s,
                                       [](double time, const Waypoint& w) { return time < w.time_s; });
    const auto i = static_cast<std::size_t>(next - path.begin()) - 1;
    const double leg_s = path[i + 1].time_s - path[i].time_s;
    const double u = (time_s - path[i].time_s) / leg_s;
    const Eigen::Vector2d from = placeOf(path[i]), way = placeOf(path[i + 1]) - from;
    const Eigen::Vector2d v0 = velocityAt(target, i) * leg_s, v1 = velocityAt(target, i + 1) * leg_s;
    // p(u) = p0 + u·v0 + u²(3·way − 2·v0 − v1) + u³(v0 + v1 − 2·way)
    const Eigen::Vector2d square = 3.0 * way - 2.0 * v0 - v1, cube = v0 + v1 - 2.0 * way;
    return {from + u * (v0 + u * (square + u * cube)), (v0 + u * (2.0 * square + 3.0 * u * cube)) / leg_s};
}

std::vector<Debris> allDebris(const Scenario& scenario, std::uint64_t seed) {
    std::vector<Debris> all = scenario.debris;
    for (std::size_t i = 0; i < scenario.debris_fields.size(); ++i) {
        const DebrisField& field = scenario.debris_fields[i];
        RandomStream random(seed, debris_numbers, i);
        const auto between = [&](double low, double high) { return low + (high - low) * random.uniform(); };
        for (int k = 0; k < field.count; ++k) {
            Debris piece;
            piece.north_m = between(field.south_m, field.north_m);
            piece.east_m = between(field.west_m, field.east_m);
            piece.size_m = between(field.smallest_m, field.largest_m);
            piece.strength_db = between(field.weakest_db, field.strongest_db);
            all.push_back(piece);
        }
    }
    return all;
}

}  // namespace echotrail
