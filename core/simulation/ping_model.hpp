#pragma once

#include "core/data/ping.hpp"
#include "core/simulation/scenario.hpp"

#include <cstdint>
#include <vector>

namespace echotrail {

/// The first ping of every simulation.
inline constexpr Timestamp simulation_start = std::chrono::sys_days{std::chrono::year{2026} / 1 / 1};

/// How a head is set for one transmission: what its commands ask of it.
struct HeadSetup {
    double range_m = 50.0;
    int bins = 800;
    double bin_interval_s = 2.0 * 50.0 / 1490.0 / 800;  ///< two-way time from bin to bin
    Bearing bearing;                                    ///< of the beam, from the head's zero
    double step_rad = radiansFromDegrees(1.8);
    double frequency_hz = 325e3;
    double gain_db = 32.0;   ///< initial gain, 0…80 dB; a scenario's own gain is meant for 32 dB (40 %)
    double ad_low_db = 0.0;  ///< the window that 4-bit levels are packed in; the echo itself is made without it
    double ad_span_db = 80.0;
    int bits = 8;
    double sound_speed = 1490.0;  ///< m/s

    double binSize() const { return sound_speed * bin_interval_s / 2.0; }  ///< in metres
};

/// Time from ping to ping in seconds: the sound's way there and back, then the motor and the serial line.
double pingInterval(const Scenario& scenario);

/// Time of a ping in seconds since the first one, in whole microseconds as its timestamp has them.
double pingTime(const Scenario& scenario, std::uint64_t number);

/// Bearing of the transducer from the bow: the sector to and fro, beginning to port, each end once.
Bearing pingBearing(const Scenario& scenario, std::uint64_t number);

/// What a head at the vehicle's bow hears of a transmission `time_s` after the scenario's start (method card,
/// section i): one level per bin, 0…255 for 0…80 dB, before any packing. Every bin adds the powers of targets, debris,
/// bottom, surface, volume and noise, and multiplies them by the speckle of a single look. `number` names the ping:
/// its speckle. It depends on nothing but its arguments: pings can be made in any order.
std::vector<std::uint8_t> simulateEcho(const Scenario& scenario, std::uint64_t seed, const HeadSetup& head,
                                       double time_s, std::uint64_t number);

/// One ping of the scenario's own scan: simulateEcho with 800 bins of 8 bits at the usual gain.
Ping simulatePing(const Scenario& scenario, std::uint64_t seed, std::uint64_t number);

}  // namespace echotrail
