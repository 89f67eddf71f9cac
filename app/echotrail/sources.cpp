#include "sources.hpp"

#include "core/simulation/demonstration.hpp"

#include <algorithm>
#include <charconv>

namespace echotrail {

namespace {

Result<SourceAddress> parseSimulation(const std::string& text, std::string rest) {
    SourceAddress address{.seed = default_scenario_seed};
    const auto question = rest.find('?');
    if (question != std::string::npos) {
        constexpr std::string_view key = "seed=";
        const std::string query = rest.substr(question + 1);
        const char* end = query.data() + query.size();
        const bool is_seed = query.starts_with(key);
        const auto [stop, failure] = std::from_chars(query.data() + (is_seed ? key.size() : 0), end, address.seed);
        if (!is_seed || failure != std::errc() || stop != end)
            return Error{text + ": after '?' only seed=N is understood, N a whole number"};
        rest.resize(question);
    }
    if (const auto opened = openSimulation(rest, address.seed); !opened) return Error{opened.error()};
    address.scenario = rest;
    return address;
}

}  // namespace

Result<SourceAddress> parseSourceAddress(const std::string& text) {
    const auto colon = text.find("://");
    if (colon == std::string::npos) return SourceAddress{.path = text};
    const std::string scheme = text.substr(0, colon);
    if (scheme == "simulation") return parseSimulation(text, text.substr(colon + 3));
    if (scheme == "serial" || scheme == "tcp" || scheme == "udp")
        return Error{text + ": a live source cannot be replayed; give a recording or simulation://NAME?seed=N"};
    return Error{text + ": no source is called " + scheme + "://; give a recording or simulation://NAME?seed=N"};
}

Result<std::unique_ptr<PingSource>> openSource(const SourceAddress& address, const RecordingOptions& options) {
    if (address.scenario.empty()) return openRecording(address.path, options);
    auto simulated = openSimulation(address.scenario, address.seed);
    if (!simulated) return Error{simulated.error()};
    return std::unique_ptr<PingSource>(*std::move(simulated));
}

}  // namespace echotrail
