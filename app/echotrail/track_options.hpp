#pragma once

#include "app/io/live_addresses.hpp"
#include "replay_options.hpp"

#include <CLI/App.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace echotrail {

/// The command line of `echotrail track`, as typed.
struct TrackArguments : RunArguments {
    std::string sonar, navigation, record, report, serve;
    std::uint64_t seed = 0;
    double duration_s = 0.0;  ///< 0: until it is told to end
    bool no_record = false, datagrams = false, quiet = false;
};

/// The same, understood and checked.
struct TrackOptions {
    LiveAddresses addresses;
    std::optional<LinkAddress> report;
    std::optional<LinkAddress> serve;  ///< consoles
    bool datagrams = false;            ///< to them
    std::string record;                ///< file, or nothing
    std::string tracks;                ///< file, "-" or nothing
    std::optional<ReplayOptions::Target> target;
    Settings settings;
    std::uint64_t seed = 0;
    std::optional<double> duration_s;
    bool paint_fan = true, quiet = false;
};

void addTrackOptions(CLI::App& command, TrackArguments& arguments);

/// The error is a matter of usage.
Result<TrackOptions> checkTrackOptions(const TrackArguments& arguments);

}  // namespace echotrail
