#include "console_options.hpp"

#include <CLI/CLI.hpp>

#include <iostream>
#include <vector>

namespace echotrail {
namespace {

constexpr int usage_error = 2;

/// Files first, then single values over them, whatever their order on the command line.
Result<void> applyParameters(ScanningSonarPipeline::Params& params, const std::vector<std::string>& files,
                             const std::vector<std::string>& assignments) {
    for (const std::string& file : files)
        if (auto applied = applyParameterFile(params, file); !applied) return applied;
    for (const std::string& assignment : assignments)
        if (auto set = setParameterFromText(params, assignment); !set) return set;
    return {};
}

}  // namespace

std::variant<ConsoleOptions, int> readConsoleOptions(int argc, char** argv) {
    ConsoleOptions options;
    std::vector<std::string> files;
    std::vector<std::string> assignments;
    CLI::App app{
        "Echotrail operator console: polls a sonar head, or plays recordings, and shows what the tracker finds."};
    app.set_version_flag("--version", ECHOTRAIL_VERSION);
    auto* recording =
        app.add_option("RECORDING", options.recording, "Recording to open: .echotrail, .V4LOG or raw .bin");
    auto* demonstration =
        app.add_flag("--demonstration", options.demonstration, "Open the built-in simulated approach");
    demonstration->excludes(recording);
    auto* sonar = app.add_option("--sonar", options.sonar,
                                 "Connect to a head: serial:///dev/ttyUSB0?baud=115200, tcp://HOST:PORT or "
                                 "udp://HOST:PORT?listen=PORT; or to a simulated one: simulation://NAME?seed=N");
    sonar->excludes(recording)->excludes(demonstration);
    app.add_option("--navigation", options.navigation, "NMEA 0183 (heading, position, speed) from a link of this form")
        ->needs(sonar);
    app.add_flag("--no-record", options.no_record, "Keep nothing of what the head or the tracker sends");
    app.add_option("--connect", options.connect,
                   "Follow a tracker: tls://HOST:PORT once 'echotrail pair' has been run on both sides, or "
                   "tcp://127.0.0.1:PORT on "
                   "this machine")
        ->excludes(recording)
        ->excludes(demonstration)
        ->excludes(sonar);
    auto* picture = app.add_option("--screenshot", options.screenshot,
                                   "Write a PNG of the window at --at, then exit; settings are not touched");
    app.add_option("--at", options.at_s,
                   "Moment of the picture in seconds from the start (default: the end, or the first sweep of a head)")
        ->check(CLI::NonNegativeNumber)
        ->needs(picture);
    app.add_option("--palette", options.palette, "day, dusk or night (default: as last time)")
        ->check(CLI::IsMember({"day", "dusk", "night"}));
    app.add_option("--language", options.language, "en or zh (default: as last time, or the computer's)")
        ->check(CLI::IsMember({"en", "zh"}));
    app.add_option("--width", options.width, "Width of the window, px (default 1600)")->check(CLI::Range(640, 7680));
    app.add_option("--height", options.height, "Height of the window, px (default 1000)")->check(CLI::Range(480, 4320));
    app.add_option("--parameters", files, "TOML file of parameters; may be given more than once");
    app.add_option("--set", assignments, "NAME=VALUE of one parameter; may be given more than once");
    app.add_option("--seed", options.seed, "Seed of the random numbers (default 0)");
    app.add_option("--quit-after", options.quit_after_s, "Close the window after so many seconds")
        ->check(CLI::NonNegativeNumber);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : usage_error;
    }
    if (!options.screenshot.empty() && options.recording.empty() && !options.demonstration && options.sonar.empty() &&
        options.connect.empty() && options.at_s) {
        std::cerr << "echotrail-console: --at needs a RECORDING, --demonstration, --sonar or --connect\n";
        return usage_error;
    }
    if (options.no_record && options.sonar.empty() && options.connect.empty()) {
        std::cerr << "echotrail-console: --no-record needs --sonar or --connect\n";
        return usage_error;
    }
    if (const auto applied = applyParameters(options.params, files, assignments); !applied) {
        std::cerr << "echotrail-console: " << applied.error() << "\n";
        return usage_error;
    }
    options.params_given = !files.empty() || !assignments.empty();
    return options;
}

}  // namespace echotrail
