#pragma once

#include "core/link/link_values.hpp"
#include "core/pipelines/scanning_sonar_pipeline.hpp"

namespace echotrail {

/// What an update has brought about, for the consoles: a copy, particles included. Without a beam where `update`
/// belongs to no ping of its own (the end of a run), or to one whose bearing nobody knows.
LinkMoment linkMoment(const Ping& ping, const Update& update, const ScanningSonarPipeline& pipeline,
                      Timestamp first_ping, bool navigation_known);

/// All parameters by their names.
std::vector<NamedValue> namedValues(const ScanningSonarPipeline::Params& params);

/// Sets what is named; fails where a name or a value is not allowed, and then nothing has changed.
Result<void> setNamedValues(ScanningSonarPipeline::Params& params, const std::vector<NamedValue>& values);

}  // namespace echotrail
