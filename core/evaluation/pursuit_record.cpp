#include "core/evaluation/pursuit_record.hpp"

#include "core/evaluation/svg.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace echotrail {
namespace {

using Point = SvgDrawing::Point;
using Anchor = SvgDrawing::Anchor;

constexpr double interval_s = 0.1;
constexpr double width = 900.0, map_height = 620.0, range_height = 200.0, left = 62.0, top = 34.0;
constexpr std::string_view vehicle_line = "fill:none;stroke:#0072b2;stroke-width:1.8",
                           target_line = "fill:none;stroke:#d55e00;stroke-width:1.8",
                           limit_line = "fill:none;stroke:#888;stroke-dasharray:5 4";

Eigen::Vector2d placeOf(const Pose& pose) { return {pose.north_m, pose.east_m}; }

/// The same scale both ways, so that the paths keep their shape.
std::pair<SvgAxis, SvgAxis> mapAxes(const std::vector<PursuitRecord::Sample>& samples) {
    Eigen::Vector2d least = samples.front().target_m, most = least;
    for (const auto& sample : samples)
        for (const Eigen::Vector2d& place : {sample.target_m, placeOf(sample.vehicle)}) {
            least = least.cwiseMin(place);
            most = most.cwiseMax(place);
        }
    const double right = width - 20.0, bottom = top + map_height - 50.0;
    const double metre_px = std::min((bottom - top) / (most.x() - least.x() + 10.0),
                                     (right - left) / (most.y() - least.y() + 10.0));
    const Eigen::Vector2d middle = (least + most) / 2.0;
    const double half_north = (bottom - top) / metre_px / 2.0, half_east = (right - left) / metre_px / 2.0;
    return {SvgAxis(middle.x() - half_north, middle.x() + half_north, bottom, top),
            SvgAxis(middle.y() - half_east, middle.y() + half_east, left, right)};
}

}  // namespace

double PursuitRecord::Sample::range_m() const { return (target_m - placeOf(vehicle)).norm(); }

void PursuitRecord::take(const Scenario& scenario, double time_s, bool steered) {
    for (double next_s = static_cast<double>(samples_.size()) * interval_s; next_s <= time_s;
         next_s = static_cast<double>(samples_.size()) * interval_s)
        samples_.push_back({next_s, vehiclePose(scenario, next_s),
                            targetMotion(scenario.targets.front(), next_s).position_m, steered});
}

std::optional<PursuitRecord::Figures> PursuitRecord::figuresFrom(double first_within_m) const {
    std::vector<double> off_m;
    for (const Sample& sample : samples_) {
        const double off = std::abs(sample.range_m() - keep_range_m_);
        if (sample.steered && (!off_m.empty() || off <= first_within_m)) off_m.push_back(off);
    }
    if (off_m.empty()) return std::nullopt;
    Figures figures{.seconds = static_cast<double>(off_m.size()) * interval_s};
    for (const double off : off_m) figures.mean_m += off / static_cast<double>(off_m.size());
    std::sort(off_m.begin(), off_m.end());
    figures.percentile_95_m = off_m[static_cast<std::size_t>(0.95 * static_cast<double>(off_m.size() - 1))];
    figures.greatest_m = off_m.back();
    return figures;
}

std::string PursuitRecord::csv() const {
    std::string text =
        "t,vehicle_north_m,vehicle_east_m,vehicle_heading_deg,target_north_m,target_east_m,range_m,steered\n";
    for (const Sample& sample : samples_) {
        const double numbers[] = {sample.vehicle.north_m,  sample.vehicle.east_m, sample.vehicle.heading.inDegrees(),
                                  sample.target_m.x(), sample.target_m.y(), sample.range_m()};
        text += fixedText(sample.time_s, 1);
        for (const double number : numbers) text += ',' + fixedText(number, 3);
        text += sample.steered ? ",1\n" : ",0\n";
    }
    return text;
}

std::string PursuitRecord::svg(const std::string& title) const {
    SvgDrawing drawing(width, top + map_height + range_height, title);
    drawing.text({left, 20}, title);
    if (samples_.empty()) return drawing.finish();
    const auto [north, east] = mapAxes(samples_);
    const double bottom = top + map_height - 50.0, right = width - 20.0;
    drawing.leftAxis(north, left, right, "north, m");
    drawing.bottomAxis(east, top, bottom, "east, m");
    std::vector<Point> vehicle, target, range;
    double greatest_m = keep_range_m_;
    for (const Sample& sample : samples_) {
        vehicle.push_back({east.at(sample.vehicle.east_m), north.at(sample.vehicle.north_m)});
        target.push_back({east.at(sample.target_m.y()), north.at(sample.target_m.x())});
        greatest_m = std::max(greatest_m, sample.range_m());
    }
    drawing.polyline(target, target_line);
    drawing.polyline(vehicle, vehicle_line);
    drawing.circle(target.front(), 4, "fill:#d55e00");
    drawing.circle(vehicle.front(), 4, "fill:#0072b2");
    drawing.text({right - 4, top + 14}, "target", Anchor::End, "fill:#d55e00");
    drawing.text({right - 4, top + 32}, "vehicle", Anchor::End, "fill:#0072b2");

    const double range_top = top + map_height + 10.0, range_bottom = range_top + range_height - 50.0;
    const SvgAxis metres(0.0, 1.1 * greatest_m, range_bottom, range_top);
    const SvgAxis seconds(0.0, samples_.back().time_s, left, right);
    drawing.leftAxis(metres, left, right, "range, m", 4);
    drawing.bottomAxis(seconds, range_top, range_bottom, "s");
    for (const Sample& sample : samples_) range.push_back({seconds.at(sample.time_s), metres.at(sample.range_m())});
    drawing.line({left, metres.at(keep_range_m_)}, {right, metres.at(keep_range_m_)}, limit_line);
    drawing.polyline(range, vehicle_line);
    return drawing.finish();
}

}  // namespace echotrail
