#pragma once

#include "core/base/result.hpp"
#include "core/pipelines/scanning_sonar_pipeline.hpp"

#include <optional>
#include <string>
#include <vector>

namespace echotrail {

/// The pipeline's parameters as the command line sets them.
struct Settings {
    ScanningSonarPipeline::Params params;
    std::optional<double> sound_speed;  ///< only where it was set: then it stands above what a recording stores
};

/// Files first (the name of a preset stands for one), then single NAME=VALUE over them, all over `base`. The error is a
/// matter of usage and names the parameter.
Result<Settings> readSettings(const std::vector<std::string>& files, const std::vector<std::string>& assignments,
                              const ScanningSonarPipeline::Params& base = {});

/// Every parameter with its unit, limits, default and meaning, by group: a part of `--help`.
std::string parameterHelp();
/// The same of any described parameters, under `title`.
std::string parameterHelp(const std::string& title, const std::vector<ParameterInfo>& infos);

}  // namespace echotrail
