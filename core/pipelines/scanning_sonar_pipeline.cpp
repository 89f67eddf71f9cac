#include "core/pipelines/scanning_sonar_pipeline.hpp"

namespace echotrail {

ScanningSonarPipeline::ScanningSonarPipeline(const Params& params, std::uint64_t) : params_(params) {}
const Update& ScanningSonarPipeline::process(const Ping& ping, const PoseHistory&) {
    update_ = Update{.ping = ping.sequence, .time = ping.time, .beam = ping.bearing};
    return update_;
}
const Update& ScanningSonarPipeline::finish() { return update_; }
void ScanningSonarPipeline::setParams(const Params& params) { params_ = params; }
void ScanningSonarPipeline::designate(double, Bearing) {}
void ScanningSonarPipeline::clearDesignation() {}
void ScanningSonarPipeline::setFanPainting(bool) {}

}  // namespace echotrail
