#pragma once

#include "core/base/angles.hpp"
#include "settings.hpp"
#include "sources.hpp"

#include <CLI/App.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace echotrail {

/// What every run of the tracker is asked, as typed.
struct RunArguments {
    std::string tracks, target;
    std::vector<std::string> parameter_files, assignments;
    bool no_fan = false;
};
void addRunOptions(CLI::App& command, RunArguments& arguments);

/// The command line of `echotrail replay`, as typed.
struct ReplayArguments : RunArguments {
    std::string source, speed = "max", navigation;
    std::optional<std::uint64_t> seed;
    double duration_s = 0.0;  ///< 0: to the end
    bool timings = false;
};

/// The same, understood and checked.
struct ReplayOptions {
    struct Target {
        double range_m;
        Bearing from_bow;
    };
    SourceAddress source;
    Settings settings;
    std::vector<std::string> parameter_files, assignments;  ///< to set over what a recording brings
    std::optional<double> speed;                            ///< times real time; none: as fast as it goes
    std::optional<Target> target;
    std::string navigation;  ///< file of NMEA lines, or nothing
    std::string tracks;      ///< file, "-" or nothing
    std::optional<std::uint64_t> seed;
    std::optional<double> duration_s;
    bool paint_fan = true, timings = false;
};

/// Reads "RANGE_M,BEARING_DEG".
Result<ReplayOptions::Target> targetFrom(const std::string& text);

void addReplayOptions(CLI::App& command, ReplayArguments& arguments);

/// The error is a matter of usage.
Result<ReplayOptions> checkReplayOptions(const ReplayArguments& arguments);

}  // namespace echotrail
