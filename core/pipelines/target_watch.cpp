#include "core/pipelines/target_watch.hpp"

#include <algorithm>
#include <utility>

namespace echotrail {
namespace {

constexpr double longest_silence_s = 3.0;  // of the head; the slowest pings in some tenths of a second

}  // namespace

void TargetWatch::take(const Update& update, const ScanningSonarPipeline& pipeline) {
    heard_ = update.time;
    if (!update.navigation_gap) followOwnMotion(update);
    origin_ = pipeline.origin();
    const std::size_t before = fresh_.size();
    for (const TrackLook& look : update.looks) {
        if (look.target) fresh_.push_back(look);
        if (!look.target && target_ && look.track == target_->id) target_.reset();  // the designation was taken back
    }
    if (target_ && pipeline.isDropped(target_->id)) target_.reset();  // no look of it comes any more
    if (fresh_.size() == before) return;  // a copy of the particles, only where they have changed
    bool lives = false;
    for (Track& track : pipeline.tracks())
        if (track.target) {
            target_ = std::move(track);
            lives = true;
        }
    if (!lives && target_) target_->state = fresh_.back().state;  // its end is to be told, too
}

void TargetWatch::followOwnMotion(const Update& update) {
    constexpr double baseline_s = 1.0;  // from ping to ping a centimetre of a position would be a fast vehicle
    own_.pose = update.pose;
    own_time_ = update.time;
    if (!baseline_) baseline_ = {update.time, update.pose};
    const double passed_s = secondsBetween(baseline_->time, update.time);
    if (passed_s < baseline_s) return;
    own_.velocity_mps =
        Eigen::Vector2d(update.pose.north_m - baseline_->pose.north_m, update.pose.east_m - baseline_->pose.east_m) /
        passed_s;
    baseline_ = {update.time, update.pose};
}

/// Where the vehicle is by now, as it moved last.
OwnMotion TargetWatch::ownAt(Timestamp time) const {
    OwnMotion own = own_;
    const double passed_s = std::clamp(secondsBetween(own_time_, time), 0.0, longest_silence_s);
    own.pose.north_m += own.velocity_mps.x() * passed_s;
    own.pose.east_m += own.velocity_mps.y() * passed_s;
    return own;
}

std::vector<TargetReport> TargetWatch::reports(Timestamp now) {
    const std::vector<TrackLook> looks = std::exchange(fresh_, {});
    if (!target_) return {};
    std::vector<TargetReport> reports;
    for (const TrackLook& look : looks) {
        TargetReport report = reportOn(*target_, own_, look.time);
        report.look = look;
        report.age_s = std::max(report.age_s, 0.0);
        reports.push_back(report);
    }
    TargetReport report = reportOn(*target_, ownAt(now), now);
    // Where no ping comes, nothing can be missed, and a track would be confirmed for ever.
    if (secondsBetween(heard_, now) > longest_silence_s) {
        report.valid = false;
        report.look.state = TrackState::Lost;
    }
    reports.push_back(report);
    return reports;
}

}  // namespace echotrail
