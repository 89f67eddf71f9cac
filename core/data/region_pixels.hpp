#pragma once

#include <cstdint>
#include <vector>

namespace echotrail {

/// A pixel of a region: its place in the picture, its level and how far it stands out (1/255 of 80 dB).
struct RegionPixel {
    std::int16_t row = 0;
    std::int16_t column = 0;
    std::uint8_t level = 0;
    std::uint8_t excess = 0;
    bool operator==(const RegionPixel&) const = default;
};

/// The pixels of one region of a picture.
struct RegionPixels {
    std::vector<RegionPixel> pixels;
    RegionPixel peak;           ///< the strongest
    bool clutter_mass = false;  ///< larger than any target
};

}  // namespace echotrail
