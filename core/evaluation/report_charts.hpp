#pragma once

#include "core/evaluation/report.hpp"

#include <string>
#include <string_view>

/// The drawings of the page, as SVG. A column has the same colour in all of them; what was published is grey.
namespace echotrail {

std::string_view columnColour(std::size_t column);
inline constexpr std::string_view published_colour = "#777";
inline constexpr std::string_view cause_colours[] = {"#ccc",    "#bbb",    "#0072b2", "#e69f00",
                                                     "#d55e00", "#009e73", "#cc79a7"};

/// Loss rate of every scene and column with its interval, beside the published one.
std::string lossChart(const EvaluationReport& report);
/// One number of every trial as boxes: median, quartiles, extremes.
std::string deviationBoxes(const EvaluationReport& report, bool greatest);
/// Of every scene and column the share of looks lost to each cause.
std::string causeChart(const EvaluationReport& report);
/// Error of one trial over time, look by look.
std::string errorOverTime(const TrialResult& trial, std::size_t column);
/// Where the target went, and where it was taken to be.
std::string pathChart(const TrialResult& trial, std::size_t column);

}  // namespace echotrail
