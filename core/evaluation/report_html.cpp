#include "core/evaluation/report.hpp"
#include "core/evaluation/report_charts.hpp"
#include "core/evaluation/svg.hpp"

namespace echotrail {
namespace {

constexpr std::string_view style = R"css(
body { font: 15px/1.45 "Noto Sans", "DejaVu Sans", system-ui, sans-serif; color: #222; background: #fff;
       max-width: 1060px; margin: 2em auto; padding: 0 1.2em; }
h1 { font-size: 1.6em; margin-bottom: .2em; } h2 { font-size: 1.2em; margin: 2em 0 .4em; } h3 { font-size: 1em; margin: 1.4em 0 .3em; }
p, figcaption { max-width: 56em; } figcaption { color: #555; font-size: .92em; }
figure { margin: .8em 0 1.6em; } svg { max-width: 100%; height: auto; } svg text { font-size: 12px; fill: #333; }
table { border-collapse: collapse; margin: .6em 0 1em; font-size: .93em; }
th, td { padding: .22em .8em; text-align: right; border-bottom: 1px solid #ddd; font-variant-numeric: tabular-nums; }
th:first-child, td:first-child { text-align: left; } thead th { border-bottom: 2px solid #888; }
td.goal { background: #e4f3e8; } td.missed { background: #fbe6e1; } .unit { color: #777; } .scroll { overflow-x: auto; }
.key { margin: .3em 0; } .key span { display: inline-block; margin-right: 1.4em; } .pictures { display: flex; flex-wrap: wrap; gap: 0 1.5em; }
.key i { display: inline-block; width: .9em; height: .9em; margin-right: .4em; vertical-align: -.1em; }
dt { font-weight: 600; margin-top: .5em; } dd { margin-left: 1.2em; } code { font-size: .93em; }
)css";

std::string element(std::string_view name, std::string_view content, std::string_view attributes = {}) {
    std::string text("<");
    text.append(name).append(attributes).append(">").append(content).append("</").append(name).append(">\n");
    return text;
}

std::string figure(std::string_view picture, std::string_view caption) {
    return element("figure", std::string(picture).append(element("figcaption", escaped(caption))));
}

std::string titleWithUnit(const Metric& metric) {
    return escaped(metric.title) + " <span class=\"unit\">" + escaped(metric.unit) + "</span>";
}

std::string cell(const Metric& metric, const ScenarioSummary& summary, std::string_view scene) {
    const auto value = metric.of(summary);
    if (!value) return element("td", "–");
    std::string text = valueText(metric, *value);
    if (value->interval && value->worst) text.append(", worst ").append(fixedText(*value->worst, metric.decimals));
    return element("td", text, meetsGoal(metric, *value, scene) ? " class=\"goal\"" : "");
}

std::string keyItem(std::string_view colour, std::string_view words) {
    return std::string("<span><i style=\"background:")
        .append(colour)
        .append("\"></i>")
        .append(escaped(words))
        .append("</span>");
}

std::string columnKey(const EvaluationReport& report, bool with_published) {
    std::string text;
    if (with_published) text += keyItem(published_colour, "published");
    for (std::size_t c = 0; c < report.columns.size(); ++c) text += keyItem(columnColour(c), report.columns[c].title);
    return element("div", text, " class=\"key\"");
}

std::string causeKey() {
    std::string text;
    for (std::size_t cause = 1; cause < loss_causes; ++cause)
        text += keyItem(cause_colours[cause], toText(static_cast<LossCause>(cause)));
    return element("div", text, " class=\"key\"");
}

std::string headOfColumns(const EvaluationReport& report, std::string_view first, bool with_published) {
    std::string heads = element("th", escaped(first));
    if (with_published) heads += element("th", "published");
    for (const auto& column : report.columns) heads += element("th", escaped(column.title));
    return element("thead", element("tr", heads));
}

/// One published figure over all scenes.
std::string comparisonTable(const EvaluationReport& report, const Metric& metric) {
    std::string rows;
    for (std::size_t s = 0; s < report.scenes.size(); ++s) {
        const std::string& scene = report.scenes[s].name;
        const PublishedTrial* trial = publishedTrial(scene);
        const auto known = trial ? metric.published(*trial) : std::nullopt;
        std::string cells = element("td", escaped(scene), " title=\"" + escaped(report.scenes[s].description) + "\"");
        cells += element("td", known ? fixedText(*known, metric.decimals) : "–");
        for (const ScenarioSummary& summary : report.summaries[s]) cells += cell(metric, summary, scene);
        rows += element("tr", cells);
    }
    std::string overall = element("td", "all scenes") + element("td", "–");
    for (std::size_t c = 0; c < report.columns.size(); ++c) overall += cell(metric, report.overall(c), "");
    if (metric.pools && report.scenes.size() > 1) rows += element("tr", overall);
    return element("h3", titleWithUnit(metric)) +
           element("div", element("table", headOfColumns(report, "Scene", true) + element("tbody", rows)),
                   " class=\"scroll\"");
}

/// All figures of a scene.
std::string figuresTable(const EvaluationReport& report, std::size_t scene) {
    std::string rows;
    for (const Metric& metric : metricTable()) {
        std::string cells = element("td", titleWithUnit(metric), " title=\"" + escaped(metric.meaning) + "\"");
        for (const ScenarioSummary& summary : report.summaries[scene])
            cells += cell(metric, summary, report.scenes[scene].name);
        rows += element("tr", cells);
    }
    return element("div", element("table", headOfColumns(report, "", false) + element("tbody", rows)),
                   " class=\"scroll\"");
}

std::string verdictTable(const EvaluationReport& report) {
    if (report.verdicts.empty()) return {};
    std::string rows;
    for (const auto& verdict : report.verdicts)
        rows += element("tr", element("td", escaped(verdict.requirement)) + element("td", escaped(verdict.scene)) +
                                  element("td", escaped(verdict.column)) +
                                  element("td", verdict.value ? fixedText(*verdict.value, 3) : "not measured") +
                                  element("td", verdict.met ? "met" : "not met",
                                          verdict.met ? " class=\"goal\"" : " class=\"missed\""));
    const std::string heads = element("th", "Requirement") + element("th", "Scene") + element("th", "Column") +
                              element("th", "Measured") + element("th", "");
    return element("h2", "Requirements") +
           element("table", element("thead", element("tr", heads)) + element("tbody", rows));
}

std::string examplesOf(const EvaluationReport& report, std::size_t scene) {
    std::string text, paths;
    for (std::size_t c = 0; c < report.columns.size(); ++c) {
        const TrialResult& trial = report.examples[scene][c];
        if (trial.outputs.empty() && trial.looks.empty()) continue;
        const std::string who = report.columns[c].title + ", seed " + std::to_string(trial.seed);
        text += figure(errorOverTime(trial, c), "Error over time: " + who);
        paths += figure(pathChart(trial, c), "Way: " + who);
    }
    return text + element("div", paths, " class=\"pictures\"");
}

std::string intro(const EvaluationReport& report) {
    const auto counted = [](std::size_t number, const char* one) {
        return std::to_string(number) + " " + one + (number == 1 ? "" : "s");
    };
    std::string text = report.program + ": " + counted(report.scenes.size(), "scene") + ", " +
                       counted(static_cast<std::size_t>(report.trials), "trial") +
                       " of each with every set of parameters, seeds from " + std::to_string(report.first_seed) + "; " +
                       std::to_string(report.trialsDone()) + " of " + std::to_string(report.trialsWanted()) + " done.";
    if (report.interrupted) text += " It was interrupted: what follows is of those.";
    if (report.memory_mb > 0) text += " Memory of the whole program: " + fixedText(report.memory_mb, 0) + " MB.";
    return element("p", escaped(text)) +
           element("p",
                   "An opportunity is one sweep whose scanned area held the target. It is used correctly when a "
                   "confirmed estimate of that sweep comes from the target's own echo; the rest is lost. Numbers in "
                   "round brackets are 95 % intervals. Green: at most half of the published figure, the goal. The "
                   "published figures are of five sea trials with a corner reflector at 20 m on the 50 m scale; S1 to "
                   "S5 are simulated after them, and how the truth was measured at sea was not published.");
}

std::string settingsOf(const EvaluationReport& report) {
    std::string text;
    for (const auto& column : report.columns) {
        std::string values;
        for (const std::string& setting : column.settings) values += element("div", element("code", escaped(setting)));
        text += element("dt", escaped(column.title)) +
                element("dd", values.empty() ? "All parameters have their defaults." : values);
    }
    return element("h2", "Parameters") + element("dl", text);
}

std::string glossary() {
    std::string text;
    for (const Metric& metric : metricTable())
        text += element("dt", titleWithUnit(metric) + " <code>" + std::string(metric.name) + "</code>") +
                element("dd", escaped(metric.meaning));
    return element("h2", "What the figures mean") + element("dl", text);
}

}  // namespace

std::string htmlReport(const EvaluationReport& report) {
    std::string body = element("h1", "Evaluation of tracking") + intro(report) + verdictTable(report);
    body += element("h2", "Beside the published figures");
    for (const Metric& metric : metricTable())
        if (metric.published && metric.headline) body += comparisonTable(report, metric);
    body += element("h2", "Loss rate") + columnKey(report, true) +
            figure(lossChart(report), "All trials together; the lines are 95 % intervals.");
    body += element("h2", "Deviation of correct looks") + columnKey(report, true) +
            figure(deviationBoxes(report, false),
                   "Mean of each trial: median, quartiles and extremes over trials; grey: "
                   "published.") +
            figure(deviationBoxes(report, true), "Greatest of each trial, likewise.");
    body += element("h2", "Why looks were lost") + causeKey() + figure(causeChart(report), "All trials together.");
    for (std::size_t s = 0; s < report.scenes.size(); ++s) {
        body += element("h2", escaped(report.scenes[s].name)) + element("p", escaped(report.scenes[s].description));
        body += figuresTable(report, s);
        body += element("p",
                        "Pictures of the first trial: dots are correct looks, rings predictions, red crosses looks "
                        "at something else; red strokes at the foot are sweeps without a confirmed track, those at "
                        "the head errors beyond the picture. Dashed: 15 % of the range scale.");
        body += examplesOf(report, s);
    }
    body += settingsOf(report) + glossary();
    std::string page("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n");
    page += "<meta name=\"viewport\" content=\"width=device-width\">\n" + element("title", "Evaluation of tracking") +
            element("style", style);
    return page + "</head><body>\n" + body + "</body></html>\n";
}

}  // namespace echotrail
