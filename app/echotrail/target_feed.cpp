#include "target_feed.hpp"

#include "core/navigation/target_sentences.hpp"
#include "core/tracking/track_text.hpp"

namespace echotrail {

Result<std::unique_ptr<TargetFeed>> TargetFeed::open(const LinkAddress& address) {
    auto sender = ReportSender::open(address);
    if (!sender) return Error{sender.error()};
    return std::unique_ptr<TargetFeed>(new TargetFeed(*std::move(sender), address.format == "nmea"));
}

void TargetFeed::take(const Update& update, const ScanningSonarPipeline& pipeline) {
    const std::scoped_lock lock(mutex_);
    watch_.take(update, pipeline);
}

void TargetFeed::send(Timestamp now, Timestamp first_ping, const std::optional<LocalPlane>& plane) {
    const std::scoped_lock lock(mutex_);
    for (const TargetReport& report : watch_.reports(now)) say(report, first_ping, plane);
}

void TargetFeed::say(const TargetReport& report, Timestamp first_ping, const std::optional<LocalPlane>& plane) {
    const TrackLook& look = report.look;
    if (nmea_) {
        // Without the line feed, which the sender adds.
        const auto send = [this](const std::string& line) { sender_->send({line.data(), line.size() - 1}); };
        send(ttmSentence(look, report.closest_approach_m, report.time_to_closest_s));
        if (const auto& origin = watch_.origin(); plane && origin)
            send(tllSentence(look, plane->toGeographic({origin->north_m + look.position_m.x(),
                                                        origin->east_m + look.position_m.y()})));
        return;
    }
    sender_->send(reportLine(report, first_ping).dump());
}

}  // namespace echotrail
