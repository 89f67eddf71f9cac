#pragma once

#include "core/pipelines/scanning_sonar_pipeline.hpp"
#include "core/runtime/latest.hpp"
#include "core/runtime/scene.hpp"
#include "core/runtime/timeline.hpp"

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace echotrail {

enum class ReplayState { Loading, Paused, Playing, Ended, Failed };

/// What a replay is doing, for a person to read.
struct ReplayStatus {
    ReplayState state = ReplayState::Loading;
    std::uint64_t position = 0;  ///< pings taken in
    std::uint64_t goal = 0;      ///< where a seek or re-run is heading; equal to `position` when there
    std::uint64_t total = 0;     ///< pings in the recording; while loading: those found so far
    double speed = 1.0;          ///< as asked for
    std::uint64_t revision = 0;  ///< of the parameters in force
    bool designated = false;     ///< the operator has a target, found or still awaited
    bool analysing = false;      ///< the timeline is being worked out
    std::string error;           ///< why it failed: one line
    bool operator==(const ReplayStatus&) const = default;
};

/// Plays a recording through the pipeline on a thread of its own.
/// Threads: commands and queries from any thread; they return at once. Destruction stops and joins.
/// Promise: no ping is left out, whatever the speed; at every position the tracks are those of a straight run, except
///          after a change of parameters during play, which takes hold at that ping until the next seek or re-run.
class ReplayRunner {
public:
    using Params = ScanningSonarPipeline::Params;
    static constexpr double max_speed = std::numeric_limits<double>::infinity();

    /// Starts paused before the first ping.
    /// `as_recorded`: `params` are those a recorded run began with; until setParams() its later changes count too.
    ReplayRunner(std::unique_ptr<PingSource> source, const Params& params, std::uint64_t seed,
                 bool as_recorded = false);
    ~ReplayRunner();
    ReplayRunner(const ReplayRunner&) = delete;
    ReplayRunner& operator=(const ReplayRunner&) = delete;

    void play();  ///< at the end: from the start again
    void pause();
    void stepPings(std::int64_t count);  ///< negative: back; pauses
    void stepSweep(int direction);       ///< to the first ping of the next (+1) or previous (−1) sweep; pauses
    void seek(std::uint64_t position);   ///< so many pings taken in; playing goes on from there
    void seekTime(Timestamp time);
    void cancel();  ///< ends a seek or re-run where it is
    /// Seconds of the recording per second: above 0, or max_speed.
    void setSpeed(double factor);
    /// During play from the next ping; while paused the recording is run again up to the present position.
    void setParams(const Params& params, std::uint64_t revision);
    void designate(double range_m, Bearing from_bow);
    void clearDesignation();
    void drop(int track, double range_m, Bearing from_bow);
    void restore(int track);
    void setEnhanced(bool on);  ///< scenes carry the locally enhanced picture too
    /// Play returns to `begin` at `end`; none: plays to the end.
    void setLoop(std::optional<PingSpan> loop);

    Latest<Scene>& scenes() { return scenes_; }
    Latest<Timeline>& timelines() { return timelines_; }
    /// The parameters in force where they follow the recording, whenever they have changed.
    Latest<Params>& recordedParams() { return recorded_params_; }
    ReplayStatus status() const;

private:
    class Loop;
    using Command = std::function<void(Loop&)>;
    void post(Command command);

    mutable std::mutex mutex_;
    std::condition_variable_any wake_;
    std::vector<Command> commands_;
    ReplayStatus status_;
    Latest<Scene> scenes_;
    Latest<Timeline> timelines_;
    Latest<Params> recorded_params_;
    std::jthread thread_;  // last, so that it ends before what it uses
};

}  // namespace echotrail
