#include "core/evaluation/report.hpp"

#include "core/evaluation/svg.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace echotrail {
namespace {

using Json = nlohmann::ordered_json;
using Rows = std::vector<std::vector<std::string>>;

constexpr std::string_view nothing = "-";
constexpr std::string_view published_title = "published";
constexpr std::string_view all_scenes = "all";

constexpr std::size_t most_columns = 6;  ///< beside one another; more go down the page

Rows transposed(const Rows& rows) {
    Rows turned(rows.front().size());
    for (const auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) turned[i].push_back(row[i]);
    return turned;
}

/// Columns two blanks apart, the first one left-aligned, the others too: cells hold more than a number.
std::string aligned(const Rows& rows) {
    std::vector<std::size_t> widths;
    for (const auto& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    }
    std::string text;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) line.append(row[i]).append(widths[i] - row[i].size() + 2, ' ');
        line.erase(line.find_last_not_of(' ') + 1);
        text.append(line).append("\n");
    }
    return text;
}

std::string cellText(const Metric& metric, const ScenarioSummary& summary, std::string_view scene) {
    const auto value = metric.of(summary);
    if (!value) return std::string(nothing);
    return valueText(metric, *value) + (meetsGoal(metric, *value, scene) ? " *" : "");
}

/// One figure over all scenes, beside what was published.
std::string comparison(const EvaluationReport& report, const Metric& metric) {
    Rows rows{{"", std::string(published_title)}};
    for (const auto& column : report.columns) rows[0].push_back(column.title);
    for (std::size_t s = 0; s < report.scenes.size(); ++s) {
        const PublishedTrial* trial = publishedTrial(report.scenes[s].name);
        const auto known = trial ? metric.published(*trial) : std::nullopt;
        rows.push_back({report.scenes[s].name, known ? fixedText(*known, metric.decimals) : std::string(nothing)});
        for (const ScenarioSummary& summary : report.summaries[s])
            rows.back().push_back(cellText(metric, summary, report.scenes[s].name));
    }
    if (metric.pools && report.scenes.size() > 1) {
        rows.push_back({std::string(all_scenes), std::string(nothing)});
        for (std::size_t c = 0; c < report.columns.size(); ++c)
            rows.back().push_back(cellText(metric, report.overall(c), all_scenes));
    }
    return std::string(metric.title)
        .append(", ")
        .append(metric.unit)
        .append("\n")
        .append(aligned(report.columns.size() > most_columns ? transposed(rows) : rows))
        .append("\n");
}

/// The other headline figures of a scene, and why looks were lost.
std::string sceneText(const EvaluationReport& report, std::size_t scene) {
    Rows rows{{report.scenes[scene].name}};
    for (const auto& column : report.columns) rows[0].push_back(column.title);
    for (const Metric& metric : metricTable()) {
        if (!metric.headline || metric.published) continue;
        rows.push_back({"  " + std::string(metric.title) + ", " + std::string(metric.unit)});
        for (const ScenarioSummary& summary : report.summaries[scene])
            rows.back().push_back(cellText(metric, summary, report.scenes[scene].name));
    }
    for (std::size_t cause = 1; cause < loss_causes; ++cause) {
        std::vector<std::string> row{"  Lost looks: " + std::string(toText(static_cast<LossCause>(cause)))};
        bool any = false;
        for (const ScenarioSummary& summary : report.summaries[scene]) {
            row.push_back(std::to_string(summary.pooled.causes[cause]));
            any |= summary.pooled.causes[cause] > 0;
        }
        if (any) rows.push_back(std::move(row));
    }
    const auto unlooked = [&](std::string_view title, auto count) {
        std::vector<std::string> row{std::string(title)};
        for (const ScenarioSummary& summary : report.summaries[scene])
            row.push_back(std::to_string(summary.pooled.*count));
        rows.push_back(std::move(row));
    };
    unlooked("  No look: outside the sector", &TrialMetrics::sweeps_outside_sector);
    unlooked("  No look: not yet scanned", &TrialMetrics::sweeps_unfinished);
    return aligned(rows) + "\n";
}

Json jsonOf(const ConfidenceInterval& interval) { return {interval.low, interval.high}; }

Json jsonOf(const Metric& metric, const ScenarioSummary& summary) {
    const auto value = metric.of(summary);
    if (!value) return nullptr;
    Json json{{"value", value->value}};
    if (value->interval) json["interval"] = jsonOf(*value->interval);
    if (value->worst) json["worst"] = *value->worst;
    if (value->expected) json["expected"] = jsonOf(*value->expected);
    return json;
}

Json jsonOfMetrics(const ScenarioSummary& summary) {
    Json json = Json::object();
    for (const Metric& metric : metricTable()) json[std::string(metric.name)] = jsonOf(metric, summary);
    return json;
}

/// Lost looks one by one, so that each can be found in the data.
Json lostLooks(const TrialMetrics& trial) {
    Json json = Json::array();
    for (const EvaluatedLook& look : trial.lost)
        json.push_back({{"time", toIso8601(look.time)},
                        {"outcome", toText(look.outcome)},
                        {"cause", toText(look.cause)},
                        {"tracker_says", toText(look.told)},
                        {"true_range_m", look.true_range_m},
                        {"true_bearing_deg", look.true_bearing.inDegrees()},
                        {"track", look.track},
                        {"contrast_db", look.target_db}});
    return json;
}

Json jsonOf(const TrialMetrics& trial) {
    Json causes = Json::object();
    for (std::size_t cause = 1; cause < loss_causes; ++cause)
        if (trial.causes[cause] > 0) causes[std::string(toText(static_cast<LossCause>(cause)))] = trial.causes[cause];
    return {{"seed", trial.seed},
            {"opportunities", trial.opportunities},
            {"correct", trial.correct},
            {"coasted", trial.coasted},
            {"wrong", trial.wrong},
            {"absent", trial.absent},
            {"outside_sector", trial.sweeps_outside_sector},
            {"unfinished", trial.sweeps_unfinished},
            {"loss_percent", 100 * trial.loss()},
            {"causes", causes},
            {"deviation_mean_m", trial.of_correct.mean_m()},
            {"deviation_max_m", trial.of_correct.greatest_m},
            {"coasting_max_m", trial.of_coasted.greatest_m},
            {"output_max_m", trial.of_all.greatest_m},
            {"nees", trial.consistency_of_correct.nees()},
            {"coverage_percent", 100 * trial.consistency_of_correct.coverage()},
            {"confirmed_tracks", trial.confirmed_tracks},
            {"false_tracks", trial.false_tracks},
            {"debris_tracks", trial.debris_tracks},
            {"renewed_picks", trial.renewed_picks},
            {"confirm_s", trial.confirmed_after_s ? Json(*trial.confirmed_after_s) : Json(nullptr)},
            {"data_s", trial.data_s},
            {"pings", trial.pings},
            {"lost", lostLooks(trial)}};
}

Json jsonOf(const ScenarioSummary& summary, const std::string& title) {
    Json trials = Json::array();
    for (const TrialMetrics& trial : summary.trials) trials.push_back(jsonOf(trial));
    return {{"column", title}, {"figures", jsonOfMetrics(summary)}, {"trials", trials}};
}

Json publishedJson(std::string_view scene) {
    const PublishedTrial* trial = publishedTrial(scene);
    if (!trial) return nullptr;
    Json json = Json::object();
    for (const Metric& metric : metricTable())
        if (metric.published)
            if (const auto value = metric.published(*trial)) json[std::string(metric.name)] = *value;
    return json;
}

Json verdictsJson(const EvaluationReport& report) {
    Json json = Json::array();
    for (const auto& verdict : report.verdicts)
        json.push_back({{"requirement", verdict.requirement},
                        {"scene", verdict.scene},
                        {"column", verdict.column},
                        {"value", verdict.value ? Json(*verdict.value) : Json(nullptr)},
                        {"met", verdict.met}});
    return json;
}

}  // namespace

std::size_t EvaluationReport::trialsDone() const {
    std::size_t done = 0;
    for (const auto& row : summaries)
        for (const ScenarioSummary& summary : row) done += summary.trials.size();
    return done;
}

std::size_t EvaluationReport::trialsWanted() const {
    return scenes.size() * columns.size() * static_cast<std::size_t>(trials);
}

ScenarioSummary EvaluationReport::overall(std::size_t column) const {
    std::vector<TrialMetrics> all;
    for (const auto& row : summaries) all.insert(all.end(), row[column].trials.begin(), row[column].trials.end());
    return summarise(std::string(all_scenes), columns[column].title, std::move(all));
}

std::string valueText(const Metric& metric, const MetricValue& value) {
    std::string text = fixedText(value.value, metric.decimals);
    if (value.interval)
        text.append(" (")
            .append(fixedText(value.interval->low, metric.decimals))
            .append(" to ")
            .append(fixedText(value.interval->high, metric.decimals))
            .append(")");
    else if (value.worst)
        text.append(", worst ").append(fixedText(*value.worst, metric.decimals));
    if (value.expected)
        text.append(" [")
            .append(fixedText(value.expected->low, metric.decimals))
            .append(" to ")
            .append(fixedText(value.expected->high, metric.decimals))
            .append("]");
    return text;
}

bool meetsGoal(const Metric& metric, const MetricValue& value, std::string_view scene) {
    const PublishedTrial* trial = publishedTrial(scene);
    if (!trial || !metric.published || metric.name == "opportunities") return false;
    const auto known = metric.published(*trial);
    return known && value.value <= goal_share * *known;
}

std::string textReport(const EvaluationReport& report) {
    std::string text;
    for (const Metric& metric : metricTable())
        if (metric.published && metric.headline) text += comparison(report, metric);
    if (report.columns.size() <= most_columns)
        for (std::size_t scene = 0; scene < report.scenes.size(); ++scene) text += sceneText(report, scene);
    else
        text.append("The other figures: --html, --json.\n");
    text.append("Intervals are 95 % ones; * is at most half of the published figure. ");
    text.append(std::to_string(report.trialsDone())).append(" of ").append(std::to_string(report.trialsWanted()));
    text.append(" trials, seeds from ").append(std::to_string(report.first_seed)).append(".");
    if (report.memory_mb > 0) text.append(" Memory ").append(fixedText(report.memory_mb, 0)).append(" MB.");
    text.append("\n");
    for (const auto& verdict : report.verdicts) {
        text.append(verdict.met ? "met      " : "NOT MET  ").append(verdict.requirement);
        text.append("  ").append(verdict.scene).append(", ").append(verdict.column).append(": ");
        text.append(verdict.value ? fixedText(*verdict.value, 3) : std::string("not measured")).append("\n");
    }
    return text;
}

std::string jsonReport(const EvaluationReport& report) {
    Json scenes = Json::array(), columns = Json::array(), overall = Json::array(), figures = Json::object();
    for (std::size_t s = 0; s < report.scenes.size(); ++s) {
        Json results = Json::array();
        for (std::size_t c = 0; c < report.columns.size(); ++c)
            results.push_back(jsonOf(report.summaries[s][c], report.columns[c].title));
        scenes.push_back({{"scene", report.scenes[s].name},
                          {"description", report.scenes[s].description},
                          {"published", publishedJson(report.scenes[s].name)},
                          {"results", results}});
    }
    for (std::size_t c = 0; c < report.columns.size(); ++c) {
        columns.push_back({{"title", report.columns[c].title}, {"settings", report.columns[c].settings}});
        overall.push_back({{"column", report.columns[c].title}, {"figures", jsonOfMetrics(report.overall(c))}});
    }
    for (const Metric& metric : metricTable())
        figures[std::string(metric.name)] = {
            {"title", metric.title}, {"unit", metric.unit}, {"meaning", metric.meaning}};
    const Json json{{"program", report.program},
                    {"first_seed", report.first_seed},
                    {"trials", report.trials},
                    {"trials_done", report.trialsDone()},
                    {"interrupted", report.interrupted},
                    {"lost_records", report.lost_records},
                    {"memory_mb", report.memory_mb},
                    {"columns", columns},
                    {"scenes", scenes},
                    {"all_scenes", overall},
                    {"requirements", verdictsJson(report)},
                    {"figures", figures}};
    // A path on the command line may hold any bytes; JSON may not.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace echotrail
