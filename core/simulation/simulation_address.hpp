#pragma once

#include "core/base/result.hpp"
#include "core/simulation/demonstration.hpp"

#include <cstdint>
#include <string>

namespace echotrail {

/// A built-in scenario as it is named on a command line: `simulation://NAME?seed=N`.
struct SimulationAddress {
    std::string scenario;  ///< a known name
    std::uint64_t seed = default_scenario_seed;
    bool operator==(const SimulationAddress&) const = default;
};

/// Whether a text begins as one.
bool isSimulationAddress(const std::string& text);

/// The error, a matter of usage, says what would be accepted.
Result<SimulationAddress> parseSimulationAddress(const std::string& text);

/// As it is typed.
std::string toText(const SimulationAddress& address);

}  // namespace echotrail
