#pragma once

#include "core/base/result.hpp"
#include "core/data/source.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace echotrail {

struct ScenarioInfo {
    std::string name;
    std::string about;  ///< one line
    double duration_s = 0.0;
};

/// The seed of a scenario opened without one.
inline constexpr std::uint64_t default_scenario_seed = 1;

/// The built-in scenarios, the demonstration first.
std::vector<ScenarioInfo> scenarios();

/// A built-in scenario as a source of pings; the same seed gives the same bytes. The error lists the known names.
Result<std::unique_ptr<PingSource>> openSimulation(std::string_view name, std::uint64_t seed = default_scenario_seed);

}  // namespace echotrail
