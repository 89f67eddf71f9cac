#pragma once

#include "core/data/pose.hpp"
#include "core/data/track.hpp"

#include <map>
#include <optional>
#include <vector>

namespace echotrail {

/// Where the vehicle and the tracks have been since the beginning, in the local frame, oldest first.
struct Paths {
    struct Point {
        Timestamp time{};
        Eigen::Vector2f place_m{0, 0};  ///< north, east
    };
    std::vector<TimedPose> vehicle;
    std::map<int, std::vector<Point>> tracks;  ///< by id; confirmed ones only
};

/// Gathers paths in bounded room: one that grows too long keeps every other of its points, and from then on takes
/// half as many. Tracks beyond a number push out the oldest.
/// Order: in time order; an older pose is refused.
class PathKeeper {
public:
    static constexpr std::size_t most_points = 1024;
    static constexpr std::size_t most_tracks = 64;

    void add(const TimedPose& vehicle);
    void add(const TrackLook& look);
    const Paths& paths() const { return paths_; }

private:
    Paths paths_;
    double vehicle_spacing_s_ = 0.5;
    std::map<int, double> track_spacing_s_;
};

/// Where the vehicle moves, from north: over the last `over_s` seconds of its path. None where it has moved less than
/// `least_m` in them, or the path is shorter.
std::optional<Bearing> courseOf(const std::vector<TimedPose>& path, double over_s = 10.0, double least_m = 0.5);

}  // namespace echotrail
