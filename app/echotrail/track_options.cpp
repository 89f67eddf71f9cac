#include "track_options.hpp"

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>

namespace echotrail {

namespace {

/// `$XDG_DATA_HOME/echotrail/recordings/20261124-183000.echotrail`, by UTC; a number behind it where it exists.
Result<std::string> defaultRecording() {
    const char* data_home = std::getenv("XDG_DATA_HOME");
    const char* home = std::getenv("HOME");
    if ((!data_home || !*data_home) && (!home || !*home))
        return Error{"neither XDG_DATA_HOME nor HOME says where recordings go; give --record LOG or --no-record"};
    const std::filesystem::path base =
        data_home && *data_home ? std::filesystem::path(data_home) : std::filesystem::path(home) / ".local/share";
    const std::filesystem::path folder = base / "echotrail/recordings";
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure)
        return Error{"cannot make the folder " + folder.string() + ": " + failure.message() +
                     "; give --record LOG or --no-record"};
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    std::tm utc{};
    gmtime_r(&now, &utc);
    char name[32];
    std::strftime(name, sizeof name, "%Y%m%d-%H%M%S", &utc);
    std::filesystem::path path = folder / (std::string(name) + ".echotrail");
    for (int i = 2; std::filesystem::exists(path, failure); ++i)
        path = folder / (std::string(name) + "_" + std::to_string(i) + ".echotrail");
    return path.string();
}

Result<std::optional<LinkAddress>> optionalLink(const std::string& option, const std::string& text) {
    if (text.empty()) return std::optional<LinkAddress>();
    auto address = parseLinkAddress(text);
    if (!address) return Error{option + ": " + address.error()};
    return std::optional(*std::move(address));
}

}  // namespace

void addTrackOptions(CLI::App& command, TrackArguments& a) {
    command
        .add_option("--sonar", a.sonar,
                    "The head: serial:///dev/ttyUSB0?baud=115200, tcp://HOST:PORT or udp://HOST:PORT?listen=PORT")
        ->required();
    command.add_option("--navigation", a.navigation,
                       "NMEA 0183 (heading, position, speed) from a link of the same form");
    auto* record = command.add_option(
        "--record", a.record, "Log to write (default: $XDG_DATA_HOME/echotrail/recordings/, named by the time; UTC)");
    command.add_flag("--no-record", a.no_record, "Keep nothing")->excludes(record);
    command.add_option("--report", a.report,
                       "Motion controller: udp://HOST:PORT or tcp://HOST:PORT gets the target as JSON lines at every "
                       "update and at 10 Hz between; with ?format=nmea as TTM sentences");
    command.add_option("--tracks", a.tracks, "Write tracks as JSON Lines to this file, or - for standard output");
    command.add_option("--target", a.target,
                       "RANGE_M,BEARING_DEG of the target, in metres and degrees clockwise from the bow, seen from the "
                       "head at the first ping (default: none designated)");
    command.add_option("--parameters", a.parameter_files, "TOML file of parameters; may be given more than once");
    command.add_option("--set", a.assignments, "NAME=VALUE of one parameter; may be given more than once");
    command.add_option("--seed", a.seed, "Seed of the random numbers (default 0)")->check(CLI::NonNegativeNumber);
    command
        .add_option("--duration", a.duration_s, "End after so many seconds from the start (default: Ctrl-C ends it)")
        ->check(CLI::PositiveNumber);
    command.add_flag("--no-fan", a.no_fan, "Do not paint the fan image: tracks only");
    command.add_flag("--quiet", a.quiet, "No health line each second on standard error");
    command.footer([] { return "\n" + parameterHelp(); });
}

Result<TrackOptions> checkTrackOptions(const TrackArguments& a) {
    TrackOptions options{.tracks = a.tracks, .seed = a.seed, .paint_fan = !a.no_fan, .quiet = a.quiet};
    auto sonar = parseLinkAddress(a.sonar);
    if (!sonar) return Error{"--sonar: " + sonar.error()};
    options.sonar = *std::move(sonar);
    auto navigation = optionalLink("--navigation", a.navigation);
    if (!navigation) return Error{navigation.error()};
    options.navigation = *std::move(navigation);
    auto report = optionalLink("--report", a.report);
    if (!report) return Error{report.error()};
    options.report = *std::move(report);
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
        auto path = defaultRecording();
        if (!path) return Error{path.error()};
        options.record = *std::move(path);
    }
    return options;
}

}  // namespace echotrail
