#pragma once

#include "core/pipelines/scanning_sonar_pipeline.hpp"
#include "core/runtime/scene.hpp"

#include <vector>

namespace echotrail {

/// Gathers over a run what a Scene shows beyond the latest update: the regions of the last turn of the beam, the
/// sweep's duration and its edges.
/// Order: add() once per ping, in time order.
class SceneBuilder {
public:
    void add(const Ping& ping, const Update& update, double processor_seconds);
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
    double mean_microseconds_ = 0.0;
};

}  // namespace echotrail
