#include "core/data/area.hpp"

#include "core/data/polygon.hpp"
#include "core/data/pose.hpp"

#include <Eigen/Geometry>

namespace echotrail {
namespace {

Eigen::Rotation2Df turnOf(const Pose& vehicle) {
    return Eigen::Rotation2Df(static_cast<float>(vehicle.heading.inRadians()));
}

Eigen::Vector2f middleOf(const Pose& vehicle) {
    return {static_cast<float>(vehicle.north_m), static_cast<float>(vehicle.east_m)};
}

}  // namespace

Eigen::Vector2f placeOf(const Area& area, const Eigen::Vector2f& corner, const Pose& vehicle) {
    return area.with_vehicle ? Eigen::Vector2f(middleOf(vehicle) + turnOf(vehicle) * corner) : corner;
}

Eigen::Vector2f cornerAt(const Area& area, const Eigen::Vector2f& place, const Pose& vehicle) {
    if (!area.with_vehicle) return place;
    return turnOf(vehicle).inverse() * Eigen::Vector2f(place - middleOf(vehicle));
}

bool holds(const Area& area, const Eigen::Vector2f& place, const Pose& vehicle) {
    if (area.corners_m.size() < 3) return false;
    return isInside(cornerAt(area, place, vehicle), area.corners_m);
}

}  // namespace echotrail
