#pragma once

#include "app/io/head_link.hpp"
#include "app/io/tracker_service.hpp"
#include "core/runtime/live_runner.hpp"
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

/// `echotrail track`: a live run, its links, what it writes, and what it says of itself.
class TrackRun : public QObject {
public:
    TrackRun(const TrackOptions& options, std::unique_ptr<LogWriter> log, std::unique_ptr<TracksWriter> tracks,
             std::unique_ptr<TargetFeed> feed);

    /// Serves consoles where that is asked for; the error says why it cannot be done. Before start().
    Result<void> serve();
    /// From here on an event loop must run. It is told to quit when the tracks cannot be written.
    void start();
    /// Ends the run and says how it went.
    nlohmann::ordered_json finish(const std::string& reason);
    /// Why the tracks could not be written; empty where they could.
    std::string failure() const;
    /// What was lost, for a person; empty where nothing was.
    std::string losses() const;
    TracksWriter* tracks() { return tracks_.get(); }

private:
    void hear(const Update& update, Timestamp settled, const ScanningSonarPipeline& pipeline);
    void tellHealth();
    /// To standard error and to the consoles.
    void tell(LinkLog::Weight weight, const std::string& text);

    TrackOptions options_;
    std::unique_ptr<TracksWriter> tracks_;
    std::unique_ptr<TargetFeed> feed_;
    QTimer health_, reports_;
    std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
    std::uint64_t pings_told_ = 0;
    DiskState disk_told_ = DiskState::Good;
    bool log_told_ = false;

    mutable std::mutex mutex_;  ///< of what the pipeline's thread writes
    std::string failure_;
    std::optional<Timestamp> first_ping_;

    LiveRunner runner_;  // its threads end before what they use
    std::unique_ptr<HeadLink> link_;
    std::unique_ptr<TrackerService> service_;
};

}  // namespace echotrail
