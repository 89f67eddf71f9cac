#include "ui/views/beam_schedule.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace echotrail {
namespace {

constexpr double full_circle_rad = 2.0 * std::numbers::pi;
constexpr double least_growing_half_rad = std::numbers::pi / 4.0;
constexpr double least_fitted_rad = std::numbers::pi / 6.0;
/// Shares of the range at which the fan is asked when the beam was there.
constexpr std::array sample_ranges{0.35, 0.6, 0.85};

std::int32_t beamTimeAt(const FanImage& fan, double north, double east) {
    const long row = std::lround(fan.rowOf(north));
    const long column = std::lround(fan.columnOf(east));
    if (row < 0 || column < 0 || row >= fan.beam_time_ms.rows || column >= fan.beam_time_ms.cols)
        return FanImage::never_scanned;
    return fan.beam_time_ms.at<std::int32_t>(static_cast<int>(row), static_cast<int>(column));
}

double clockwise(Bearing from, Bearing to) {
    const double turn = to - from;
    return turn < 0.0 ? turn + full_circle_rad : turn;
}

}  // namespace

Sector sectorOf(const Scene& scene) {
    Sector sector;
    sector.left = scene.sector_left;
    sector.width_rad = clockwise(scene.sector_left, scene.sector_right);
    const Ping& ping = scene.ping;
    sector.range_m =
        ping.range_scale_m > 0.0 ? ping.range_scale_m : static_cast<double>(ping.levels.size()) * ping.binSize();
    return sector;
}

Sector sectorToFit(const Scene& scene) {
    Sector sector = sectorOf(scene);
    if (sector.isFullCircle()) return sector;
    if (scene.sweep_s <= 0.0) {
        const double reach =
            std::max(std::abs(scene.sector_left.inRadians()), std::abs(scene.sector_right.inRadians()));
        const double half = std::max(least_growing_half_rad, reach);
        sector.left = Bearing::radians(-half);
        sector.width_rad = 2.0 * half;
    } else if (sector.width_rad < least_fitted_rad) {
        sector.left = sector.centre() + -least_fitted_rad / 2.0;
        sector.width_rad = least_fitted_rad;
    }
    return sector;
}

bool headingKnown(const Scene& scene) { return scene.navigation_known; }

std::optional<double> secondsToNextLook(const Scene& scene, Bearing from_bow) {
    const Sector sector = sectorOf(scene);
    if (scene.sweep_s <= 0.0 || sector.width_rad <= 0.0 || !sector.contains(from_bow)) return std::nullopt;
    const double seconds_per_rad = scene.sweep_s / sector.width_rad;
    const double beam = clockwise(sector.left, scene.latest.beam);
    const double target = clockwise(sector.left, from_bow);
    if (sector.isFullCircle()) {
        const double turn = scene.turns_clockwise ? target - beam : beam - target;
        return (turn < 0.0 ? turn + full_circle_rad : turn) * seconds_per_rad;
    }
    const double ahead = scene.turns_clockwise ? target - beam : beam - target;
    if (ahead >= 0.0) return ahead * seconds_per_rad;
    const double edge = scene.turns_clockwise ? sector.width_rad - beam : beam;
    return (2.0 * std::max(edge, 0.0) - ahead) * seconds_per_rad;
}

BeamAges beamAges(const Scene& scene, const Sector& sector) {
    BeamAges ages;
    if (scene.fan.empty() || sector.width_rad <= 0.0) return ages;
    const Pose& pose = scene.latest.pose;
    const int degrees = std::max(1, static_cast<int>(std::ceil(degreesFromRadians(sector.width_rad))));
    std::vector<std::int32_t> times(static_cast<std::size_t>(degrees) + 1, FanImage::never_scanned);
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double share = static_cast<double>(i) / degrees;
        const double from_north = ((sector.left + share * sector.width_rad) + pose.heading.inRadians()).inRadians();
        for (const double part : sample_ranges) {
            const double range = part * sector.range_m;
            times[i] = std::max(times[i], beamTimeAt(scene.fan, pose.north_m + range * std::cos(from_north),
                                                     pose.east_m + range * std::sin(from_north)));
        }
    }
    ages.newest_ms = *std::max_element(times.begin(), times.end());
    if (ages.newest_ms != FanImage::never_scanned)  // a slow link may have left the picture out for a while
        ages.newest_ms +=
            static_cast<std::int32_t>(std::lround(1000.0 * std::clamp(scene.picture_age_s, 0.0, 86'400.0)));
    for (const std::int32_t time : times) {
        const bool scanned = time != FanImage::never_scanned;
        const double age = scanned ? (ages.newest_ms - time) / 1000.0 : -1.0;
        ages.age_s.push_back(static_cast<float>(age));
        ages.oldest_s = std::max(ages.oldest_s, age);
    }
    return ages;
}

}  // namespace echotrail
