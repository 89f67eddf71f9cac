#include "core/simulation/simulation_address.hpp"

#include <charconv>
#include <string_view>

namespace echotrail {
namespace {

constexpr std::string_view scheme = "simulation://";

}  // namespace

bool isSimulationAddress(const std::string& text) { return text.starts_with(scheme); }

Result<SimulationAddress> parseSimulationAddress(const std::string& text) {
    if (!isSimulationAddress(text)) return Error{text + " is no simulation; say simulation://NAME?seed=N"};
    SimulationAddress address{.scenario = text.substr(scheme.size())};
    const auto question = address.scenario.find('?');
    if (question != std::string::npos) {
        constexpr std::string_view key = "seed=";
        const std::string query = address.scenario.substr(question + 1);
        const char* end = query.data() + query.size();
        const bool is_seed = query.starts_with(key);
        const auto [stop, failure] = std::from_chars(query.data() + (is_seed ? key.size() : 0), end, address.seed);
        if (!is_seed || failure != std::errc() || stop != end)
            return Error{text + ": after '?' only seed=N is understood, N a whole number"};
        address.scenario.resize(question);
    }
    if (const auto found = findScenario(address.scenario); !found) return Error{found.error()};
    return address;
}

std::string toText(const SimulationAddress& address) {
    std::string text(scheme);
    text.append(address.scenario).append("?seed=").append(std::to_string(address.seed));
    return text;
}

}  // namespace echotrail
