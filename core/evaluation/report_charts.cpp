#include "core/evaluation/report_charts.hpp"

#include "core/evaluation/svg.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace echotrail {
namespace {

using Point = SvgDrawing::Point;
using Anchor = SvgDrawing::Anchor;

constexpr double page_width = 1000.0;
constexpr double left = 62.0, right = page_width - 10.0, top = 14.0;
constexpr std::array<std::string_view, 6> colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"};

std::string fill(std::string_view colour) { return std::string("fill:").append(colour); }
std::string stroke(std::string_view colour, double width) {
    return std::string("fill:none;stroke:").append(colour).append(";stroke-width:").append(fixedText(width, 1));
}

/// Places of groups, one per scene, side by side, with `bars` in each.
struct Groups {
    double width, bar;
    Groups(std::size_t groups, std::size_t bars)
        : width((right - left) / static_cast<double>(std::max<std::size_t>(groups, 1))),
          bar(std::min(46.0, 0.84 * width / static_cast<double>(bars))) {}
    double centre(std::size_t group) const { return left + (static_cast<double>(group) + 0.5) * width; }
    double barCentre(std::size_t group, std::size_t i, std::size_t bars) const {
        return centre(group) + (static_cast<double>(i) + 0.5 - static_cast<double>(bars) / 2.0) * bar;
    }
};

void nameGroups(SvgDrawing& drawing, const EvaluationReport& report, const Groups& groups, double bottom) {
    drawing.line({left, bottom}, {right, bottom}, "stroke:#444");
    for (std::size_t s = 0; s < report.scenes.size(); ++s)
        drawing.text({groups.centre(s), bottom + 18}, report.scenes[s].name, Anchor::Middle);
}

std::optional<double> publishedOf(const Metric& metric, const std::string& scene) {
    const PublishedTrial* trial = publishedTrial(scene);
    return trial && metric.published ? metric.published(*trial) : std::nullopt;
}

double greatestLoss(const EvaluationReport& report, const Metric& metric) {
    double greatest = 1;
    for (std::size_t s = 0; s < report.scenes.size(); ++s) {
        greatest = std::max(greatest, publishedOf(metric, report.scenes[s].name).value_or(0));
        for (const ScenarioSummary& summary : report.summaries[s])
            if (const auto value = metric.of(summary))
                greatest = std::max(greatest, value->interval ? value->interval->high : value->value);
    }
    return greatest;
}

void whisker(SvgDrawing& drawing, double x, double from, double to, double reach) {
    drawing.line({x, from}, {x, to}, "stroke:#222");
    for (const double y : {from, to}) drawing.line({x - reach, y}, {x + reach, y}, "stroke:#222");
}

void drawBox(SvgDrawing& drawing, const SvgAxis& axis, double x, double half, const FiveNumbers& five,
             std::string_view colour, const std::string& hint) {
    whisker(drawing, x, axis.at(five.least), axis.at(five.lower), half / 2);
    whisker(drawing, x, axis.at(five.greatest), axis.at(five.upper), half / 2);
    drawing.box({x - half, axis.at(five.upper)}, 2 * half, axis.at(five.lower) - axis.at(five.upper),
                std::string("fill:").append(colour).append(";fill-opacity:0.35;stroke:").append(colour), hint);
    drawing.line({x - half, axis.at(five.median)}, {x + half, axis.at(five.median)}, stroke(colour, 2.5));
}

std::vector<double> deviationsOf(const ScenarioSummary& summary, bool greatest) {
    return summary.each([&](const TrialMetrics& trial) -> std::optional<double> {
        if (trial.of_correct.count == 0) return std::nullopt;
        return greatest ? trial.of_correct.greatest_m : trial.of_correct.mean_m();
    });
}

double secondsInto(const TrialResult& trial, Timestamp time) {
    Timestamp first = time;
    if (!trial.snapshots.empty()) first = trial.snapshots.front().time;
    if (!trial.looks.empty()) first = std::min(first, trial.looks.front().time);
    if (!trial.outputs.empty()) first = std::min(first, trial.outputs.front().time);
    return secondsBetween(first, time);
}

/// A filled dot for a correct look, a ring for a prediction, a cross for a wrong echo.
void mark(SvgDrawing& drawing, const EvaluatedOutput& output, Point place, std::string_view colour) {
    if (!output.seen)
        drawing.circle(place, 2.6, stroke(published_colour, 1));
    else if (output.correct)
        drawing.circle(place, 1.9, fill(colour));
    else
        drawing.cross(place, 3.2, "stroke:#c00;stroke-width:1.4");
}

/// The rectangle that holds the target's way and the estimates, as a square a little larger.
struct Square {
    double north = 0.0, east = 0.0, half = 1.0;  ///< metres
};
Square squareAbout(const TrialResult& trial) {
    double south = HUGE_VAL, north = -HUGE_VAL, west = HUGE_VAL, east = -HUGE_VAL;
    const auto hold = [&](const Eigen::Vector2d& place) {
        south = std::min(south, place.x());
        north = std::max(north, place.x());
        west = std::min(west, place.y());
        east = std::max(east, place.y());
    };
    for (const SweepSnapshot& snapshot : trial.snapshots)
        for (const auto& object : snapshot.objects) hold(object.position_m);
    for (const EvaluatedOutput& output : trial.outputs) hold(output.estimate_m);
    if (south > north) return {};
    return {(south + north) / 2, (west + east) / 2, 0.54 * std::max({north - south, east - west, 2.0})};
}

}  // namespace

std::string_view columnColour(std::size_t column) { return colours[column % colours.size()]; }

std::string lossChart(const EvaluationReport& report) {
    const Metric& metric = *findMetric("loss_percent");
    constexpr double height = 300, bottom = height - 30;
    SvgDrawing drawing(page_width, height, "Loss rate of every scene");
    const SvgAxis axis(0, 1.05 * greatestLoss(report, metric), bottom, top);
    drawing.leftAxis(axis, left, right, "loss rate, % of opportunities");
    const std::size_t bars = report.columns.size() + 1;
    const Groups groups(report.scenes.size(), bars);
    for (std::size_t s = 0; s < report.scenes.size(); ++s) {
        const auto bar = [&](std::size_t i, double value, std::string_view colour, const std::string& hint) {
            const double x = groups.barCentre(s, i, bars);
            drawing.box({x - 0.42 * groups.bar, axis.at(value)}, 0.84 * groups.bar, bottom - axis.at(value),
                        fill(colour), hint);
            return x;
        };
        if (const auto known = publishedOf(metric, report.scenes[s].name))
            bar(0, *known, published_colour, "published: " + fixedText(*known, 1) + " %");
        for (std::size_t c = 0; c < report.columns.size(); ++c) {
            const auto value = metric.of(report.summaries[s][c]);
            if (!value) continue;
            const std::string hint = report.columns[c].title + ": " + valueText(metric, *value) + " %";
            const double x = bar(c + 1, value->value, columnColour(c), hint);
            whisker(drawing, x, axis.at(value->interval->low), axis.at(value->interval->high), 0.15 * groups.bar);
        }
    }
    nameGroups(drawing, report, groups, bottom);
    return drawing.finish();
}

std::string deviationBoxes(const EvaluationReport& report, bool greatest) {
    const Metric& metric = *findMetric(greatest ? "deviation_max_m" : "deviation_mean_m");
    constexpr double height = 280, bottom = height - 30;
    double most = 1;
    for (std::size_t s = 0; s < report.scenes.size(); ++s) {
        most = std::max(most, publishedOf(metric, report.scenes[s].name).value_or(0));
        for (const ScenarioSummary& summary : report.summaries[s])
            most = std::max(most, fiveNumbers(deviationsOf(summary, greatest)).greatest);
    }
    SvgDrawing drawing(page_width, height, metric.title);
    const SvgAxis axis(0, 1.05 * most, bottom, top);
    drawing.leftAxis(axis, left, right, greatest ? "greatest deviation, m" : "mean deviation, m");
    const Groups groups(report.scenes.size(), report.columns.size());
    for (std::size_t s = 0; s < report.scenes.size(); ++s) {
        for (std::size_t c = 0; c < report.columns.size(); ++c) {
            const auto values = deviationsOf(report.summaries[s][c], greatest);
            if (values.empty()) continue;
            const FiveNumbers five = fiveNumbers(values);
            drawBox(drawing, axis, groups.barCentre(s, c, report.columns.size()), 0.3 * groups.bar, five,
                    columnColour(c),
                    report.columns[c].title + ": median " + fixedText(five.median, 2) + " m, " +
                        fixedText(five.least, 2) + " to " + fixedText(five.greatest, 2) + " m");
        }
        const double half = groups.bar * static_cast<double>(report.columns.size()) / 2;
        if (const auto known = publishedOf(metric, report.scenes[s].name))
            drawing.line({groups.centre(s) - half, axis.at(*known)}, {groups.centre(s) + half, axis.at(*known)},
                         "stroke:#777;stroke-width:3");
    }
    nameGroups(drawing, report, groups, bottom);
    return drawing.finish();
}

std::string causeChart(const EvaluationReport& report) {
    constexpr double row = 17, gap = 10, names = 190;
    double most = 1;
    std::size_t rows = 0;
    for (const auto& scene : report.summaries)
        for (const ScenarioSummary& summary : scene) {
            most = std::max(most, 100 * summary.pooled.loss());
            ++rows;
        }
    const double bottom = top + static_cast<double>(rows) * row + static_cast<double>(report.scenes.size()) * gap;
    SvgDrawing drawing(page_width, bottom + 42, "Why looks were lost");
    const SvgAxis axis(0, 1.02 * most, names, right);
    drawing.bottomAxis(axis, top, bottom, "looks lost, % of opportunities");
    double y = top;
    for (std::size_t s = 0; s < report.scenes.size(); ++s, y += gap)
        for (std::size_t c = 0; c < report.columns.size(); ++c, y += row) {
            const TrialMetrics& all = report.summaries[s][c].pooled;
            drawing.text({names - 8, y + row - 5}, report.scenes[s].name + "  " + report.columns[c].title, Anchor::End);
            double sum = 0;
            for (std::size_t cause = 1; cause < loss_causes && all.opportunities > 0; ++cause) {
                if (all.causes[cause] == 0) continue;
                const double share =
                    100.0 * static_cast<double>(all.causes[cause]) / static_cast<double>(all.opportunities);
                drawing.box({axis.at(sum), y + 2}, axis.at(sum + share) - axis.at(sum), row - 4,
                            fill(cause_colours[cause]),
                            std::string(toText(static_cast<LossCause>(cause))) + ": " +
                                std::to_string(all.causes[cause]) + " looks, " + fixedText(share, 1) + " %");
                sum += share;
            }
        }
    return drawing.finish();
}

std::string errorOverTime(const TrialResult& trial, std::size_t column) {
    constexpr double height = 190, bottom = height - 42;
    const double limit = 0.15 * trial.range_scale_m;
    double most = 1;
    for (const EvaluatedOutput& output : trial.outputs) most = std::max(most, output.error_m.norm());
    const double shown = std::min(1.05 * most, 1.4 * std::max(limit, 1.0));  // one that went astray hides no others
    SvgDrawing drawing(page_width, height, "Error over time");
    const SvgAxis minutes(0, trial.data_s / 60.0, left, right), axis(0, shown, bottom, top);
    drawing.leftAxis(axis, left, right, "error, m", 4);
    drawing.bottomAxis(minutes, top, bottom, "time, min", 10);
    if (limit < shown)
        drawing.line({left, axis.at(limit)}, {right, axis.at(limit)}, "stroke:#c00;stroke-dasharray:5 4");
    for (const EvaluatedLook& look : trial.looks)
        if (look.outcome == LookOutcome::Absent) {
            const double x = minutes.at(secondsInto(trial, look.time) / 60.0);
            drawing.line({x, bottom - 7}, {x, bottom}, "stroke:#c00");
        }
    for (const EvaluatedOutput& output : trial.outputs) {
        const double error = output.error_m.norm();
        const Point place{minutes.at(secondsInto(trial, output.time) / 60.0), axis.at(std::min(error, shown))};
        mark(drawing, output, place, columnColour(column));
        if (error > shown) drawing.line({place.x, top - 8}, {place.x, top - 2}, "stroke:#c00;stroke-width:2");
    }
    return drawing.finish();
}

std::string pathChart(const TrialResult& trial, std::size_t column) {
    constexpr double size = 480, bottom = size - 44;
    const Square square = squareAbout(trial);
    SvgDrawing drawing(size, size, "Way of the target and of its estimate");
    const SvgAxis east(square.east - square.half, square.east + square.half, left, left + bottom - top);
    const SvgAxis north(square.north - square.half, square.north + square.half, bottom, top);
    drawing.leftAxis(north, left, left + bottom - top, "north, m");
    drawing.bottomAxis(east, top, bottom, "east, m", 6);
    std::map<int, std::vector<Point>> ways;
    for (const SweepSnapshot& snapshot : trial.snapshots)
        for (const auto& object : snapshot.objects)
            ways[object.target].push_back({east.at(object.position_m.y()), north.at(object.position_m.x())});
    for (const auto& [target, way] : ways) {
        drawing.polyline(way, stroke(target == 0 ? "#444" : "#aaa", target == 0 ? 1.6 : 1.0));
        drawing.text({way.front().x + 5, way.front().y - 5}, target == 0 ? "start" : "other");
    }
    for (const EvaluatedOutput& output : trial.outputs)
        mark(drawing, output, {east.at(output.estimate_m.y()), north.at(output.estimate_m.x())}, columnColour(column));
    return drawing.finish();
}

}  // namespace echotrail
