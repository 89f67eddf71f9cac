#include "replay_options.hpp"

#include <charconv>
#include <cmath>
#include <string_view>

namespace echotrail {

namespace {

std::optional<double> numberFrom(std::string_view text) {
    double value = 0.0;
    const auto [stop, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc() || stop != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

}  // namespace

Result<ReplayOptions::Target> targetFrom(const std::string& text) {
    const auto comma = text.find(',');
    const auto range = numberFrom(std::string_view(text).substr(0, comma));
    const auto bearing =
        comma == std::string::npos ? std::nullopt : numberFrom(std::string_view(text).substr(comma + 1));
    if (!range || !bearing || *range <= 0.0 || std::abs(*bearing) > 360.0)
        return Error{"--target " + text + " is not RANGE_M,BEARING_DEG, as in 25,-10"};
    return ReplayOptions::Target{*range, Bearing::degrees(*bearing)};
}

void addRunOptions(CLI::App& command, RunArguments& a) {
    command.add_option("--tracks", a.tracks, "Write tracks as JSON Lines to this file, or - for standard output");
    command.add_option("--target", a.target,
                       "RANGE_M,BEARING_DEG of the target, in metres and degrees clockwise from the bow, seen from the "
                       "head at the first ping (default: none designated)");
    command.add_option("--parameters", a.parameter_files,
                       "TOML file of parameters, or a preset's name; may be given more than once");
    command.add_option("--set", a.assignments, "NAME=VALUE of one parameter; may be given more than once");
    command.add_flag("--no-fan", a.no_fan, "Do not paint the fan image: tracks only, and faster");
    command.footer([] { return "\n" + parameterHelp(); });
}

void addReplayOptions(CLI::App& command, ReplayArguments& a) {
    command.add_option("SOURCE", a.source, "Recording (.echotrail, .V4LOG or raw .bin), or simulation://NAME?seed=N")
        ->required();
    command.add_option("--speed", a.speed, "max, or times real time (default max)");
    command.add_option("--navigation", a.navigation,
                       "File of NMEA 0183 lines with TAG block times, for a recording without navigation");
    addRunOptions(command, a);
    command.add_option("--seed", a.seed, "Seed of the random numbers (default 0, or that of the recording)")
        ->check(CLI::NonNegativeNumber);
    command.add_option("--duration", a.duration_s, "Stop after so many seconds of the recording (default: its end)")
        ->check(CLI::PositiveNumber);
    command.add_flag("--timings", a.timings, "Say at the end how long pings took, on standard error");
}

Result<ReplayOptions> checkReplayOptions(const ReplayArguments& a) {
    ReplayOptions options{
        .navigation = a.navigation, .tracks = a.tracks, .seed = a.seed, .paint_fan = !a.no_fan, .timings = a.timings};
    options.parameter_files = a.parameter_files;
    options.assignments = a.assignments;
    auto source = parseSourceAddress(a.source);
    if (!source) return Error{source.error()};
    options.source = *std::move(source);
    auto settings = readSettings(a.parameter_files, a.assignments);
    if (!settings) return Error{settings.error()};
    options.settings = *std::move(settings);
    if (a.speed != "max") {
        options.speed = numberFrom(a.speed);
        if (!options.speed || *options.speed <= 0.0)
            return Error{"--speed " + a.speed + " is neither max nor a number above 0"};
    }
    if (!a.target.empty()) {
        const auto target = targetFrom(a.target);
        if (!target) return Error{target.error()};
        options.target = *target;
    }
    if (a.duration_s > 0.0) options.duration_s = a.duration_s;
    return options;
}

}  // namespace echotrail
