#pragma once

#include <cstdint>

#include <opencv2/core.hpp>

namespace echotrail {

/// A picture of echo levels in the local frame, north up: row 0 is the northernmost, column 0 the westernmost.
/// A cv::Mat shares its pixels on copy: a published FanImage is read only; clone() makes an own one.
struct FanImage {
    cv::Mat levels;       ///< 8-bit, 0…255 is 0…80 dB
    cv::Mat beam_time_ms; ///< 32-bit signed: when the beam was there, ms since the source's first ping; never_scanned
    double pixel_m = 0.0;
    double north_m = 0.0; ///< of the centre of pixel (row 0, column 0)
    double east_m = 0.0;

    static constexpr std::int32_t never_scanned = -1;

    double rowOf(double north) const { return (north_m - north) / pixel_m; }
    double columnOf(double east) const { return (east - east_m) / pixel_m; }
    double northOf(double row) const { return north_m - row * pixel_m; }
    double eastOf(double column) const { return east_m + column * pixel_m; }
    bool empty() const { return levels.empty(); }
    FanImage clone() const { return {levels.clone(), beam_time_ms.clone(), pixel_m, north_m, east_m}; }
};

}  // namespace echotrail
