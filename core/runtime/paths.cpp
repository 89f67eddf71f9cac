#include "core/runtime/paths.hpp"

#include <cmath>

namespace echotrail {
namespace {

template <class Point>
void append(std::vector<Point>& path, const Point& point, double& spacing_s) {
    if (!path.empty() && secondsBetween(path.back().time, point.time) < spacing_s) return;
    path.push_back(point);
    if (path.size() <= PathKeeper::most_points) return;
    std::vector<Point> thinner;
    for (std::size_t i = 0; i < path.size(); i += 2) thinner.push_back(path[i]);
    path = std::move(thinner);
    spacing_s *= 2.0;
}

}  // namespace

void PathKeeper::add(const TimedPose& vehicle) { append(paths_.vehicle, vehicle, vehicle_spacing_s_); }

void PathKeeper::add(const TrackLook& look) {
    if (look.state == TrackState::Tentative || look.state == TrackState::Lost) return;
    if (!paths_.tracks.contains(look.track) && paths_.tracks.size() == most_tracks) {
        track_spacing_s_.erase(paths_.tracks.begin()->first);  // ids count up: the first is the oldest
        paths_.tracks.erase(paths_.tracks.begin());
    }
    append(paths_.tracks[look.track], Paths::Point{look.time, look.position_m.cast<float>()},
           track_spacing_s_[look.track]);
}

std::optional<Bearing> courseOf(const std::vector<TimedPose>& path, double over_s, double least_m) {
    if (path.empty()) return std::nullopt;
    const TimedPose& now = path.back();
    for (auto past = path.rbegin(); past != path.rend(); ++past) {
        if (secondsBetween(past->time, now.time) < over_s) continue;
        const double north = now.pose.north_m - past->pose.north_m;
        const double east = now.pose.east_m - past->pose.east_m;
        if (std::hypot(north, east) < least_m) return std::nullopt;
        return Bearing::radians(std::atan2(east, north));
    }
    return std::nullopt;
}

}  // namespace echotrail
