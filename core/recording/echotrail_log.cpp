#include "core/recording/echotrail_log.hpp"

#include "core/data/head_settings.hpp"
#include "core/recording/file_reader.hpp"

#include <nlohmann/json.hpp>

namespace echotrail {
namespace {

/// The one parameter of the pipeline that decides when a ping is given.
double longestGapIn(const std::string& parameters) {
    constexpr double otherwise_s = 1.0;
    const auto assignments = readParameterText(parameters, "recorded parameters");
    if (!assignments) return otherwise_s;
    for (const ParameterAssignment& assignment : *assignments)
        if (const auto* gap = std::get_if<double>(&assignment.value);
            gap && assignment.name == "longest_navigation_gap_s")
            return *gap;
    return otherwise_s;
}

std::uint64_t pingsIn(const std::string& summary) {
    const auto object = nlohmann::json::parse(summary, nullptr, false);
    if (!object.is_object() || !object.contains("pings") || !object["pings"].is_number_unsigned()) return 0;
    return object["pings"];
}

}  // namespace

Result<std::unique_ptr<EchotrailLog>> EchotrailLog::open(const std::string& path, const RecordingOptions& options) {
    auto reader = LogReader::open(path);
    if (!reader) return Error{reader.error()};
    std::unique_ptr<EchotrailLog> log(new EchotrailLog(*std::move(reader), options));
    log->describe(path);
    log->rewind();
    const auto first = log->next();
    if (!first && !options.without_pings) return Error{"cannot open " + path + ": no sonar ping was recorded in it"};
    if (!first) log->info_.notes.push_back("no sonar ping was recorded: the run ended before the head gave one");
    log->info_.start = first ? first->time : log->reader_->header().started;
    log->info_.range_scale_m = first ? first->range_scale_m : 0.0;
    log->info_.end = std::max(log->reader_->end().value_or(log->info_.start), log->info_.start);
    log->rewind();
    return log;
}

EchotrailLog::EchotrailLog(std::unique_ptr<LogReader> reader, const RecordingOptions& options)
    : reader_(std::move(reader)), options_(options) {
    if (auto skips = reader_->skips())
        skips_ = *std::move(skips);
    else
        info_.notes.push_back("which pings the tracker skipped cannot be read: " + skips.error());
}

void EchotrailLog::describe(const std::string& path) {
    const LogHeader& header = reader_->header();
    info_.name = fileName(path);
    info_.format = "Echotrail log";
    info_.head = header.head;
    info_.pings = pingsIn(reader_->summary());
    HeadSettings head;
    if (const auto passed_over = applyRecordedParameters(head, header.configuration); !passed_over)
        info_.notes.push_back("the recorded parameters cannot be read: defaults");
    info_.sound_speed_mps = options_.sound_speed_mps.value_or(head.sound_speed);
    info_.notes.push_back("recorded by Echotrail " + header.program_version + ", seed " + std::to_string(header.seed));
    if (reader_->parts() > 1) info_.notes.push_back("in " + std::to_string(reader_->parts()) + " parts");
    if (!reader_->closed())
        info_.notes.push_back("the run that wrote it did not close it: up to a second may be missing at its end");
}

void EchotrailLog::rewind() {
    reader_->rewind();
    feed_.emplace(info_.sound_speed_mps, longestGapIn(reader_->header().configuration), skips_);
    finished_ = false;
}

std::optional<Ping> EchotrailLog::next() {
    while (true) {
        if (auto ping = feed_->next()) return ping;
        if (finished_) return std::nullopt;
        if (const auto event = reader_->next()) {
            feed_->take(*event);
            if (options_.sound_speed_mps) feed_->setSoundSpeed(*options_.sound_speed_mps);
        } else {
            finished_ = true;
            feed_->finish();
        }
    }
}

std::vector<RunControl> EchotrailLog::takeControls() {
    auto controls = feed_->takeControls();
    for (const RunControl& control : controls)
        if (control.kind == RunControl::Kind::Parameters) feed_->setLongestGap(longestGapIn(control.parameters));
    return controls;
}

SourceCounts EchotrailLog::counts() const {
    SourceCounts counts = feed_->counts();
    const LogCounts& log = reader_->counts();
    const auto lose = [&](const char* cause, std::uint64_t number) {
        if (number == 0) return;
        counts.rejected[cause] += number;
        counts.lost_records += number;
    };
    lose("damaged_row", log.damaged_rows);
    lose("missing_event", log.missing_events);
    lose("missing_part", log.missing_parts);
    lose("unreadable_log", log.unreadable.empty() ? 0 : 1);
    return counts;
}

std::optional<RecordedRun> EchotrailLog::recordedRun() const {
    return RecordedRun{reader_->header().seed, reader_->header().configuration};
}

}  // namespace echotrail
