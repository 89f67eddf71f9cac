#pragma once

#include "core/data/pose.hpp"
#include "core/data/track.hpp"
#include "core/pipelines/scanning_sonar_pipeline.hpp"
#include "core/tracking/target_report.hpp"

#include <optional>
#include <vector>

namespace echotrail {

/// What a motion controller is told of the designated target: every look at it, and when it is asked for where it is by
/// then as predicted. Where the head has been silent for 3 s, what is said is invalid.
/// Order: take() after each ping; reports() at any time. State: target, own motion, looks that were not told yet.
class TargetWatch {
public:
    void take(const Update& update, const ScanningSonarPipeline& pipeline);
    /// The looks that take() brought since the last call, and the prediction for `now`; nothing without a target.
    std::vector<TargetReport> reports(Timestamp now);
    /// Of the local frame, in the frame of navigation.
    const std::optional<Pose>& origin() const { return origin_; }

private:
    void followOwnMotion(const Update& update);
    OwnMotion ownAt(Timestamp time) const;

    std::optional<Track> target_;
    OwnMotion own_;
    Timestamp own_time_{}, heard_{};     ///< of own_; of the last ping
    std::optional<Pose> origin_;
    std::optional<TimedPose> baseline_;  ///< what the own velocity is measured from
    std::vector<TrackLook> fresh_;
};

}  // namespace echotrail
