#pragma once

#include "core/data/ping.hpp"
#include "core/simulation/scenario.hpp"

#include <cstdint>

namespace echotrail {

/// The first ping of every simulation.
inline constexpr Timestamp simulation_start = std::chrono::sys_days{std::chrono::year{2026} / 1 / 1};

/// Time from ping to ping in seconds: the sound's way there and back, then the motor and the serial line.
double pingInterval(const Scenario& scenario);

/// Time of a ping in seconds since the first one, in whole microseconds as its timestamp has them.
double pingTime(const Scenario& scenario, std::uint64_t number);

/// Bearing of the transducer from the bow: the sector to and fro, beginning to port, each end once.
Bearing pingBearing(const Scenario& scenario, std::uint64_t number);

/// One ping of a scanning sonar at 325 kHz with a beam of 3° by 20° (method card, section i): 800 bins of 8 bits.
/// Every bin adds the powers of targets, debris, bottom, surface, volume and noise, and multiplies them by the
/// speckle of a single look. It depends on nothing but its arguments: pings can be made in any order.
Ping simulatePing(const Scenario& scenario, std::uint64_t seed, std::uint64_t number);

}  // namespace echotrail
