#pragma once

#include "core/base/angles.hpp"
#include "core/base/time.hpp"
#include "core/data/head_settings.hpp"
#include "core/data/ping.hpp"
#include "core/data/pose.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <span>

namespace echotrail {

/// One echo line placed in the local frame (north and east, level plane). An echo from range r was reflected at
/// t* = t_transmit + r / c; until then the head has moved and turned, both linearly in r (method card, section a).
/// Metres and radians; the levels belong to somebody else.
struct Ray {
    double origin_north_m = 0.0;  ///< of the head at transmission
    double origin_east_m = 0.0;
    double drift_north = 0.0;  ///< how far the head moves per metre of range
    double drift_east = 0.0;
    double azimuth_rad = 0.0;     ///< of the beam from north at transmission, in [-pi, pi)
    double turn_rad_per_m = 0.0;  ///< of the beam per metre of range
    Bearing head_bearing;         ///< of the transducer from the head's zero: tells missing pings from yaw
    double step_rad = 0.0;        ///< of the head between this ping and the next
    double bin_size_m = 0.0;
    std::int32_t time_ms = 0;              ///< of transmission, since the source's first ping
    std::span<const std::uint8_t> levels;  ///< bin i is centred at (i + 1/2) * bin_size_m; 0…255 is 0…80 dB

    double farEnd() const { return bin_size_m * static_cast<double>(levels.size()); }
    double azimuthAt(double range_m) const { return azimuth_rad + turn_rad_per_m * range_m; }
    /// North and east of what the beam's axis meets at this range.
    Eigen::Vector2d at(double range_m) const;
};

/// A place as the head sees it.
struct HeadPolar {
    double range_m = 0.0;
    Bearing bearing;  ///< from the head's zero, clockwise from above unless the head hangs upside down
};

/// Where the head is and where its zero points, for a vehicle at `vehicle`. Of the settings the mounting counts.
Pose headPose(const Pose& vehicle, const HeadSettings& mount);
/// The direction from the bow in which a transducer at `head_bearing` looks; an inverted head turns the other way.
Bearing bearingFromBow(Bearing head_bearing, const HeadSettings& mount);

/// North and east of a place that the head sees.
Eigen::Vector2d localFromHead(const HeadPolar& seen, const Pose& vehicle, const HeadSettings& mount);
/// The inverse of localFromHead.
HeadPolar headFromLocal(const Eigen::Vector2d& place, const Pose& vehicle, const HeadSettings& mount);
/// Range from the head, and bearing from the bow, of a place.
HeadPolar bowPolarFromLocal(const Eigen::Vector2d& place, const Pose& vehicle, const HeadSettings& mount);

/// Places an echo line. `at_far_end` is the vehicle's pose at t_transmit + R / c, R being the far end of the last bin;
/// `first_ping` is when the source's first ping was sent. The ray's levels are those of `ping`, which must outlive it.
Ray makeRay(const Ping& ping, const Pose& at_transmit, const Pose& at_far_end, const HeadSettings& mount,
            Timestamp first_ping);

}  // namespace echotrail
