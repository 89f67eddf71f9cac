// print_looks SOURCE: the looks that the default pipeline makes of a recording or of simulation://NAME?seed=N, one JSON
// object a line. Of the core alone, so that a second build of it costs little: the two are compared.

#include "core/pipelines/scanning_sonar_pipeline.hpp"
#include "core/recording/recording.hpp"
#include "core/simulation/simulated_source.hpp"
#include "core/simulation/simulation_address.hpp"

#include <nlohmann/json.hpp>

#include <iostream>

namespace echotrail {
namespace {

Result<std::unique_ptr<PingSource>> open(const std::string& source) {
    if (!isSimulationAddress(source)) return openRecording(source);
    const auto address = parseSimulationAddress(source);
    if (!address) return Error{address.error()};
    auto simulated = openSimulation(address->scenario, address->seed);
    if (!simulated) return Error{simulated.error()};
    return std::unique_ptr<PingSource>(*std::move(simulated));
}

void print(const Update& update) {
    for (const TrackLook& look : update.looks)
        std::cout << nlohmann::json{{"time", look.time.time_since_epoch().count()},
                                    {"track", look.track},
                                    {"state", toText(look.state)},
                                    {"seen", look.seen},
                                    {"range_m", look.range_m},
                                    {"north_m", look.position_m.x()},
                                    {"east_m", look.position_m.y()}}
                  << '\n';
}

int printLooks(const std::string& name) {
    const auto source = open(name);
    if (!source) {
        std::cerr << source.error() << '\n';
        return 1;
    }
    constexpr std::uint64_t seed = 1;
    ScanningSonarPipeline pipeline({}, seed);
    while (const auto ping = (*source)->next()) print(pipeline.process(*ping, (*source)->navigation()));
    print(pipeline.finish());
    return 0;
}

}  // namespace
}  // namespace echotrail

int main(int count, char** arguments) { return count == 2 ? echotrail::printLooks(arguments[1]) : 2; }
