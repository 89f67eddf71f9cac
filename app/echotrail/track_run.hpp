#pragma once

#include "app/io/byte_channel.hpp"
#include "core/runtime/live_runner.hpp"
#include "core/seanet/head_session.hpp"
#include "target_feed.hpp"
#include "track_options.hpp"
#include "tracks_writer.hpp"

#include <nlohmann/json.hpp>

#include <QObject>
#include <QTimer>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace echotrail {

/// `echotrail track`: a head's channel, the session with it, and the runner behind them. This thread only moves bytes:
/// it hands them to the runner (and so to the log) first, then to the session, and sends what that answers.
class TrackRun : public QObject {
public:
    TrackRun(const TrackOptions& options, std::unique_ptr<LogWriter> log, std::unique_ptr<TracksWriter> tracks);

    void start();
    /// Ends the run and says how it went.
    nlohmann::ordered_json finish(const std::string& reason);
    /// Why the tracks could not be written; empty where they could.
    std::string failure() const;
    /// What was lost, for a person; empty where nothing was.
    std::string losses() const;
    LiveRunner& runner() { return runner_; }
    TracksWriter* tracks() { return tracks_.get(); }
    QTimer& failed() { return failed_; }

private:
    void hear(const Update& update, Timestamp settled, const ScanningSonarPipeline& pipeline);
    void connectSonar();
    void connectNavigation();
    void converse();
    void tellHealth();
    void note(const std::string& text) const;
    Microseconds now() const;

    TrackOptions options_;
    std::unique_ptr<TracksWriter> tracks_;
    std::unique_ptr<TargetFeed> feed_;
    std::unique_ptr<ByteChannel> sonar_, navigation_;
    seanet::HeadSession session_;
    seanet::HeadState last_state_ = seanet::HeadState::NoLink;
    std::string last_difference_, last_advice_;
    QTimer deadline_, health_, reports_, failed_;
    std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
    std::uint64_t pings_told_ = 0;
    bool disk_told_ = false, log_told_ = false;

    mutable std::mutex mutex_;  ///< of what the pipeline's thread writes
    std::string failure_;
    std::optional<Timestamp> first_ping_;

    LiveRunner runner_;  // last: its threads end before what they use
};

}  // namespace echotrail
