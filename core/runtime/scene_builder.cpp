#include "core/runtime/scene_builder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace echotrail {
namespace {

constexpr double full_circle_rad = 2.0 * std::numbers::pi;
constexpr double mean_over_pings = 50.0;

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
        turned_rad_ += update.beam - last_bearing_;
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
    const double microseconds = 1e6 * processor_seconds;
    mean_microseconds_ = mean_microseconds_ == 0.0
                             ? microseconds
                             : mean_microseconds_ + (microseconds - mean_microseconds_) / mean_over_pings;
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
    scene.regions = regions_;
    scene.tracks = std::move(tracks);
    scene.sweep_s = sweep_s_;
    scene.sector_left = left_;
    scene.sector_right = right_;
    scene.microseconds_per_ping = mean_microseconds_;
    return scene;
}

}  // namespace echotrail
