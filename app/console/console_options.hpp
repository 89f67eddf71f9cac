#pragma once

#include "core/pipelines/scanning_sonar_pipeline.hpp"
#include "unattended.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace echotrail {

/// The command line of echotrail-console, read and checked.
struct ConsoleOptions {
    std::string recording;  ///< empty: none
    bool demonstration = false;
    std::string sonar;       ///< address of a head to connect to; empty: none
    std::string navigation;  ///< address of its NMEA 0183; empty: none
    bool no_record = false;
    std::string connect;  ///< address of a tracker to follow; empty: none
    bool headless = false;
    Schedule schedule;
    std::optional<std::pair<double, double>> target;  ///< range in metres and bearing from the bow in degrees
    std::string palette;                              ///< empty: as last time
    std::string language;                             ///< the same
    std::optional<int> width, height;                 ///< of the window, px; none: as last time
    ScanningSonarPipeline::Params params;
    bool params_given = false;  ///< they count over those in a recording
    std::uint64_t seed = 0;
    std::optional<double> quit_after_s;

    bool hasSource() const { return demonstration || !recording.empty() || isLive(); }
    bool isLive() const { return !sonar.empty() || !connect.empty(); }
    /// Nobody sits at it: it runs by its schedule, and no settings are read or written.
    bool isUnattended() const { return headless || !schedule.pictures.empty() || schedule.exit_at_s; }
};

/// The options, or the exit code with everything said on the standard streams: 0 after --help, 2 for wrong usage.
std::variant<ConsoleOptions, int> readConsoleOptions(int argc, char** argv);

}  // namespace echotrail
