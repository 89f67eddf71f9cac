// print_looks RECORDING, or print_looks SCENARIO SEED: the looks that the default pipeline makes of it, one JSON object
// a line. Of the core alone, so that a second build of it costs little: the two are compared.

#include "core/pipelines/scanning_sonar_pipeline.hpp"
#include "core/recording/recording.hpp"
#include "core/simulation/simulated_source.hpp"

#include <nlohmann/json.hpp>

#include <iostream>
#include <memory>
#include <string>

namespace echotrail {
namespace {

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

template <typename Source>
int printLooks(const Result<std::unique_ptr<Source>>& source) {
    if (!source) {
        std::cerr << "print_looks: " << source.error() << '\n';
        return 1;
    }
    constexpr std::uint64_t tracker_seed = 1;
    ScanningSonarPipeline pipeline({}, tracker_seed);
    while (const auto ping = (*source)->next()) print(pipeline.process(*ping, (*source)->navigation()));
    print(pipeline.finish());
    return 0;
}

}  // namespace
}  // namespace echotrail

int main(int count, char** arguments) {
    if (count == 2) return echotrail::printLooks(echotrail::openRecording(arguments[1]));
    if (count == 3) return echotrail::printLooks(echotrail::openSimulation(arguments[1], std::stoull(arguments[2])));
    std::cerr << "usage: print_looks RECORDING | print_looks SCENARIO SEED\n";
    return 2;
}
