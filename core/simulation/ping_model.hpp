#pragma once

#include "core/data/ping.hpp"
#include "core/simulation/head_setup.hpp"
#include "core/simulation/scenario.hpp"

#include <cstdint>
#include <vector>

namespace echotrail {

class EchoModel;

/// The first ping of every simulation.
inline constexpr Timestamp simulation_start = std::chrono::sys_days{std::chrono::year{2026} / 1 / 1};

/// Time from ping to ping in seconds: the sound's way there and back, then the motor and the serial line.
double pingInterval(const Scenario& scenario);

/// Time of a ping in seconds since the first one, in whole microseconds as its timestamp has them.
double pingTime(const Scenario& scenario, std::uint64_t number);

/// Bearing of the transducer from the bow: the sector to and fro, beginning to port, each end once.
Bearing pingBearing(const Scenario& scenario, std::uint64_t number);

/// What a head at the vehicle's bow hears of a transmission `time_s` after the scenario's start (method card,
/// section i): one level per bin, 0…255 for 0…80 dB, before any packing. Every bin adds the powers of targets, debris,
/// bottom, surface, volume and noise, and multiplies them by the speckle of a single look. `number` names the ping:
/// its speckle. The head has some bins, each longer than nothing; before the start all is as at the start. It
/// depends on nothing but its arguments: pings can be made in any order.
std::vector<std::uint8_t> simulateEcho(const Scenario& scenario, std::uint64_t seed, const HeadSetup& head,
                                       double time_s, std::uint64_t number);

/// How the scenario's own head is set for a ping: 800 bins of 8 bits at the usual gain.
HeadSetup headSetup(const Scenario& scenario, std::uint64_t number);

/// One ping of the scenario's own scan.
Ping simulatePing(const Scenario& scenario, std::uint64_t seed, std::uint64_t number);
/// The same by a model of that scenario, which makes many of them faster.
Ping simulatePing(const Scenario& scenario, EchoModel& model, std::uint64_t number);
/// What a head that is set like this makes of the transmission at pingTime(number), by a model of that scenario.
Ping simulatePing(const Scenario& scenario, EchoModel& model, std::uint64_t number, const HeadSetup& head,
                  bool clockwise);

}  // namespace echotrail
