#pragma once

#include "app/io/report_sender.hpp"
#include "core/navigation/local_plane.hpp"
#include "core/pipelines/target_watch.hpp"

#include <memory>
#include <mutex>
#include <optional>

namespace echotrail {

/// Sends a motion controller what is known of the designated target (TargetWatch).
/// Threads: take() on the pipeline's, the rest on the one it was made in.
class TargetFeed {
public:
    /// The address's format says JSON lines or NMEA 0183. The error is a matter of usage.
    static Result<std::unique_ptr<TargetFeed>> open(const LinkAddress& address);

    void take(const Update& update, const ScanningSonarPipeline& pipeline);
    /// Sends the looks that take() brought since the last call, and the prediction for `now`. `plane` is navigation's;
    /// without one nobody knows the target's latitude and longitude.
    void send(Timestamp now, Timestamp first_ping, const std::optional<LocalPlane>& plane);
    const ReportSender::Counts& counts() const { return sender_->counts(); }

private:
    TargetFeed(std::unique_ptr<ReportSender> sender, bool nmea) : nmea_(nmea), sender_(std::move(sender)) {}
    void say(const TargetReport& report, Timestamp first_ping, const std::optional<LocalPlane>& plane);

    bool nmea_;
    std::unique_ptr<ReportSender> sender_;
    std::mutex mutex_;
    TargetWatch watch_;
};

}  // namespace echotrail
