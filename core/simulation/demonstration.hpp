#pragma once

#include "core/simulation/simulated_source.hpp"

namespace echotrail {

/// The seed of a scenario opened without one.
inline constexpr std::uint64_t default_scenario_seed = 1;

/// The built-in demonstration: a target comes in from 40 m to 12 m.
inline Result<std::unique_ptr<PingSource>> makeDemonstration(std::uint64_t seed = default_scenario_seed) {
    auto opened = openSimulation("demonstration", seed);
    if (!opened) return Error{opened.error()};
    return std::unique_ptr<PingSource>(*std::move(opened));
}

}  // namespace echotrail
