#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace echotrail {

struct Pose;

/// A part of the sea that the operator has drawn.
struct Area {
    enum class Kind {
        Guard,  ///< a confirmed track that comes in is told of
        Veto    ///< nobody is told of what is in there; the tracker does not know of it
    };
    Kind kind = Kind::Guard;
    std::string name;
    /// Corners count from the vehicle, ahead and to starboard; else from the origin of the local frame, north and east.
    bool with_vehicle = false;
    std::vector<Eigen::Vector2f> corners_m;
    bool operator==(const Area&) const = default;
};

/// A corner's place in the local frame, for a vehicle at `vehicle`; and the other way round.
Eigen::Vector2f placeOf(const Area& area, const Eigen::Vector2f& corner, const Pose& vehicle);
Eigen::Vector2f cornerAt(const Area& area, const Eigen::Vector2f& place, const Pose& vehicle);

/// Whether a place of the local frame lies in an area; fewer than three corners hold nothing.
bool holds(const Area& area, const Eigen::Vector2f& place, const Pose& vehicle);

}  // namespace echotrail
