#pragma once

#include "core/evaluation/metrics.hpp"

#include <optional>
#include <span>
#include <string_view>

namespace echotrail {

/// What one scenario and one set of parameters come to in one respect.
struct MetricValue {
    double value = 0.0;
    std::optional<ConfidenceInterval> interval;  ///< 95 %
    std::optional<double> worst;                 ///< of the trials
    std::optional<ConfidenceInterval> expected;  ///< where it lies in 95 % of cases if all is as it should be
};

/// A published sea trial (Zhang, Wan, Zeng & Xu; method card, section h). S1 to S5 are built after them.
struct PublishedTrial {
    std::string_view scenario;
    std::size_t looks = 0, correct = 0;
    double loss_percent = 0.0;
    double deviation_max_m = 0.0, deviation_mean_m = 0.0;
};
std::span<const PublishedTrial> publishedTrials();
/// Nothing for scenarios of our own.
const PublishedTrial* publishedTrial(std::string_view scenario);

/// One row of the report: from here grow the text table, the JSON, the pages and what --require understands.
struct Metric {
    enum class Better { Lower, Higher };
    std::string_view name;  ///< in JSON and for --require; ends in its unit
    std::string_view title;
    std::string_view unit;
    int decimals = 2;
    Better better = Better::Lower;
    std::string_view meaning;
    /// Nothing where there is nothing to average.
    std::optional<MetricValue> (*of)(const ScenarioSummary&) = nullptr;
    std::optional<double> (*published)(const PublishedTrial&) = nullptr;
    bool headline = false;  ///< in the short table
    bool pools = false;     ///< makes sense over all scenes together
};
std::span<const Metric> metricTable();
const Metric* findMetric(std::string_view name);

/// A goal that was set for a published figure is met at this share of it.
inline constexpr double goal_share = 0.5;

/// "NAME=VALUE", in front of it "COLUMN:" or "SCENE/" or both to ask it of those alone.
struct Requirement {
    std::string text;
    std::string column;  ///< empty: all that are judged
    std::string scene;   ///< empty: all
    const Metric* metric = nullptr;
    double limit = 0.0;
};
Result<Requirement> parseRequirement(const std::string& text);
/// The limit itself is allowed. What could not be measured does not meet any limit.
bool meets(const Requirement& requirement, const ScenarioSummary& summary);

}  // namespace echotrail
