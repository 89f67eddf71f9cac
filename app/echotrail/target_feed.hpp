#pragma once

#include "app/io/byte_channel.hpp"
#include "core/data/track.hpp"
#include "core/pipelines/scanning_sonar_pipeline.hpp"
#include "core/tracking/target_report.hpp"

#include <memory>
#include <mutex>
#include <optional>

namespace echotrail {

/// What the motion controller is told of the designated target: at every update, and by prediction in between.
/// Threads: take() on the pipeline's, the rest on the one of its channel.
class TargetFeed {
public:
    /// The address's format says JSON lines or NMEA 0183.
    explicit TargetFeed(const LinkAddress& address);

    void take(const Update& update, const ScanningSonarPipeline& pipeline);
    /// Sends what take() brought since the last call, or else the prediction for `now`.
    void send(Timestamp now, Timestamp first_ping);
    const ChannelCounts& counts() const { return channel_->counts(); }
    std::uint64_t sent() const { return sent_; }

private:
    QByteArray text(const TargetReport& report, Timestamp first_ping) const;

    bool nmea_;
    std::unique_ptr<ByteChannel> channel_;
    std::mutex mutex_;
    std::optional<Track> target_;
    OwnMotion own_;
    std::optional<Timestamp> own_time_;
    std::vector<TrackLook> fresh_;
    std::uint64_t sent_ = 0;
};

}  // namespace echotrail
