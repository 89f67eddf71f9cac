#pragma once

#include "core/runtime/scene_builder.hpp"
#include "core/runtime/timeline.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace echotrail {

/// A recording under the pipeline, as a tape deck without a motor: ReplayRunner turns it.
/// Going back means running the same pipeline again from the first ping, so that every position shows what a straight
/// run with the present parameters shows there.
/// Threads: none; one owner calls it. No call takes longer than a slice of the work.
/// Errors:  std::runtime_error where the source ends before the place it reached in scan().
class ReplayPlayer {
public:
    using Params = ScanningSonarPipeline::Params;

    /// `as_recorded`: `params` are those a recorded run began with, and its later changes count too, at their pings.
    ReplayPlayer(std::unique_ptr<PingSource> source, const Params& params, std::uint64_t seed,
                 bool as_recorded = false);

    /// Reads on through the source, noting the times of the pings. True once all are known: needed before the rest.
    bool scan();
    /// Runs a pipeline of its own, without a picture, on towards the end and notes sweeps and tracks in the timeline.
    /// True when the timeline is complete for the present parameters.
    bool analyse();

    /// Takes in the next ping, or at the end closes the last sweep. True when something was taken in; false where the
    /// source is still being wound to the place, or at the end.
    bool advance();
    /// Back to before the first ping.
    void restart();

    /// The same tracks go on with other parameters from the next ping; from now on what was recorded of them does not
    /// count.
    void setParams(const Params& params, std::uint64_t revision);
    /// As in the pipeline; remembered with the position, so that a run from the start meets it at the same ping.
    void designate(double range_m, Bearing from_bow);
    void clearDesignation();
    void drop(int track, double range_m, Bearing from_bow);
    void restore(int track);
    /// Whether scenes carry the locally enhanced picture too: some milliseconds each.
    void setEnhanced(bool on) { enhanced_ = on; }

    std::uint64_t position() const { return position_; }  ///< pings taken in
    std::uint64_t size() const { return timeline_.pings(); }
    bool atEnd() const { return at_end_; }
    bool sweepJustStarted() const { return latest_.sweep_ended; }
    Timestamp timeOf(std::uint64_t index) const { return (*timeline_.ping_times)[index]; }
    std::uint64_t scanned() const { return scanned_times_.size(); }
    const SourceInfo& info() const { return source_->info(); }
    const Timeline& timeline() const { return timeline_; }
    const SourceCounts& counts() const { return counts_; }
    bool designated() const;
    /// Those in force, where they follow the recording and have changed since the last call.
    std::optional<Params> takeRecordedParams();
    Scene scene() const;

private:
    /// A wish of the operator, and the position it was made at.
    struct Wish {
        std::uint64_t position = 0;
        RunControl control;
    };
    struct Analysis {
        std::unique_ptr<ScanningSonarPipeline> pipeline;
        Timeline timeline;
        bool followed = false;
    };

    bool windTo(std::uint64_t index);
    std::optional<Ping> read();
    Ping readKnown();
    void remember(const RunControl& control);
    void applyRecorded(ScanningSonarPipeline& pipeline);
    void applyWishesHere();

    std::unique_ptr<PingSource> source_;
    Params params_;
    std::uint64_t seed_ = 0;
    std::uint64_t revision_ = 0;
    std::unique_ptr<ScanningSonarPipeline> pipeline_;
    std::optional<SceneBuilder> builder_;
    std::optional<Analysis> analysis_;
    std::vector<Timestamp> scanned_times_;
    std::vector<Wish> wishes_;  ///< in the order of their positions
    Timeline timeline_;
    SourceCounts counts_;
    Ping ping_;
    Update latest_;
    std::uint64_t source_index_ = 0;  ///< pings read from the source since its start
    std::uint64_t position_ = 0;
    bool at_end_ = false;
    bool enhanced_ = false;
    bool as_recorded_ = false;
    bool params_told_ = false;
};

}  // namespace echotrail
