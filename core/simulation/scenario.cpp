#include "core/simulation/scenario.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace echotrail {

namespace {

/// A rough bottom close below, and a reflector that is not turned towards the head: section i of the method gives a
/// corner reflector of 1 m some 10 dB at 20 m on its axis and over 20 dB less off it, so that it stands out from the
/// bottom by 15 to 30 dB.
Scenario demonstration() {
    Scenario scene;
    scene.name = "demonstration";
    scene.description = "A 1 m reflector comes in from 40 m to 12 m across the bow, among four pieces of debris";
    scene.duration_s = 150.0;
    scene.gain_db = 14.0;
    scene.targets = {{.path = {{0, 36, -17}, {60, 38, 4}, {80, 43, 10}, {100, 50, 10}, {115, 50.5, 5}, {150, 41.5, -4}},
                      .strength_db = -18.0}};
    scene.debris = {{.north_m = 30, .east_m = 9, .size_m = 0.3, .strength_db = -27},
                    {.north_m = 40.5, .east_m = -8, .strength_db = -25},
                    {.north_m = 46, .east_m = 17, .size_m = 0.8, .strength_db = -22},
                    {.north_m = 56, .east_m = -13, .size_m = 1.2, .strength_db = -24}};
    scene.vehicle = {.speed_mps = 0.2, .yaw_amplitude_deg = 4.0, .yaw_period_s = 37.0};
    scene.water_depth_m = 4.5;
    scene.altitude_m = 2.5;
    scene.bottom_strength_db = -10.0;
    scene.surface_strength_db = -25.0;
    return scene;
}

Scenario deep() {
    Scenario scene;
    scene.name = "deep";
    scene.description = "One reflector crosses in deep water with nothing else about; the vehicle lies still";
    scene.gain_db = 14.0;
    scene.targets = {{.path = {{0, 28, -16}, {120, 16, 14}}, .strength_db = -16.0}};
    scene.water_depth_m = 12.5;
    scene.altitude_m = 9.0;
    scene.bottom_strength_db = -25.0;
    return scene;
}

Scenario empty() {
    Scenario scene = demonstration();
    scene.name = "empty";
    scene.description = "Nothing but reverberation and noise; the vehicle lies still";
    scene.duration_s = 60.0;
    scene.targets.clear();
    scene.debris.clear();
    scene.vehicle = {};
    return scene;
}

Eigen::Vector2d placeOf(const Waypoint& waypoint) { return {waypoint.north_m, waypoint.east_m}; }

/// Velocity at a waypoint: that from its neighbour before to its neighbour after (Catmull–Rom).
Eigen::Vector2d velocityAt(const std::vector<Waypoint>& path, std::size_t i) {
    const Waypoint& before = path[i == 0 ? 0 : i - 1];
    const Waypoint& after = path[std::min(i + 1, path.size() - 1)];
    return (placeOf(after) - placeOf(before)) / (after.time_s - before.time_s);
}

}  // namespace

const std::vector<Scenario>& scenarios() {
    static const std::vector<Scenario> all{demonstration(), deep(), empty()};
    return all;
}

Pose vehiclePose(const VehicleMotion& vehicle, double time_s) {
    const double sway = std::sin(2.0 * std::numbers::pi * time_s / vehicle.yaw_period_s);
    return {vehicle.speed_mps * time_s, 0.0, Bearing::degrees(vehicle.yaw_amplitude_deg * sway)};
}

TargetMotion targetMotion(const SimulatedTarget& target, double time_s) {
    const auto& path = target.path;
    assert(!path.empty());
    if (time_s < path.front().time_s) return {placeOf(path.front()), {0, 0}};
    if (time_s >= path.back().time_s) return {placeOf(path.back()), {0, 0}};
    const auto next = std::upper_bound(path.begin(), path.end(), time_s,
                                       [](double time, const Waypoint& w) { return time < w.time_s; });
    const auto i = static_cast<std::size_t>(next - path.begin()) - 1;
    const double leg_s = path[i + 1].time_s - path[i].time_s;
    const double u = (time_s - path[i].time_s) / leg_s;
    const Eigen::Vector2d from = placeOf(path[i]), way = placeOf(path[i + 1]) - from;
    const Eigen::Vector2d v0 = velocityAt(path, i) * leg_s, v1 = velocityAt(path, i + 1) * leg_s;
    // p(u) = p0 + u·v0 + u²(3·way − 2·v0 − v1) + u³(v0 + v1 − 2·way)
    const Eigen::Vector2d square = 3.0 * way - 2.0 * v0 - v1, cube = v0 + v1 - 2.0 * way;
    return {from + u * (v0 + u * (square + u * cube)), (v0 + u * (2.0 * square + 3.0 * u * cube)) / leg_s};
}

}  // namespace echotrail
