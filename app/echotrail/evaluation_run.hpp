#pragma once

#include "core/base/result.hpp"
#include "core/evaluation/report.hpp"
#include "core/pipelines/scanning_sonar_pipeline.hpp"
#include "core/simulation/scenario.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace echotrail {

/// What is to be evaluated: every scene with every set of parameters, once for every seed.
struct EvaluationPlan {
    /// A scenario, or a recording with its truth.
    struct Scene {
        std::string name, description;
        std::optional<Scenario> scenario;
        std::string recording, truth_csv;  ///< path, and the text of the truth file
    };
    struct Column {
        std::string title;
        std::vector<ScanningSonarPipeline::Params> params;  ///< in each scene
        std::optional<double> sound_speed;                  ///< set: it stands above what a recording stores
    };
    std::vector<Scene> scenes;
    std::vector<Column> columns;
    std::uint64_t first_seed = 1;
    int trials = 1;
    unsigned threads = 1;
};

/// How far a run has come.
struct EvaluationProgress {
    std::size_t done = 0, wanted = 0;  ///< trials
    std::string latest;                ///< what was done last, e.g. "S2, paper.toml, seed 4"
};

/// Runs all trials, seed by seed, so that one that is cancelled has gone through all scenes alike. The figures do not
/// depend on the number of threads. `tell` is called on this thread about five times a second. Fails where a recording
/// or its truth cannot be read; cancelled, it gives what is done.
Result<EvaluationReport> runEvaluation(const EvaluationPlan& plan,
                                       const std::function<void(const EvaluationProgress&)>& tell,
                                       const std::function<bool()>& cancelled);

}  // namespace echotrail
