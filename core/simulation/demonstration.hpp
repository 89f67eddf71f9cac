#pragma once

#include "core/simulation/simulation.hpp"

namespace echotrail {

/// The built-in demonstration: a target comes in from 40 m to 12 m.
inline Result<std::unique_ptr<PingSource>> makeDemonstration(std::uint64_t seed = default_scenario_seed) {
    return openSimulation("demonstration", seed);
}

}  // namespace echotrail
