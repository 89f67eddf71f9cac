#include "core/runtime/scene_builder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace echotrail {
namespace {

constexpr double full_circle_rad = 2.0 * std::numbers::pi;
constexpr double mean_over_pings = 50.0;
constexpr int line_slots = 360;
constexpr std::size_t most_line_cells = 400;

}  // namespace

void SceneBuilder::takeEdges(double step_rad) {
    // Half a step of tolerance: rounding must not open a slit in a full circle.
    if (most_rad_ - least_rad_ + 1.5 * step_rad >= full_circle_rad) {
        left_ = Bearing::radians(-std::numbers::pi);
        right_ = Bearing::radians(std::numbers::pi - 1e-9);  // π itself would wrap to the left edge
    } else {
        left_ = sweep_origin_ + least_rad_;
        right_ = sweep_origin_ + most_rad_;
    }
}

void SceneBuilder::widenEdges(Bearing beam) {
    const double width = right_ - left_ < 0 ? right_ - left_ + full_circle_rad : right_ - left_;
    const double off_centre = beam - (left_ + width / 2.0);
    if (off_centre < -width / 2.0) left_ = beam;
    if (off_centre > width / 2.0) right_ = beam;
}

void SceneBuilder::followSweep(const Ping& ping, const Update& update) {
    if (!started_ || update.sweep_ended) {
        if (started_) {
            takeEdges(ping.step_rad);
            sweep_s_ = secondsBetween(sweep_start_, ping.time);
        }
        whole_sweep_ = started_;
        started_ = true;
        sweep_start_ = ping.time;
        sweep_origin_ = update.beam;
        turned_rad_ = least_rad_ = most_rad_ = 0.0;
    } else {
        const double turn = update.beam - last_bearing_;
        if (turn != 0.0) turns_clockwise_ = turn > 0.0;
        turned_rad_ += turn;
        least_rad_ = std::min(least_rad_, turned_rad_);
        most_rad_ = std::max(most_rad_, turned_rad_);
    }
    last_bearing_ = update.beam;
    if (whole_sweep_)
        widenEdges(update.beam);
    else
        takeEdges(ping.step_rad);
}

void SceneBuilder::add(const Ping& ping, const Update& update, double processor_seconds) {
    followSweep(ping, update);
    // An old region goes when the beam comes back to it, so that no place is shown twice and none is blank meanwhile.
    const double reach_rad = 1.5 * ping.step_rad;
    std::erase_if(regions_, [&](const Region& region) {
        const bool beam_is_back = region.time < sweep_start_ && std::abs(region.bearing - update.beam) <= reach_rad;
        const bool forgotten = sweep_s_ > 0.0 && secondsBetween(region.time, ping.time) > 3.0 * sweep_s_;
        return beam_is_back || forgotten;
    });
    regions_.insert(regions_.end(), update.regions.begin(), update.regions.end());
    if (!ping.levels.empty()) pictured_ = ping.time;
    keeper_.add(TimedPose{update.time, update.pose});
    for (const TrackLook& look : update.looks) keeper_.add(look);
    const double microseconds = 1e6 * processor_seconds;
    mean_microseconds_ = mean_microseconds_ == 0.0
                             ? microseconds
                             : mean_microseconds_ + (microseconds - mean_microseconds_) / mean_over_pings;
}

void SceneBuilder::add(const Ping& ping, const Update& update, double processor_seconds,
                       const ScanningSonarPipeline& pipeline) {
    add(ping, update, processor_seconds);
    if (ping.motor_lost_sync) return;  // nobody knows where the beam looked
    addPicture(pipeline.fan(), update);
    addLine(pipeline.lastLine());
}

void SceneBuilder::addPicture(const FanImage& fan, const Update& update) {
    if (update.sweep_ended) memory_.add(fan);
}

void SceneBuilder::addLine(BeamLine line) {
    live_line_ = std::make_shared<const BeamLine>(std::move(line));
    lines_.resize(line_slots);
    const auto slot = static_cast<long>(std::floor(live_line_->from_bow.inDegrees() + line_slots / 2.0));
    lines_[static_cast<std::size_t>(std::clamp(slot, 0L, line_slots - 1L))] = live_line_;
}

BeamLine lineOf(const Ping& ping, const Update& update) {
    BeamLine line{
        .time = ping.time, .from_bow = update.beam, .from_north = update.beam + update.pose.heading.inRadians()};
    const std::size_t bins = ping.levels.size();
    const std::size_t cells = std::min(bins, most_line_cells);
    if (cells == 0) return line;
    line.cell_m = ping.binSize() * static_cast<double>(bins) / static_cast<double>(cells);
    for (std::size_t i = 0; i < cells; ++i) {
        const std::size_t first = i * bins / cells, last = (i + 1) * bins / cells;
        std::size_t sum = 0;
        for (std::size_t bin = first; bin < last; ++bin) sum += ping.levels[bin];
        line.level.push_back(static_cast<std::uint8_t>(sum / (last - first)));
    }
    return line;
}

void SceneBuilder::addFinal(const Update& update) {
    regions_.insert(regions_.end(), update.regions.begin(), update.regions.end());
}

Scene SceneBuilder::build(const FanImage& fan, std::vector<Track> tracks, const Ping& ping,
                          const Update& update) const {
    Scene scene;
    scene.latest = update;
    scene.ping = ping;
    scene.fan = fan.clone();
    if (!fan.empty()) scene.picture_age_s = secondsBetween(pictured_, ping.time);
    scene.regions = regions_;
    scene.tracks = std::move(tracks);
    scene.sweep_s = sweep_s_;
    scene.sector_left = left_;
    scene.sector_right = right_;
    scene.turns_clockwise = turns_clockwise_;
    scene.lines = lines_;
    scene.live_line = live_line_;
    scene.remembered = memory_.remembered();
    scene.paths = std::make_shared<const Paths>(keeper_.paths());
    scene.course = courseOf(keeper_.paths().vehicle);
    scene.microseconds_per_ping = mean_microseconds_;
    return scene;
}

}  // namespace echotrail
