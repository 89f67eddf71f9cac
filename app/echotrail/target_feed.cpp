#include "target_feed.hpp"

#include "core/navigation/target_sentences.hpp"
#include "tracks_writer.hpp"

namespace echotrail {

Result<std::unique_ptr<TargetFeed>> TargetFeed::open(const LinkAddress& address) {
    auto sender = ReportSender::open(address);
    if (!sender) return Error{sender.error()};
    return std::unique_ptr<TargetFeed>(new TargetFeed(*std::move(sender), address.format == "nmea"));
}

void TargetFeed::take(const Update& update, const ScanningSonarPipeline& pipeline) {
    const std::scoped_lock lock(mutex_);
    if (!update.navigation_gap) followOwnMotion(update);
    bool looked_at = false;
    for (const TrackLook& look : update.looks)
        if (look.target) {
            fresh_.push_back(look);
            looked_at = true;
        }
    if (!looked_at) return;  // a copy of the particles, only where they have changed
    target_.reset();
    for (Track& track : pipeline.tracks())
        if (track.target) target_ = std::move(track);
}

void TargetFeed::followOwnMotion(const Update& update) {
    constexpr double baseline_s = 1.0;  // from ping to ping a centimetre of a position would be a fast vehicle
    own_.pose = update.pose;
    if (!baseline_) baseline_ = {update.time, update.pose};
    const double passed_s = secondsBetween(baseline_->time, update.time);
    if (passed_s < baseline_s) return;
    own_.velocity_mps =
        Eigen::Vector2d(update.pose.north_m - baseline_->pose.north_m, update.pose.east_m - baseline_->pose.east_m) /
        passed_s;
    baseline_ = {update.time, update.pose};
}

void TargetFeed::send(Timestamp now, Timestamp first_ping) {
    const std::scoped_lock lock(mutex_);
    if (!target_) {
        fresh_.clear();
        return;
    }
    if (fresh_.empty()) sender_->send(text(reportOn(*target_, own_, now), first_ping));
    for (const TrackLook& look : fresh_) {
        TargetReport report = reportOn(*target_, own_, look.time);
        report.look = look;
        report.age_s = std::max(report.age_s, 0.0);
        sender_->send(text(report, first_ping));
    }
    fresh_.clear();
}

/// Without the line feed, which the sender adds.
std::string TargetFeed::text(const TargetReport& report, Timestamp first_ping) const {
    if (nmea_) {
        std::string sentence = ttmSentence(report.look, report.closest_approach_m, report.time_to_closest_s);
        sentence.pop_back();
        return sentence;
    }
    auto object = trackLine(report.look, first_ping);
    object["age_s"] = report.age_s;
    object["valid"] = report.valid;
    object["closest_approach_m"] = report.closest_approach_m;
    object["time_to_closest_s"] = report.time_to_closest_s;
    object["risk"] = report.risk;
    return object.dump();
}

}  // namespace echotrail
