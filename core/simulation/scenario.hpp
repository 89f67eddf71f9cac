#pragma once

#include "core/data/pose.hpp"
#include "core/simulation/vehicle_path.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace echotrail {

/// Where a target is at a moment, in the local frame.
struct Waypoint {
    double time_s = 0.0;  ///< since the first ping
    double north_m = 0.0;
    double east_m = 0.0;
};

/// A time in which a target is fainter.
struct Fade {
    double from_s = 0.0;
    double until_s = 0.0;
    double depth_db = 0.0;
};

struct SimulatedTarget {
    std::vector<Waypoint> path;  ///< in time order, at least one; it stays where the last one is
    std::vector<Fade> fades;
    bool loop = false;          ///< the path closes and is gone along again and again, also before its first time
    double size_m = 1.0;        ///< its echo is smeared over range with a deviation of 0.15 of this
    double strength_db = 10.0;  ///< mean target strength of one without a reflector
    double reflector_m = 0.0;   ///< edge of its corner reflector; 0 is none
    double faces_deg = 180.0;   ///< where the reflector looks, clockwise from the target's course
    double wander_deg = 0.0;    ///< deviation of that direction, as the target yaws within some seconds
    double body_db = -20.0;     ///< what is left of its strength where the reflector looks away
    double below_head_m = 0.0;
    double wake_s = 0.0;  ///< bubbles stay behind it for this long
    double wake_db = -25.0;
};

/// A fixed object that is no target.
struct Debris {
    double north_m = 0.0;
    double east_m = 0.0;
    double size_m = 0.5;
    double strength_db = 0.0;
};

/// Debris strewn evenly over a rectangle, by the seed.
struct DebrisField {
    int count = 0;
    double south_m = 0.0, north_m = 0.0, west_m = 0.0, east_m = 0.0;
    double smallest_m = 0.2, largest_m = 1.5;
    double weakest_db = -15.0, strongest_db = 5.0;
};

/// The vehicle goes along a straight course, northwards from the origin, while its bow sways about that course; or it
/// goes where the first target was `follow_lag_s` ago, with its bow swaying about the way to that target.
struct VehicleMotion {
    double speed_mps = 0.0;
    double yaw_amplitude_deg = 0.0;
    double yaw_period_s = 30.0;
    double follow_lag_s = 0.0;       ///< 0: straight on
    double current_north_mps = 0.0;  ///< the water's own motion over ground
    double current_east_mps = 0.0;
    double crab_share = 0.3;  ///< the part of the drift angle that the bow takes; thrusters hold the rest
    /// It is steered from outside: it is where this says, and nothing of the above but the current matters.
    std::shared_ptr<const VehiclePath> steered;
};

/// What navigation says wrongly. Position is reckoned from velocity and drawn back to the truth by fixes.
struct NavigationErrors {
    double heading_bias_deg = 0.0;
    double heading_noise_deg = 0.0;
    double velocity_bias_mps = 0.0;  ///< ahead, turning with the vehicle
    double velocity_noise_mps = 0.0;
    double position_hold_s = 60.0;  ///< an error of position fades with this time constant
    double least_latency_s = 0.0;   ///< a pose is told with a time later than its own, by this much
    double most_latency_s = 0.0;
};

/// What there is in the water, and how the head looks at it. The files in resources/scenarios have these names.
struct Scenario {
    std::string name;
    std::string description;
    double duration_s = 120.0;
    double range_m = 50.0;
    double sector_half_width_deg = 45.0;  ///< a whole number of steps; scanned to and fro about the bow
    double step_deg = 1.8;
    double frequency_khz = 325.0;
    double gain_db = 0.0;     ///< 0 shows a scatterer of -60 dB as level 0
    double pulse_us = 130.0;  ///< length of the pulse, as told from the grain of real heads' pictures
    int looks = 1;            ///< independent echoes averaged in a bin
    double water_depth_m = 10.0;
    double altitude_m = 5.0;        ///< of the head above the bottom, in the mean
    double altitude_swing_m = 0.0;  ///< the bottom rises and falls below it by so much
    double altitude_period_s = 300.0;
    double bottom_strength_db = -20.0;  ///< S0 of Lambert's law, per square metre at perpendicular incidence
    double bottom_texture = 0.0;        ///< shape of the gamma law of its patches of 0.5 m; 0: all alike
    double rock_share = 0.0;            ///< part of the bottom that is rock
    double rock_db = 12.0;              ///< by which rock is stronger
    bool low_grazing_floor = true;
    double surface_strength_db = -35.0;  ///< the same of the surface: -35 calm, -20 breaking
    int multipath_copies = 0;            ///< ghosts behind every target
    bool shadows = false;                ///< objects hide the bottom behind them
    std::vector<SimulatedTarget> targets;
    std::vector<Debris> debris;
    std::vector<DebrisField> debris_fields;
    VehicleMotion vehicle;
    NavigationErrors navigation;
};

/// The built-in ones, from resources/scenarios, by name.
const std::vector<Scenario>& scenarios();

/// What a vehicle does at a moment.
struct VehicleState {
    Pose pose;
    Eigen::Vector2d over_ground_mps{0, 0};    ///< north, east
    Eigen::Vector2d through_water_mps{0, 0};  ///< north, east
    double altitude_m = 0.0;
    double depth_m = 0.0;
};
/// Defined for any time.
VehicleState vehicleState(const Scenario& scenario, double time_s);
/// Only the pose of it.
Pose vehiclePose(const Scenario& scenario, double time_s);
/// Height of the head above the bottom.
double altitudeAt(const Scenario& scenario, double time_s);

struct TargetMotion {
    Eigen::Vector2d position_m{0, 0};  ///< north, east
    Eigen::Vector2d velocity_mps{0, 0};
};

/// Place and velocity of a target: a smooth curve through its waypoints (cubic Hermite), at rest outside their times
/// unless it goes round.
TargetMotion targetMotion(const SimulatedTarget& target, double time_s);

/// All fixed objects, those strewn by the seed included.
std::vector<Debris> allDebris(const Scenario& scenario, std::uint64_t seed);

}  // namespace echotrail
