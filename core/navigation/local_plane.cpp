#include "core/navigation/local_plane.hpp"

#include <cmath>

namespace echotrail {
namespace {

constexpr double equatorial_radius_m = 6378137.0;
constexpr double flattening = 1.0 / 298.257223563;
constexpr double eccentricity_squared = flattening * (2.0 - flattening);

struct Meridional {
    double from_axis_m;      ///< distance from the earth's axis
    double above_equator_m;  ///< height over the equator's plane
};

/// Where the ellipsoid is at a latitude, in the plane of its meridian.
Meridional onEllipsoid(double latitude_rad) {
    const double s = std::sin(latitude_rad);
    const double normal_m = equatorial_radius_m / std::sqrt(1.0 - eccentricity_squared * s * s);
    return {normal_m * std::cos(latitude_rad), normal_m * (1.0 - eccentricity_squared) * s};
}

}  // namespace

LocalPosition LocalPlane::toLocal(const GeographicPosition& position) const {
    const Meridional here = onEllipsoid(position.latitude_rad);
    const Meridional origin = onEllipsoid(origin_.latitude_rad);
    const double turn = position.longitude_rad - origin_.longitude_rad;
    // Away from the axis along the origin's meridian, and up along the axis: both lean on the origin's north.
    const double outward_m = here.from_axis_m * std::cos(turn) - origin.from_axis_m;
    const double upward_m = here.above_equator_m - origin.above_equator_m;
    return {at_.north_m + (upward_m * std::cos(origin_.latitude_rad) - outward_m * std::sin(origin_.latitude_rad)),
            at_.east_m + here.from_axis_m * std::sin(turn)};
}

GeographicPosition LocalPlane::toGeographic(const LocalPosition& place) const {
    constexpr int rounds = 5;  // each leaves about a thousandth of the error
    GeographicPosition found = origin_;
    for (int i = 0; i < rounds; ++i) {
        const LocalPosition reached = toLocal(found);
        const double s = std::sin(found.latitude_rad);
        const double normal_m = equatorial_radius_m / std::sqrt(1.0 - eccentricity_squared * s * s);
        const double meridian_m = normal_m * (1.0 - eccentricity_squared) / (1.0 - eccentricity_squared * s * s);
        found.latitude_rad += (place.north_m - reached.north_m) / meridian_m;
        found.longitude_rad += (place.east_m - reached.east_m) / (normal_m * std::cos(found.latitude_rad));
    }
    found.longitude_rad = wrapRadians(found.longitude_rad);
    return found;
}

}  // namespace echotrail
