#pragma once

#include "core/base/angles.hpp"
#include "core/base/time.hpp"
#include "core/data/pose.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace echotrail {

/// What sets a region apart besides its place (method card, sections d and e).
struct RegionFeatures {
    double area_m2 = 0.0;
    double moment = 0.0;          ///< m* = log10(M2 + 1e-3), M2 Hu's second invariant of the region's mask
    double along_range_m = 0.0;   ///< 4 times the deviation of the mask along the line of sight
    double across_range_m = 0.0;  ///< the same across it
    double strength_db = 0.0;     ///< how far its peak stands out from the background
    double level_db = 0.0;        ///< of its peak
};

/// A connected patch of the fan that stands out from its background.
struct Region {
    std::uint32_t id = 0;              ///< counts from 1 within a run
    Timestamp time{};                  ///< when the beam was on it (mean, weighted as the centroid)
    Eigen::Vector2d position_m{0, 0};  ///< centroid (see RegionShapeParams), north and east in the local frame
    Pose head;                         ///< where it was seen from, at `time`; its heading is the bow's
    double range_m = 0.0;              ///< from the head at `time`
    Bearing bearing;                   ///< from the bow at `time`
    RegionFeatures features;
    double peak_db = 0.0;
    double mean_db = 0.0;
    double contrast_db = 0.0;  ///< peak excess over the background
    int pixels = 0;
    int beam_hits = 0;                       ///< pings that met it
    double clipped_fraction = 0.0;           ///< of its pixels at full scale
    bool only_expected = false;              ///< found only because an object was expected there
    bool clutter_mass = false;               ///< larger than any target: a bank, the bottom, a wall
    bool multipath = false;                  ///< looks like the echo of a stronger region behind it
    std::vector<Eigen::Vector2f> outline_m;  ///< contour, north and east
};

}  // namespace echotrail
