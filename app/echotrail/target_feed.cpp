#include "target_feed.hpp"

#include "core/navigation/target_sentences.hpp"
#include "tracks_writer.hpp"

#include <algorithm>

namespace echotrail {
namespace {

constexpr double longest_silence_s = 3.0;  // of the head; the slowest pings in some tenths of a second

}  // namespace

Result<std::unique_ptr<TargetFeed>> TargetFeed::open(const LinkAddress& address) {
    auto sender = ReportSender::open(address);
    if (!sender) return Error{sender.error()};
    return std::unique_ptr<TargetFeed>(new TargetFeed(*std::move(sender), address.format == "nmea"));
}

void TargetFeed::take(const Update& update, const ScanningSonarPipeline& pipeline) {
    const std::scoped_lock lock(mutex_);
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

void TargetFeed::followOwnMotion(const Update& update) {
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
OwnMotion TargetFeed::ownAt(Timestamp time) const {
    OwnMotion own = own_;
    const double passed_s = std::clamp(secondsBetween(own_time_, time), 0.0, longest_silence_s);
    own.pose.north_m += own.velocity_mps.x() * passed_s;
    own.pose.east_m += own.velocity_mps.y() * passed_s;
    return own;
}

void TargetFeed::send(Timestamp now, Timestamp first_ping, const std::optional<LocalPlane>& plane) {
    const std::scoped_lock lock(mutex_);
    if (!target_) return fresh_.clear();
    for (const TrackLook& look : fresh_) {
        TargetReport report = reportOn(*target_, own_, look.time);
        report.look = look;
        report.age_s = std::max(report.age_s, 0.0);
        say(report, first_ping, plane);
    }
    fresh_.clear();
    TargetReport report = reportOn(*target_, ownAt(now), now);
    // Where no ping comes, nothing can be missed, and a track would be confirmed for ever.
    if (secondsBetween(heard_, now) > longest_silence_s) {
        report.valid = false;
        report.look.state = TrackState::Lost;
    }
    say(report, first_ping, plane);
}

void TargetFeed::say(const TargetReport& report, Timestamp first_ping, const std::optional<LocalPlane>& plane) {
    const TrackLook& look = report.look;
    if (nmea_) {
        // Without the line feed, which the sender adds.
        const auto send = [this](const std::string& line) { sender_->send({line.data(), line.size() - 1}); };
        send(ttmSentence(look, report.closest_approach_m, report.time_to_closest_s));
        if (plane && origin_)
            send(tllSentence(look, plane->toGeographic({origin_->north_m + look.position_m.x(),
                                                        origin_->east_m + look.position_m.y()})));
        return;
    }
    auto object = trackLine(look, first_ping);
    object["age_s"] = report.age_s;
    object["valid"] = report.valid;
    object["closest_approach_m"] = report.closest_approach_m;
    object["time_to_closest_s"] = report.time_to_closest_s;
    object["risk"] = report.risk;
    sender_->send(object.dump());
}

}  // namespace echotrail
