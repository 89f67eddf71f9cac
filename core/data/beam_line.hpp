#pragma once

#include "core/base/angles.hpp"
#include "core/base/time.hpp"

#include <cstdint>
#include <vector>

namespace echotrail {

/// One echo line as detection compares it: per range cell the level and what it has to reach, 0…255 for 0…80 dB.
/// Cell i is centred at (i + 1/2) * cell_m.
struct BeamLine {
    Timestamp time{};
    Bearing from_bow;
    Bearing from_north;
    double cell_m = 0.0;
    std::vector<std::uint8_t> level;
    std::vector<std::uint8_t> threshold;  ///< empty where nobody told it

    /// A threshold where nothing is detected, however strong.
    static constexpr std::uint8_t never = 255;
};

}  // namespace echotrail
