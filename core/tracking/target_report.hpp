#pragma once

#include "core/data/pose.hpp"
#include "core/data/track.hpp"

#include <Eigen/Core>

namespace echotrail {

/// The vehicle at a moment, in the local frame.
struct OwnMotion {
    Pose pose;
    Eigen::Vector2d velocity_mps{0, 0};  ///< north, east
};

/// What a motion controller needs to know of the target, at a moment between or after the looks at it.
struct TargetReport {
    TrackLook look;      ///< as predicted for that moment: place, range and bearing from the head, covariance
    double age_s = 0.0;  ///< since the last real echo
    bool valid = false;  ///< confirmed, or coasting: what is tentative or lost shall steer nothing
    double closest_approach_m = 0.0;  ///< if both keep their velocities, from now on
    double time_to_closest_s = 0.0;   ///< 0 where they are going apart
    double risk = 0.0;  ///< weighted share of particles that come nearer than 5 m within 30 s (method card, section g)
};

/// `track` predicted to `time` with its velocity and the uncertainty of that; nothing is added for manoeuvres.
TargetReport reportOn(const Track& track, const OwnMotion& own, Timestamp time);

}  // namespace echotrail
