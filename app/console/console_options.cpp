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

/// Each moment belongs to the picture in the same place of its list.
Result<void> applyPictures(Schedule& schedule, const std::vector<std::string>& files, const std::vector<double>& at_s) {
    const bool one_at_the_end = files.size() == 1 && at_s.empty();
    if (!one_at_the_end && files.size() != at_s.size())
        return Error{"each of several --screenshot-to needs its own --at, in the same order"};
    for (std::size_t i = 0; i < files.size(); ++i)
        schedule.pictures.push_back({QString::fromStdString(files[i]), at_s.empty() ? Schedule::unsaid : at_s[i]});
    return {};
}

constexpr auto exit_codes = R"(
Exit codes: 0 done; 1 failed while running (a source that cannot be opened, a picture that cannot be written), one line
on standard error says why; 2 usage; 3 done, but records of the source were lost or rejected, its recording has failed, or
a moment asked for lies past its end. Ctrl-C and SIGTERM end a run cleanly.)";

}  // namespace

std::variant<ConsoleOptions, int> readConsoleOptions(int argc, char** argv) {
    ConsoleOptions options;
    std::vector<std::string> files;
    std::vector<std::string> assignments;
    std::vector<std::string> pictures;
    std::vector<double> at_s;
    std::string dock;
    CLI::App app{
        "Echotrail operator console: polls a sonar head, or plays recordings, and shows what the tracker finds."};
    app.set_version_flag("--version", ECHOTRAIL_VERSION);
    app.footer(exit_codes);
    auto* recording =
        app.add_option("RECORDING,--replay", options.recording, "Recording to open: .echotrail, .V4LOG or raw .bin");
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
    app.add_option(
           "--target", options.target,
           "RANGE_M,BEARING_DEG of the target, in metres and degrees clockwise from the bow, seen from the head "
           "at the first ping, or when a tracker first takes orders from here (default: none designated)")
        ->delimiter(',');
    app.add_flag(
        "--headless", options.headless,
        "Needs no display: nobody sees the window, no settings are read or written. A recording is gone through "
        "as fast as the machine can, to --exit-at, the last picture, or its end; a head is polled until then, "
        "or Ctrl-C");
    auto* picture = app.add_option("--screenshot-to,--screenshot", pictures,
                                   "Write a PNG of the window at the --at that goes with it, and exit after the last; "
                                   "may be given more than once")
                        ->allow_extra_args(false);
    app.add_option("--at", at_s,
                   "Moment of a picture in seconds: of a recording from its first ping, else from the start of the "
                   "program (default for one picture: the end, or the first sweep of a head)")
        ->check(CLI::NonNegativeNumber)
        ->allow_extra_args(false)
        ->needs(picture);
    app.add_option("--exit-at", options.schedule.exit_at_s,
                   "Moment to exit at, in the same seconds (default: after the last picture)")
        ->check(CLI::NonNegativeNumber);
    app.add_option("--show", dock, "Panel to bring to the front for the pictures")
        ->check(CLI::IsMember(
            {"connection", "layers", "chart", "tracks", "parameters", "plan", "alerts", "time_line", "beam"}))
        ->needs(picture);
    app.add_option("--palette", options.palette, "day, dusk or night (default: as last time)")
        ->check(CLI::IsMember({"day", "dusk", "night"}));
    app.add_option("--language", options.language, "en or zh (default: as last time, or the computer's)")
        ->check(CLI::IsMember({"en", "zh"}));
    app.add_option("--width", options.width, "Width of the window, px (default: as last time, or 1600)")
        ->check(CLI::Range(640, 7680));
    app.add_option("--height", options.height, "Height of the window, px (default: as last time, or 1000)")
        ->check(CLI::Range(480, 4320));
    app.add_option("--parameters", files, "TOML file of parameters; may be given more than once; not with --connect");
    app.add_option("--set", assignments,
                   "NAME=VALUE of one parameter; may be given more than once; not with --connect");
    app.add_option("--seed", options.seed, "Seed of the random numbers (default 0)");
    app.add_option("--quit-after", options.quit_after_s, "Close the window after so many seconds")
        ->check(CLI::NonNegativeNumber);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : usage_error;
    }
    if (options.no_record && options.sonar.empty() && options.connect.empty()) {
        std::cerr << "echotrail-console: --no-record needs --sonar or --connect\n";
        return usage_error;
    }
    if (!options.connect.empty() && (!files.empty() || !assignments.empty())) {
        std::cerr
            << "echotrail-console: a tracker has its own parameters: give them to 'echotrail track', or set them in "
               "the panel Parameters once connected\n";
        return usage_error;
    }
    auto applied = applyParameters(options.params, files, assignments);
    if (applied) applied = applyPictures(options.schedule, pictures, at_s);
    if (!applied) {
        std::cerr << "echotrail-console: " << applied.error() << "\n";
        return usage_error;
    }
    options.schedule.dock = QString::fromStdString(dock);
    options.params_given = !files.empty() || !assignments.empty();
    return options;
}

}  // namespace echotrail
