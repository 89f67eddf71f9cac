#include "sources.hpp"

namespace echotrail {

Result<SourceAddress> parseSourceAddress(const std::string& text) {
    const auto colon = text.find("://");
    if (colon == std::string::npos) return SourceAddress{.path = text};
    const std::string scheme = text.substr(0, colon);
    if (isSimulationAddress(text)) {
        auto address = parseSimulationAddress(text);
        if (!address) return Error{address.error()};
        return SourceAddress{.simulation = *std::move(address)};
    }
    if (scheme == "serial" || scheme == "tcp" || scheme == "udp")
        return Error{text + ": a live source cannot be replayed; give a recording or simulation://NAME?seed=N"};
    return Error{text + ": no source is called " + scheme + "://; give a recording or simulation://NAME?seed=N"};
}

Result<std::unique_ptr<PingSource>> openSource(const SourceAddress& address, const RecordingOptions& options) {
    if (!address.simulation) return openRecording(address.path, options);
    auto simulated = openSimulation(address.simulation->scenario, address.simulation->seed);
    if (!simulated) return Error{simulated.error()};
    return std::unique_ptr<PingSource>(*std::move(simulated));
}

}  // namespace echotrail
