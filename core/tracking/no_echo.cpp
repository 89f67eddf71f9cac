#include "core/tracking/gate.hpp"
#include "core/tracking/tracker.hpp"

#include <cmath>

// Looks as they are told, and why one used no echo: for the log, and for whoever asks why a target was lost.
namespace echotrail {
namespace {

constexpr std::size_t longest_history = 64;

}  // namespace

NoEcho Tracker::whyNoEcho(const FollowedTrack& followed, Timestamp time, const std::vector<std::size_t>& regions,
                          const std::vector<Pairing>& pairings) const {
    if (followed.pings_missing) return NoEcho::PingsMissing;
    if (followed.navigation_gap) return NoEcho::NavigationGap;
    NoEcho cause = NoEcho::UnderThreshold;
    for (std::size_t k = 0; k < regions.size(); ++k) {
        if (!pairings[k].gated) continue;
        const Region& region = pending_[regions[k]].region;
        const bool others = pending_[regions[k]].claimed;
        const double expected_m2 = expectedFeatures(followed, region.range_m).area_m2;
        if (others && region.features.area_m2 > merged_area * expected_m2) return NoEcho::Merged;
        if (others) cause = NoEcho::TakenByAnother;
        if (cause == NoEcho::UnderThreshold) cause = NoEcho::OutscoredByClutter;
    }
    const bool in_mass =
        cause == NoEcho::UnderThreshold && recent_.hasMassAt(predict(followed, time).mean.head<2>(), time);
    return in_mass ? NoEcho::Merged : cause;
}

NoEcho Tracker::whyNotScanned(const FollowedTrack& followed) const {
    if (followed.pings_missing) return NoEcho::PingsMissing;
    if (followed.navigation_gap) return NoEcho::NavigationGap;
    const auto& history = followed.track.history;
    if (!history.empty() && !history.back().seen) return history.back().no_echo;  // it did come by, in vain
    return followed.quiet_sweeps > 1 ? NoEcho::OutsideSector : NoEcho::NotYetScanned;
}

TrackLook Tracker::lookOf(const FollowedTrack& followed, Timestamp time, NoEcho cause, const Pose& head) const {
    const Track& track = followed.track;
    const Eigen::Vector2d position = track.estimate.mean.head<2>();
    const double north = position.x() - head.north_m, east = position.y() - head.east_m;
    return {.time = time,
            .track = track.id,
            .state = track.state,
            .target = track.target,
            .seen = cause == NoEcho::None,
            .no_echo = cause,
            .range_m = std::hypot(north, east),
            .bearing = Bearing::radians(std::atan2(east, north) - head.heading.inRadians()),
            .position_m = position,
            .velocity_mps = track.estimate.mean.tail<2>(),
            .covariance_m2 = track.estimate.covariance.topLeftCorner<2, 2>()};
}

void Tracker::remember(const TrackLook& look, Track& track) {
    if (track.history.size() == longest_history) track.history.erase(track.history.begin());
    track.history.push_back(look);
}

}  // namespace echotrail
