#pragma once

#include "core/data/event.hpp"
#include "core/pipelines/scanning_sonar_pipeline.hpp"
#include "core/recording/ping_feed.hpp"
#include "core/runtime/bounded_queue.hpp"
#include "core/runtime/latest.hpp"
#include "core/runtime/recorder.hpp"
#include "core/runtime/run_timeline.hpp"
#include "core/runtime/scene_builder.hpp"

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace echotrail {

/// What a live run is doing, for a person to read.
struct LiveStatus {
    std::uint64_t events = 0;
    std::uint64_t pings = 0;    ///< taken in by the tracker
    std::uint64_t skipped = 0;  ///< that it could not take in time
    std::uint64_t sweeps = 0;
    std::uint64_t confirmed = 0;     ///< tracks, at any time so far
    std::uint64_t without_pose = 0;  ///< pings for which navigation said nothing
    std::uint64_t unsynchronised = 0;
    SourceCounts counts;
    NavigationStatus navigation;
    bool navigation_expected = false;
    std::size_t queued = 0;  ///< events the tracker has not looked at
    double lag_s = 0.0;      ///< from an event's arrival to the end of its processing, the last one
    double processing_s = 0.0;
    std::optional<Timestamp> first_ping, last_ping;
    RecorderStatus recorder;
};

/// A live run: what arrives is stamped, numbered, recorded, and only then thought about; the pipeline has its own
/// thread, the log another.
/// Threads: post() and the commands from any thread; they return at once. The listener is called on the pipeline's
///          thread. Destruction takes in what was posted, closes the log and joins.
/// Promise: who replays the recorded events through PingFeed and pipeline gets the same updates, bit for bit.
class LiveRunner {
public:
    using Params = ScanningSonarPipeline::Params;
    /// An update, and the moment before which none can follow.
    using Listener = std::function<void(const Update&, Timestamp settled, const ScanningSonarPipeline&)>;

    /// Time since the run's beginning by a clock that never jumps; called on any thread.
    using Clock = std::function<Microseconds()>;

    /// Without `log` nothing is recorded; without `clock` it is the computer's own.
    LiveRunner(const Params& params, std::uint64_t seed, std::unique_ptr<LogWriter> log, Listener listener = {},
               Clock clock = {});
    ~LiveRunner();
    LiveRunner(const LiveRunner&) = delete;
    LiveRunner& operator=(const LiveRunner&) = delete;

    /// Bytes or text of a kind other than the commands' below; stamped with now.
    void post(EventKind kind, std::vector<std::uint8_t> payload);
    void setParams(const Params& params);
    void designate(double range_m, Bearing from_bow);
    void clearDesignation();
    /// As in the pipeline.
    void drop(int track, double range_m, Bearing from_bow);
    void restore(int track);
    void setFanPainting(bool on) { paint_fan_ = on; }
    /// Whether scenes carry the locally enhanced picture too: some milliseconds each, on the pipeline's thread.
    void setEnhanced(bool on) { enhanced_ = on; }

    /// Ends the run: everything posted is taken in and the last sweep closed.
    void finish();
    /// After finish(), and what is still to be recorded (the summary): waits until all of it is on disk. A log that is
    /// closed holds a summary: where none was recorded, one that tells the number of pings.
    void closeLog();

    Latest<Scene>& scenes() { return scenes_; }
    Latest<Timeline>& timelines() { return timelines_; }
    LiveStatus status() const;
    /// What the head is to scan, where it follows the target (ScanningSonarPipeline::sector()), as of the last ping;
    /// nothing where it is to scan the sector of the parameters. From any thread.
    std::optional<ScanSector> sector() const;
    /// The ping of the update that the listener is told of, and whether poses are measured: for the listener only, on
    /// the pipeline's thread.
    const Ping& lastPing() const { return last_ping_; }
    bool navigationKnown() const { return !feed_.navigation().empty(); }
    /// Of the pings, so that other outputs agree with the log's times.
    Timestamp now() const;
    /// A row for the log that is no event: the summary.
    void record(ResultRow row);

private:
    void run();
    void postLocked(EventKind kind, std::vector<std::uint8_t> payload);
    void takePings(Microseconds arrived);
    void process(const Ping& ping);
    std::optional<LocalPlane> planeOfPings() const;
    void apply(const RunControl& control);
    void tell(const Update& update, Timestamp settled);
    void skip(const Ping& ping);
    void recordSkips();
    void updateStatus(Microseconds arrived);
    Microseconds elapsed() const { return clock_(); }

    const Timestamp started_;
    const Clock clock_;
    std::mutex post_mutex_;  ///< one number after the other, in the same order for log and tracker
    std::uint64_t next_number_ = 0;
    std::unique_ptr<Recorder> recorder_;
    std::atomic<bool> summed_up_ = false;
    BoundedQueue<Event> events_;
    Listener listener_;
    std::atomic<bool> paint_fan_ = true;
    std::atomic<bool> enhanced_ = false;

    // The pipeline thread's own
    ScanningSonarPipeline pipeline_;
    PingFeed feed_;
    SceneBuilder builder_;
    RunTimeline run_timeline_;
    bool follows_ = false;  ///< as of the last scene
    Ping last_ping_;
    Update last_update_;
    double processing_s_ = 0.0;
    std::uint64_t without_pose_ = 0;
    std::uint64_t skipped_ = 0, taken_ = 0;
    std::vector<std::uint64_t> skips_to_record_;
    std::optional<Timestamp> first_ping_;

    mutable std::mutex status_mutex_;
    LiveStatus status_;
    std::optional<ScanSector> sector_;
    Latest<Scene> scenes_;
    Latest<Timeline> timelines_;
    std::jthread thread_;  // last, so that it ends before what it uses
};

}  // namespace echotrail
