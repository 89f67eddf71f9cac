#include "core/tracking/gate.hpp"
#include "core/tracking/tracker.hpp"

#include <Eigen/LU>

#include <algorithm>

// What the operator points at: the target, and tracks that are not wanted.
namespace echotrail {
namespace {

constexpr double sure_pick_m = 1.0;    // a proven track this near a pick is meant
constexpr double pick_db_per_m = 3.0;  // a region further from the pick has to be so much stronger

bool isProven(const Track& track) {
    return track.state == TrackState::Confirmed || track.state == TrackState::Coasting;
}

/// How likely a track at this distance from a pick is meant: the strongest is.
double pickWorth(const Track& track, double distance_m) {
    return track.expected_features.strength_db - pick_db_per_m * distance_m;
}

}  // namespace

void Tracker::designate(const Eigen::Vector2d& position_m, double radius_m) {
    if (findLostTarget(position_m, radius_m)) return;
    clearDesignation();
    designation_ = Designation{.position_m = position_m, .radius_m = radius_m};
    applyDesignation();
}

/// Where the target is lost and the pick lies where it is searched for, the operator has found it again: it keeps its
/// name and what is known of its looks. Not where a stronger proven track is pointed at.
bool Tracker::findLostTarget(const Eigen::Vector2d& position_m, double radius_m) {
    const auto lost = std::find_if(followed_.begin(), followed_.end(), [](const FollowedTrack& followed) {
        return followed.track.target && followed.track.state == TrackState::Lost;
    });
    if (lost == followed_.end()) return false;
    const GaussianState search = predict(*lost, std::max(beam_.time, lost->track.estimate.time));
    const Eigen::Vector2d off = position_m - search.mean.head<2>();
    const Eigen::Matrix2d spread = search.covariance.topLeftCorner<2, 2>();
    if (off.dot(spread.inverse() * off) > params_.tracking.gate) return false;
    for (const FollowedTrack& other : followed_) {
        const double distance = (placeNow(other) - position_m).norm();
        if (isProven(other.track) && distance < sure_pick_m && pickWorth(other.track, distance) > pickWorth(lost->track, 0))
            return false;
    }
    GaussianState& found = lost->track.estimate;
    const double speed = params_.tracking.initial_speed_sigma_mps;
    found.time = search.time;
    found.mean << position_m, Eigen::Vector2d::Zero();
    found.covariance.setZero();
    found.covariance.diagonal() << Eigen::Vector2d::Constant(radius_m * radius_m / (gate_sigmas * gate_sigmas)),
        Eigen::Vector2d::Constant(speed * speed);
    lost->track.existence = std::max(lost->track.existence, params_.life.picked_existence);
    lost->pass.restart();
    designation_.reset();
    return true;
}

void Tracker::clearDesignation() {
    designation_.reset();
    for (FollowedTrack& followed : followed_) followed.track.target = false;
}

bool Tracker::drop(int track, const Eigen::Vector2d& position_m, double radius_m) {
    for (FollowedTrack& followed : followed_) {
        const double distance = (followed.track.estimate.mean.head<2>() - position_m).norm();
        if (followed.track.id != track || distance > radius_m) continue;
        followed.dropped = true;
        followed.track.target = false;
        return true;
    }
    return false;
}

void Tracker::restore(int track) {
    for (FollowedTrack& followed : followed_)
        if (followed.track.id == track) followed.dropped = false;
}

bool Tracker::isDropped(int track) const {
    return std::any_of(followed_.begin(), followed_.end(), [&](const FollowedTrack& followed) {
        return followed.dropped && followed.track.id == track;
    });
}

void Tracker::hushDropped(std::vector<TrackLook>& looks) const {
    std::erase_if(looks, [this](const TrackLook& look) { return isDropped(look.track); });
}

/// A proven track at the pick is the target; where there is none, the first thing near it. Until that is proven,
/// too, a stronger one near it takes its turn: a wake or a ghost can show before the object itself does, a sweep
/// earlier if that looks away, and the strongest is meant.
void Tracker::applyDesignation() {
    if (!designation_) return;
    Eigen::Vector2d pick = designation_->position_m;
    for (const FollowedTrack& followed : followed_)
        if (followed.track.target) pick = placeNow(followed);  // it may have moved on
    FollowedTrack* best = nullptr;
    double best_worth = -1e9;
    for (FollowedTrack& followed : followed_) {
        if (followed.track.state == TrackState::Lost) continue;
        const double distance = (placeNow(followed) - pick).norm();
        if (distance > designation_->radius_m) continue;
        const bool was_proven = designation_->fresh && isProven(followed.track) && distance < sure_pick_m;
        const double worth = was_proven ? 1000.0 - distance : pickWorth(followed.track, distance);
        if (worth <= best_worth) continue;
        best = &followed;
        best_worth = worth;
    }
    designation_->fresh = false;
    if (!best) return;
    for (FollowedTrack& followed : followed_)
        if (&followed != best && followed.track.target) {
            followed.track.target = false;
            followed.track.existence = std::min(followed.track.existence, params_.life.birth_existence);
        }
    best->track.target = true;
    best->dropped = false;
    best->track.existence = std::max(best->track.existence, params_.life.picked_existence);
    if (best->track.state != TrackState::Tentative) designation_.reset();
}

}  // namespace echotrail
