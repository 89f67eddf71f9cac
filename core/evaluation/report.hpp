#pragma once

#include "core/evaluation/metric_table.hpp"
#include "core/evaluation/metrics.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace echotrail {

/// Everything a reader of an evaluation is told. All vectors by scene and column have the size of `scenes` and
/// `columns`; what was not run has no trials.
struct EvaluationReport {
    struct Scene {
        std::string name;
        std::string description;
    };
    /// One set of parameters.
    struct Column {
        std::string title;
        std::vector<std::string> settings;  ///< "name = value unit" of what is not the default
    };
    struct Verdict {
        std::string requirement, scene, column;
        std::optional<double> value;  ///< nothing: not measured
        bool met = false;
    };

    std::string program;  ///< name and version
    std::vector<Scene> scenes;
    std::vector<Column> columns;
    std::vector<std::vector<ScenarioSummary>> summaries;  ///< [scene][column]
    std::vector<std::vector<TrialResult>> examples;  ///< [scene][column]: the trial of the first seed, for pictures
    std::uint64_t first_seed = 0;
    int trials = 0;  ///< that were wanted of each scene and column
    bool interrupted = false;
    std::uint64_t lost_records = 0;  ///< of a recording that is damaged
    double memory_mb = 0.0;  ///< greatest of the whole program; 0: not measured
    std::vector<Verdict> verdicts;

    std::size_t trialsDone() const;
    std::size_t trialsWanted() const;
    /// All trials of a column, whatever the scene.
    ScenarioSummary overall(std::size_t column) const;
};

/// For a terminal: the published figures beside every column's, then the other headline figures scene by scene.
std::string textReport(const EvaluationReport& report);

/// Every figure, every trial. Names end in their units.
std::string jsonReport(const EvaluationReport& report);

/// A page that needs nothing beside it, with pictures.
std::string htmlReport(const EvaluationReport& report);

/// "6.2 (5.1 to 7.4), worst 9.9": a figure for a person, without its unit.
std::string valueText(const Metric& metric, const MetricValue& value);
/// Whether a figure is at most the share of the published one that was set as a goal.
bool meetsGoal(const Metric& metric, const MetricValue& value, std::string_view scene);

}  // namespace echotrail
