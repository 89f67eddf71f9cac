#include "core/runtime/link_moment.hpp"

namespace echotrail {

LinkMoment linkMoment(const Ping& ping, const Update& update, const ScanningSonarPipeline& pipeline,
                      Timestamp first_ping, bool navigation_known) {
    LinkMoment moment{
        .time = update.time, .regions = update.regions, .tracks = pipeline.tracks(), .looks = update.looks};
    if (ping.motor_lost_sync || ping.sequence != update.ping) return moment;
    LinkBeam& beam = moment.beam.emplace();
    beam.ping = ping;
    beam.update = update;
    beam.update.regions.clear();
    beam.update.looks.clear();
    beam.mount = pipeline.params().head;
    beam.first_ping = first_ping;
    beam.navigation_known = navigation_known;
    return moment;
}

std::vector<NamedValue> namedValues(const ScanningSonarPipeline::Params& params) {
    static const auto infos = describeParameters<ScanningSonarPipeline::Params>();
    const auto values = parameterValues(params);
    std::vector<NamedValue> named;
    for (std::size_t i = 0; i < infos.size(); ++i) named.emplace_back(infos[i].name, values[i]);
    return named;
}

Result<void> setNamedValues(ScanningSonarPipeline::Params& params, const std::vector<NamedValue>& values) {
    ScanningSonarPipeline::Params changed = params;
    for (const auto& [name, value] : values)
        if (auto set = setParameter(changed, name, value); !set) return set;
    params = changed;
    return {};
}

}  // namespace echotrail
