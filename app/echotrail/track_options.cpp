#include "track_options.hpp"

#include "app/io/console_server.hpp"
#include "app/io/recording_path.hpp"

namespace echotrail {

void addTrackOptions(CLI::App& command, TrackArguments& a) {
    command
        .add_option("--sonar", a.sonar,
                    "The head: serial:///dev/ttyUSB0?baud=115200, tcp://HOST:PORT or udp://HOST:PORT?listen=PORT; or "
                    "simulation://NAME?seed=N, a simulated head with its navigation (simulate --list names them)")
        ->required();
    command.add_option("--navigation", a.navigation,
                       "NMEA 0183 (heading, position, speed) from a link of the same form");
    auto* record = command.add_option(
        "--record", a.record, "Log to write (default: $XDG_DATA_HOME/echotrail/recordings/, named by the time; UTC)");
    command.add_flag("--no-record", a.no_record, "Keep nothing")->excludes(record);
    command.add_option(
        "--report", a.report,
        "Motion controller: udp://HOST:PORT or tcp://HOST:PORT gets the target as JSON lines: every look at it, and 10 "
        "times a second, or ?rate=0.1 to 50, where it is by now as predicted: position (m), velocity (m/s), covariance "
        "(m²), age of the last echo (s), validity, closest approach (m), time to it (s) and risk (0 to 1); with "
        "?format=nmea (or &format=nmea) as TTM sentences, and TLL where GGA or RMC say where on earth");
    auto* serve = command.add_option(
        "--serve", a.serve,
        "Consoles are served at tcp://127.0.0.1:PORT (0: any free port), which only this machine reaches, "
        "or at tls://0.0.0.0:PORT, where those may come in that are paired; see echotrail pair");
    command
        .add_flag("--datagrams", a.datagrams,
                  "Picture, regions and particles go to consoles by UDP on the port of --serve, sealed, as long as "
                  "that arrives; all else, and all of it otherwise, by TCP")
        ->needs(serve);
    addRunOptions(command, a);
    command.add_option("--seed", a.seed, "Seed of the random numbers (default 0)")->check(CLI::NonNegativeNumber);
    command
        .add_option("--duration", a.duration_s, "End after so many seconds from the start (default: Ctrl-C ends it)")
        ->check(CLI::PositiveNumber);
    command.add_flag("--quiet", a.quiet, "No health line each second on standard error");
}

Result<TrackOptions> checkTrackOptions(const TrackArguments& a) {
    TrackOptions options{.tracks = a.tracks, .seed = a.seed, .paint_fan = !a.no_fan, .quiet = a.quiet};
    auto addresses = parseLiveAddresses(a.sonar, a.navigation);
    if (!addresses) return Error{"--" + addresses.error()};
    options.addresses = *std::move(addresses);
    auto report = parseLinkOption("--report", a.report);
    if (!report) return Error{report.error()};
    options.report = *std::move(report);
    auto serve = parseLinkOption("--serve", a.serve);
    if (!serve) return Error{serve.error()};
    if (*serve)
        if (auto servable = checkServable(**serve); !servable) return Error{"--serve: " + servable.error()};
    options.serve = *std::move(serve);
    options.datagrams = a.datagrams;
    auto settings = readSettings(a.parameter_files, a.assignments);
    if (!settings) return Error{settings.error()};
    options.settings = *std::move(settings);
    if (!a.target.empty()) {
        const auto target = targetFrom(a.target);
        if (!target) return Error{target.error()};
        options.target = *target;
    }
    if (a.duration_s > 0.0) options.duration_s = a.duration_s;
    options.record = a.record;
    if (!a.no_record && a.record.empty()) {
        auto path = newRecordingPath();
        if (!path) return Error{path.error() + "; give --record LOG or --no-record"};
        options.record = *std::move(path);
    }
    return options;
}

}  // namespace echotrail
