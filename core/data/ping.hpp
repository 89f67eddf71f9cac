#pragma once

#include <cstdint>
#include <vector>

#include "core/base/angles.hpp"
#include "core/base/time.hpp"

namespace echotrail {

/// Full scale of the sonar's logarithmic receiver: level 255 is 80 dB above level 0 (Tritech DigSon notes).
inline constexpr double full_scale_db = 80.0;
inline constexpr double levels_per_db = 255.0 / full_scale_db;

/// One echo line: what the head heard after one transmission.
struct Ping {
    std::uint64_t sequence = 0;          ///< counts from 0 within its source
    Timestamp time{};                    ///< the instant of transmission, not of arrival
    Bearing bearing;                     ///< of the transducer, from the head's zero (ahead), clockwise from above
    double step_rad = 0.0;               ///< between this ping and the next; always positive
    double range_scale_m = 0.0;          ///< what the operator chose; the true extent is levels.size() * binSize()
    double bin_interval_s = 0.0;         ///< two-way time from bin to bin
    double sound_speed_mps = 0.0;
    double frequency_hz = 0.0;           ///< 0 where the head does not tell
    double gain_percent = 0.0;
    bool clockwise = true;               ///< the head's own word on its direction; sweeps are told from bearings
    bool motor_lost_sync = false;        ///< the bearing is not to be trusted
    std::vector<std::uint8_t> levels;    ///< bin 0 is nearest; 0…255 is 0…80 dB whatever the wire format was

    /// Range from bin to bin in metres; bin i is centred at (i + 1/2) * binSize().
    double binSize() const { return sound_speed_mps * bin_interval_s / 2.0; }
    bool operator==(const Ping&) const = default;
};

}  // namespace echotrail
