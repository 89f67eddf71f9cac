#pragma once

#include "core/data/pose.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace echotrail {

/// Where a target is at a moment, in the local frame.
struct Waypoint {
    double time_s = 0.0;  ///< since the first ping
    double north_m = 0.0;
    double east_m = 0.0;
};

struct SimulatedTarget {
    std::vector<Waypoint> path;  ///< in time order, at least one; it stays where the last one is
    double size_m = 1.0;         ///< its echo is smeared over range with a deviation of 0.15 of this
    double strength_db = 10.0;   ///< mean target strength
};

/// A fixed object that is no target.
struct Debris {
    double north_m = 0.0;
    double east_m = 0.0;
    double size_m = 0.5;
    double strength_db = 0.0;
};

/// The vehicle goes along a straight course, northwards from the origin, while its bow sways about that course.
struct VehicleMotion {
    double speed_mps = 0.0;
    double yaw_amplitude_deg = 0.0;
    double yaw_period_s = 30.0;
};

/// What there is in the water, and how the head looks at it.
struct Scenario {
    std::string name;
    std::string description;
    double duration_s = 120.0;
    double range_m = 50.0;
    double sector_half_width_deg = 45.0;  ///< a whole number of steps; scanned to and fro about the bow
    double step_deg = 1.8;
    double gain_db = 0.0;  ///< 0 shows a scatterer of -60 dB as level 0
    std::vector<SimulatedTarget> targets;
    std::vector<Debris> debris;
    VehicleMotion vehicle;
    double water_depth_m = 10.0;
    double altitude_m = 5.0;             ///< of the head above the bottom
    double bottom_strength_db = -20.0;   ///< S0 of Lambert's law, per square metre at perpendicular incidence
    double surface_strength_db = -35.0;  ///< the same of the surface: -35 calm, -20 breaking
};

/// The built-in ones: "demonstration", "deep", "empty".
const std::vector<Scenario>& scenarios();

/// The vehicle's pose; defined for any time.
Pose vehiclePose(const VehicleMotion& vehicle, double time_s);

struct TargetMotion {
    Eigen::Vector2d position_m{0, 0};  ///< north, east
    Eigen::Vector2d velocity_mps{0, 0};
};

/// Place and velocity of a target: a smooth curve through its waypoints (cubic Hermite), at rest outside their times.
TargetMotion targetMotion(const SimulatedTarget& target, double time_s);

}  // namespace echotrail
