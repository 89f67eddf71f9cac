#include "commands.hpp"
#include "core/base/angles.hpp"
#include "core/pipelines/sweep_follower.hpp"
#include "core/recording/log_reader.hpp"
#include "sources.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <optional>
#include <set>

namespace echotrail {

namespace {

using Json = nlohmann::ordered_json;

/// From the least to the greatest value met.
struct Span {
    double least = HUGE_VAL, most = -HUGE_VAL;
    void add(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
    Json json() const { return least > most ? Json(nullptr) : Json{least, most}; }
};

/// A text in a record that may hold anything.
std::string textIn(const Json& record, const char* name, const char* otherwise) {
    const auto found = record.find(name);
    return found != record.end() && found->is_string() ? found->get<std::string>() : otherwise;
}

/// What the tracker's results in a log of our own tell of looks: how many, and why some used no echo. Nothing where
/// there are none. Looks of tracks that were never confirmed do not count.
Json describeLooks(LogReader& log) {
    std::uint64_t looks = 0;
    std::map<std::string, std::uint64_t> causes;
    while (const auto result = log.nextResult()) {
        if (result->kind != UpdateKind::Track) continue;
        const Json look = Json::parse(result->text, nullptr, false);
        if (!look.is_object() || textIn(look, "state", "tentative") == "tentative") continue;
        ++looks;
        const auto seen = look.find("seen");
        if (seen != look.end() && *seen == false) ++causes[textIn(look, "cause", "not told")];
    }
    if (looks == 0) return nullptr;
    return {{"looks", looks}, {"without_echo", causes}};
}

/// Into what is known of a log of our own: what its results tell, and which of their rows are lost.
void addResults(const std::string& path, Json& all) {
    const auto log = LogReader::open(path);
    if (!log) return;
    all["tracks"] = describeLooks(**log);
    const LogCounts& counts = (*log)->counts();
    const auto lose = [&](const char* cause, std::uint64_t number) {
        if (number == 0) return;
        all["rejected"][cause] = number;
        all["lost_records"] = all["lost_records"].get<std::uint64_t>() + number;
    };
    lose("damaged_result_row", counts.damaged_rows);
    lose("unreadable_results", counts.unreadable.empty() ? 0 : 1);
}

double rounded(double value) { return std::round(value * 1e6) / 1e6; }

/// What is in a source. The unit of every number is the end of its name.
Json describe(PingSource& source) {
    SweepFollower follower;
    std::uint64_t pings = 0, sweeps = 0;
    Span range, bearing, step, bins, bin_size, gain, frequency;
    while (const auto ping = source.next()) {
        ++pings;
        sweeps += follower.follow(ping->bearing, ping->step_rad, ping->time).sweep_ended;
        range.add(rounded(ping->range_scale_m));
        bearing.add(rounded(ping->bearing.inDegrees()));
        step.add(rounded(degreesFromRadians(ping->step_rad)));
        bins.add(static_cast<double>(ping->levels.size()));
        bin_size.add(rounded(ping->binSize()));
        gain.add(rounded(ping->gain_percent));
        frequency.add(rounded(ping->frequency_hz / 1e3));
    }
    const SourceInfo& info = source.info();
    const SourceCounts counts = source.counts();
    return {{"name", info.name},
            {"format", info.format},
            {"head", info.head},
            {"start", toIso8601(info.start)},
            {"end", toIso8601(info.end)},
            {"duration_s", secondsBetween(info.start, info.end)},
            {"pings", pings},
            {"sweeps", sweeps},
            {"range_scale_m", range.json()},
            {"bearing_deg", bearing.json()},
            {"step_deg", step.json()},
            {"bins_per_ping", bins.json()},
            {"bin_size_m", bin_size.json()},
            {"frequency_khz", frequency.json()},
            {"gain_percent", gain.json()},
            {"sound_speed_mps", info.sound_speed_mps},
            {"navigation", !source.navigation().empty()},
            {"rejected", counts.rejected},
            {"ignored", counts.ignored},
            {"skipped_bytes", counts.skipped_bytes},
            {"lost_records", counts.lost_records},
            {"notes", info.notes}};
}

std::string plain(const Json& number) { return number.is_string() ? number.get<std::string>() : number.dump(); }

/// "10 m", or "0 to 50 m" where it changed on the way.
std::string spanText(const Json& span, const char* unit) {
    if (span.is_null()) return "-";
    const double least = span[0], most = span[1];
    std::ostringstream text;
    text << least;
    if (most != least) text << " to " << most;
    text << unit;
    return text.str();
}

std::string causesText(const Json& causes) {
    std::string text;
    for (const auto& [cause, number] : causes.items()) text += (text.empty() ? "" : ", ") + number.dump() + " " + cause;
    return text.empty() ? "none" : text;
}

void print(const Json& all, std::ostream& out) {
    const auto line = [&](const char* name, const std::string& value) {
        out << name << std::string(18 - std::string_view(name).size(), ' ') << value << "\n";
    };
    line("recording", plain(all["name"]));
    line("format", plain(all["format"]));
    line("head", plain(all["head"]));
    line("start", plain(all["start"]) + " (UTC)");
    line("end", plain(all["end"]) + " (UTC)");
    line("duration", plain(all["duration_s"]) + " s");
    line("pings", plain(all["pings"]));
    line("sweeps", plain(all["sweeps"]) + " finished");
    line("range scale", spanText(all["range_scale_m"], " m"));
    line("bearings", spanText(all["bearing_deg"], " deg from the head's zero"));
    line("step", spanText(all["step_deg"], " deg"));
    line("bins", all["pings"] == 0
                     ? "-"
                     : spanText(all["bins_per_ping"], " per ping") + " of " + spanText(all["bin_size_m"], " m"));
    line("frequency", spanText(all["frequency_khz"], " kHz"));
    line("gain", spanText(all["gain_percent"], " %"));
    line("speed of sound", plain(all["sound_speed_mps"]) + " m/s");
    line("navigation", all["navigation"].get<bool>() ? "yes" : "none");
    line("rejected", causesText(all["rejected"]));
    line("other messages", causesText(all["ignored"]));
    line("skipped", plain(all["skipped_bytes"]) + " bytes");
    line("lost", plain(all["lost_records"]) + " records");
    if (!all["tracks"].is_null()) {
        line("looks", plain(all["tracks"]["looks"]));
        line("without an echo", causesText(all["tracks"]["without_echo"]));
    }
    for (const Json& note : all["notes"]) line("note", plain(note));
}

struct InfoArguments {
    std::string source;
    bool json = false;
};

ExitCode info(const InfoArguments& arguments) {
    const auto address = parseSourceAddress(arguments.source);
    if (!address) return fail(ExitCode::Usage, address.error());
    const auto source = openSource(*address, {.without_pings = true});
    if (!source) return fail(ExitCode::Failed, source.error());
    Json all = describe(**source);
    all["tracks"] = nullptr;
    if (!address->path.empty()) addResults(address->path, all);
    if (arguments.json)
        std::cout << all.dump(2) << "\n";
    else
        print(all, std::cout);
    std::cout.flush();
    if (!std::cout) return fail(ExitCode::Failed, "cannot write standard output: it takes no more");
    const auto lost = all["lost_records"].get<std::uint64_t>();
    if (lost == 0) return ExitCode::Done;
    return fail(ExitCode::Lossy, std::to_string(lost) + " records of " + plain(all["name"]) +
                                     " were lost: " + causesText(all["rejected"]));
}

}  // namespace

Command addInfoCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand("info", "Say what is in a recording");
    auto arguments = std::make_shared<InfoArguments>();
    command->add_option("SOURCE", arguments->source, "Recording (.V4LOG or raw .bin), or simulation://NAME?seed=N")
        ->required();
    command->add_flag("--json", arguments->json, "As JSON; the unit of a number is the end of its name");
    return [arguments] { return info(*arguments); };
}

}  // namespace echotrail
