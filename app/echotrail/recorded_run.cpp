#include "recorded_run.hpp"

#include "settings.hpp"

namespace echotrail {

Result<RecordedRunSettings> RecordedRunSettings::of(const PingSource& source, Overrides overrides) {
    RecordedRunSettings settings;
    settings.overrides_ = std::move(overrides);
    const Overrides& over = settings.overrides_;
    const auto run = source.recordedRun();
    if (auto set = settings.setParams(run ? run->parameters : ""); !set) return Error{set.error()};
    settings.seed_ = over.seed.value_or(run ? run->seed : 0);
    if (!run) return settings;
    if (over.seed && *over.seed != run->seed) settings.overridden_.push_back("seed");
    if (!over.parameter_files.empty() || !over.assignments.empty()) settings.overridden_.push_back("parameters");
    if (over.designation) settings.overridden_.push_back("designations");
    return settings;
}

/// Names that this program does not have are passed over: an older or newer one recorded them.
Result<void> RecordedRunSettings::setParams(const std::string& recorded) {
    ScanningSonarPipeline::Params params;
    if (const auto passed_over = applyRecordedParameters(params, recorded); !passed_over)
        return Error{passed_over.error()};
    const auto settings = readSettings(overrides_.parameter_files, overrides_.assignments, params);
    if (!settings) return Error{settings.error()};
    params_ = settings->params;
    return {};
}

void RecordedRunSettings::apply(const std::vector<RunControl>& controls, ScanningSonarPipeline& pipeline) {
    for (const RunControl& control : controls) {
        switch (control.kind) {
            case RunControl::Kind::Parameters:
                // What cannot be read changes nothing; the source has counted it.
                if (setParams(control.parameters)) pipeline.setParams(params_);
                break;
            case RunControl::Kind::Designation:
            case RunControl::Kind::ClearDesignation:
                if (!overrides_.designation) pipeline.command(control);
                break;
            case RunControl::Kind::Drop:
            case RunControl::Kind::Restore:
                pipeline.command(control);
                break;
        }
    }
}

}  // namespace echotrail
