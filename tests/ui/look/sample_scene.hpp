#pragma once

#include "core/runtime/scene.hpp"

#include <cmath>
#include <memory>

namespace echotrail::test {

inline const Timestamp scene_time{std::chrono::seconds(1'274'601'600)};
inline constexpr double scene_range_m = 20.0;

/// A fan of ±45° in even dark grey, scanned from the left to the right in 3 s.
inline FanImage greyFan(std::uint8_t level) {
    constexpr int size = 441;
    FanImage fan;
    fan.pixel_m = 0.1;
    fan.north_m = 22.0;
    fan.east_m = -22.0;
    fan.levels = cv::Mat::zeros(size, size, CV_8U);
    fan.beam_time_ms = cv::Mat(size, size, CV_32S, cv::Scalar(FanImage::never_scanned));
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column) {
            const double north = fan.northOf(row);
            const double east = fan.eastOf(column);
            const double degrees = degreesFromRadians(std::atan2(east, north));
            if (std::hypot(north, east) > scene_range_m || std::abs(degrees) > 45.0) continue;
            fan.levels.at<std::uint8_t>(row, column) = level;
            fan.beam_time_ms.at<std::int32_t>(row, column) = static_cast<int>((degrees + 45.0) / 90.0 * 3000.0);
        }
    return fan;
}

/// A bright square of 1 m at a place of the local frame.
inline void brighten(FanImage& fan, double north, double east) {
    const int row = static_cast<int>(std::lround(fan.rowOf(north)));
    const int column = static_cast<int>(std::lround(fan.columnOf(east)));
    fan.levels(cv::Rect(column - 5, row - 5, 11, 11)) = 255;
}

inline Track sampleTrack(int id, TrackState state, double north, double east) {
    Track track;
    track.id = id;
    track.state = state;
    track.estimate.time = scene_time;
    track.estimate.mean << north, east, 0.3, -0.2;
    track.estimate.covariance.diagonal() << 0.4, 0.2, 0.05, 0.05;
    track.born = scene_time - std::chrono::seconds(30);
    track.last_seen = scene_time - std::chrono::milliseconds(1700);
    track.existence = 0.94;
    track.looks = 7;
    track.region_of_interest = {0.0,
                                0.0,
                                Bearing::radians(std::atan2(east, north)),
                                0.15,
                                std::hypot(north, east) - 2.0,
                                std::hypot(north, east) + 2.0};
    for (int i = 0; i < 2000; ++i) {
        const double turn = 2.399963 * i;
        const double away = 1.2 * std::sqrt(i / 2000.0);
        track.particles.position_m.emplace_back(static_cast<float>(north + away * std::cos(turn)),
                                                static_cast<float>(east + away * std::sin(turn)));
        track.particles.weight.push_back(static_cast<float>(std::exp(-away * away) / 2000.0));
    }
    track.particles.effective = 1184.0;
    for (int i = 6; i >= 0; --i) {
        TrackLook look;
        look.time = scene_time - std::chrono::seconds(3 * i);
        look.seen = i != 2;
        look.position_m = {north - 0.5 * i, east + 0.4 * i};
        track.history.push_back(look);
    }
    return track;
}

inline Region sampleRegion(std::uint32_t id, double north, double east, bool dropped) {
    Region region;
    region.id = id;
    region.position_m = {north, east};
    region.clutter_mass = dropped;
    for (int i = 0; i < 16; ++i) {
        const double angle = 0.3927 * i;
        region.outline_m.emplace_back(static_cast<float>(north + 0.8 * std::cos(angle)),
                                      static_cast<float>(east + 0.8 * std::sin(angle)));
    }
    return region;
}

/// A scene without tracks or regions; the vehicle lies at the origin, its bow north.
inline Scene bareScene() {
    Scene scene;
    scene.position = 100;
    scene.latest.time = scene_time;
    scene.latest.beam = Bearing::degrees(45.0);
    scene.ping.range_scale_m = scene_range_m;
    scene.ping.clockwise = true;
    scene.fan = greyFan(60);
    scene.sweep_s = 3.0;
    scene.sector_left = Bearing::degrees(-45.0);
    scene.sector_right = Bearing::degrees(45.0);
    return scene;
}

/// One track in each state, a kept and a dropped region.
inline Scene fullScene() {
    Scene scene = bareScene();
    scene.tracks = {sampleTrack(1, TrackState::Confirmed, 12.0, 2.0), sampleTrack(2, TrackState::Coasting, 16.0, -5.0),
                    sampleTrack(3, TrackState::Lost, 9.0, -6.0), sampleTrack(5, TrackState::Tentative, 15.0, 6.0)};
    scene.tracks[0].target = true;
    scene.regions = {sampleRegion(1, 12.0, 2.0, false), sampleRegion(2, 17.0, 1.0, false),
                     sampleRegion(3, 8.0, 5.0, true)};
    return scene;
}

inline std::shared_ptr<const Scene> shared(Scene scene) { return std::make_shared<const Scene>(std::move(scene)); }

}  // namespace echotrail::test
