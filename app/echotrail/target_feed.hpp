#pragma once

#include "app/io/report_sender.hpp"
#include "core/data/pose.hpp"
#include "core/data/track.hpp"
#include "core/navigation/local_plane.hpp"
#include "core/pipelines/scanning_sonar_pipeline.hpp"
#include "core/tracking/target_report.hpp"

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace echotrail {

/// What the motion controller is told of the designated target: every look at it, and at a steady rate where it is by
/// now as predicted. Where the head has been silent for 3 s, what is said is invalid.
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
    void followOwnMotion(const Update& update);
    OwnMotion ownAt(Timestamp time) const;
    void say(const TargetReport& report, Timestamp first_ping, const std::optional<LocalPlane>& plane);

    bool nmea_;
    std::unique_ptr<ReportSender> sender_;
    std::mutex mutex_;
    std::optional<Track> target_;
    OwnMotion own_;
    Timestamp own_time_{}, heard_{};     ///< of own_; of the last ping
    std::optional<Pose> origin_;         ///< of the local frame, in the frame of navigation
    std::optional<TimedPose> baseline_;  ///< what the own velocity is measured from
    std::vector<TrackLook> fresh_;
};

}  // namespace echotrail
