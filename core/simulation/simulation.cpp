#include "core/simulation/simulation.hpp"

#include "core/simulation/simulated_source.hpp"

namespace echotrail {

std::vector<ScenarioInfo> scenarios() {
    std::vector<ScenarioInfo> all;
    for (const Scenario& scenario : builtInScenarios())
        all.push_back({scenario.name, scenario.about, scenario.duration_s});
    return all;
}

Result<std::unique_ptr<PingSource>> openSimulation(std::string_view name, std::uint64_t seed) {
    std::string known;
    for (const Scenario& scenario : builtInScenarios()) {
        if (scenario.name == name)
            return std::unique_ptr<PingSource>(std::make_unique<SimulatedSource>(scenario, seed));
        known += (known.empty() ? "" : ", ") + scenario.name;
    }
    return Error{"no scenario is called " + std::string(name) + "; there are: " + known};
}

}  // namespace echotrail
