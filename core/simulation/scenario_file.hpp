#pragma once

#include "core/base/result.hpp"
#include "core/simulation/scenario.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace echotrail {

/// Reads a scenario: TOML with the names of scenario_fields.hpp at the top and in the tables [vehicle], [navigation],
/// [[targets]] (with path = [[time_s, north_m, east_m], …] and fades = [[from_s, until_s, depth_db], …]), [[debris]]
/// and [[debris_fields]]. `file` is for errors, which say what is wrong and in which line. A scenario that was read can
/// be simulated: its sector is a whole number of steps, times rise, the vehicle begins at the origin, nothing is
/// infinite.
Result<Scenario> readScenario(std::string_view toml, const std::string& file = "scenario");

/// A file of resources/scenarios, as the library holds it.
struct ScenarioText {
    std::string_view file;
    std::string_view toml;
};
const std::vector<ScenarioText>& scenarioTexts();

}  // namespace echotrail
