#pragma once

#include "core/data/beam_line.hpp"
#include "core/pipelines/scanning_sonar_pipeline.hpp"
#include "core/runtime/scene.hpp"

#include <vector>

namespace echotrail {

/// Gathers over a run what a Scene shows beyond the latest update: the regions of the last turn of the beam, the
/// sweep's duration and its edges, the echo lines by bearing, earlier sweeps, and the paths.
/// Order: add() once per ping, in time order.
class SceneBuilder {
public:
    void add(const Ping& ping, const Update& update, double processor_seconds);
    /// The same with what the pipeline has seen: the picture, and the echo line with its threshold.
    void add(const Ping& ping, const Update& update, double processor_seconds, const ScanningSonarPipeline& pipeline);
    /// The picture as it is after a ping that was added.
    void addPicture(const FanImage& fan, const Update& update);
    void addLine(BeamLine line);
    /// Regions that the end of the source closed.
    void addFinal(const Update& update);

    /// Copies what the eye needs; the pixels of the fan are cloned.
    Scene build(const ScanningSonarPipeline& pipeline, const Ping& ping, const Update& update) const {
        return build(pipeline.fan(), pipeline.tracks(), ping, update);
    }
    Scene build(const FanImage& fan, std::vector<Track> tracks, const Ping& ping, const Update& update) const;

private:
    /// The edges are those this sweep has reached.
    void takeEdges(double step_rad);
    /// The edges are those of the last whole sweep, unless this one goes further.
    void widenEdges(Bearing beam);
    void followSweep(const Ping& ping, const Update& update);

    std::vector<Region> regions_;
    Timestamp pictured_{};  ///< when there last was an echo line
    Timestamp sweep_start_{};
    double sweep_s_ = 0.0;
    double turned_rad_ = 0.0;  ///< from the first bearing of this sweep, clockwise positive
    double least_rad_ = 0.0;   ///< extremes of turned_rad_ in this sweep
    double most_rad_ = 0.0;
    Bearing sweep_origin_;
    Bearing last_bearing_;
    Bearing left_;
    Bearing right_;
    bool whole_sweep_ = false;
    bool started_ = false;
    bool turns_clockwise_ = true;
    double mean_microseconds_ = 0.0;
    std::vector<std::shared_ptr<const BeamLine>> lines_;
    std::shared_ptr<const BeamLine> live_line_;
    EchoMemory memory_;
    PathKeeper keeper_;
};

/// A ping without the detection's view of it: its levels in cells of a line, and no threshold.
BeamLine lineOf(const Ping& ping, const Update& update);

}  // namespace echotrail
