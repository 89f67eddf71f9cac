#include "core/imaging/ray.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace echotrail {

Eigen::Vector2d Ray::at(double range_m) const {
    const double azimuth = azimuthAt(range_m);
    return {origin_north_m + range_m * (drift_north + std::cos(azimuth)),
            origin_east_m + range_m * (drift_east + std::sin(azimuth))};
}

Pose headPose(const Pose& vehicle, const HeadSettings& mount) {
    const double c = std::cos(vehicle.heading.inRadians()), s = std::sin(vehicle.heading.inRadians());
    return {vehicle.north_m + c * mount.mount_forward_m - s * mount.mount_starboard_m,
            vehicle.east_m + s * mount.mount_forward_m + c * mount.mount_starboard_m,
            vehicle.heading + radiansFromDegrees(mount.mount_heading_deg)};
}

Bearing bearingFromBow(Bearing head_bearing, const HeadSettings& mount) {
    const double turn = mount.mount_inverted ? -head_bearing.inRadians() : head_bearing.inRadians();
    return Bearing::radians(radiansFromDegrees(mount.mount_heading_deg) + turn);
}

Eigen::Vector2d localFromHead(const HeadPolar& seen, const Pose& vehicle, const HeadSettings& mount) {
    const Pose head = headPose(vehicle, mount);
    const double azimuth = (vehicle.heading + bearingFromBow(seen.bearing, mount).inRadians()).inRadians();
    return {head.north_m + seen.range_m * std::cos(azimuth), head.east_m + seen.range_m * std::sin(azimuth)};
}

HeadPolar bowPolarFromLocal(const Eigen::Vector2d& place, const Pose& vehicle, const HeadSettings& mount) {
    const Pose head = headPose(vehicle, mount);
    const double north = place.x() - head.north_m, east = place.y() - head.east_m;
    const double azimuth = std::atan2(east, north);
    return {std::hypot(north, east), Bearing::radians(azimuth - vehicle.heading.inRadians())};
}

HeadPolar headFromLocal(const Eigen::Vector2d& place, const Pose& vehicle, const HeadSettings& mount) {
    const HeadPolar from_bow = bowPolarFromLocal(place, vehicle, mount);
    const double turn = from_bow.bearing - Bearing::degrees(mount.mount_heading_deg);
    return {from_bow.range_m, Bearing::radians(mount.mount_inverted ? -turn : turn)};
}

Ray makeRay(const Ping& ping, const Pose& at_transmit, const Pose& at_far_end, const HeadSettings& mount,
            Timestamp first_ping) {
    const Pose near_head = headPose(at_transmit, mount), far_head = headPose(at_far_end, mount);
    const Bearing from_bow = bearingFromBow(ping.bearing, mount);
    Ray ray{.origin_north_m = near_head.north_m,
            .origin_east_m = near_head.east_m,
            .azimuth_rad = (at_transmit.heading + from_bow.inRadians()).inRadians(),
            .head_bearing = ping.bearing,
            .step_rad = ping.step_rad,
            .bin_size_m = ping.binSize(),
            .levels = ping.levels};
    const double far_end = ray.farEnd();
    if (far_end > 0.0) {
        ray.drift_north = (far_head.north_m - near_head.north_m) / far_end;
        ray.drift_east = (far_head.east_m - near_head.east_m) / far_end;
        ray.turn_rad_per_m = (at_far_end.heading - at_transmit.heading) / far_end;
    }
    // 32 bits hold 24 days; a longer source keeps the last moment they can tell.
    const double ms = std::round(secondsBetween(first_ping, ping.time) * 1000.0);
    ray.time_ms = static_cast<std::int32_t>(std::clamp(ms, 0.0, double{std::numeric_limits<std::int32_t>::max()}));
    return ray;
}

}  // namespace echotrail
