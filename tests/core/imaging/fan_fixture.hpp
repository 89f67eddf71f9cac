#pragma once

#include "core/data/fan_image.hpp"
#include "core/imaging/ray.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

namespace echotrail {

/// An echo line that owns its levels.
struct OwnedRay {
    std::vector<std::uint8_t> levels;
    Ray ray;

    /// From a head standing still at the origin.
    OwnedRay(std::vector<std::uint8_t> values, double azimuth_deg, double bin_size_m, double step_deg = 1.8)
        : levels(std::move(values)) {
        ray.head_bearing = Bearing::degrees(azimuth_deg);
        ray.azimuth_rad = ray.head_bearing.inRadians();
        ray.step_rad = radiansFromDegrees(step_deg);
        ray.bin_size_m = bin_size_m;
        ray.levels = levels;
    }
    OwnedRay(OwnedRay&& other) noexcept : levels(std::move(other.levels)), ray(other.ray) { ray.levels = levels; }
};

/// An unpainted tile; `north` and `east` are the whole pixels of the world's grid at row 0, column 0.
inline FanImage emptyTile(int north, int east, int rows, int columns, double pixel_m) {
    FanImage tile;
    tile.levels = cv::Mat(rows, columns, CV_8U, cv::Scalar(0));
    tile.beam_time_ms = cv::Mat(rows, columns, CV_32S, cv::Scalar(FanImage::never_scanned));
    tile.pixel_m = pixel_m;
    tile.north_m = north * pixel_m;
    tile.east_m = east * pixel_m;
    return tile;
}

inline bool isPainted(const FanImage& tile, int row, int column) {
    return tile.beam_time_ms.at<std::int32_t>(row, column) != FanImage::never_scanned;
}

}  // namespace echotrail
