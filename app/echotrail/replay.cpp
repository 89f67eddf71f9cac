#include "commands.hpp"
#include "core/navigation/navigation_file.hpp"
#include "core/runtime/denormals.hpp"
#include "event_loop.hpp"
#include "recorded_run.hpp"
#include "replay_options.hpp"
#include "replay_progress.hpp"
#include "tracks_writer.hpp"

#include <opencv2/core/utility.hpp>

#include <thread>

namespace echotrail {

namespace {

/// One replay: a source, the pipeline, and what is written about it.
class Replay {
public:
    Replay(const ReplayOptions& options, RecordedRunSettings settings, PingSource& source,
           const PoseHistory& navigation, TracksWriter* tracks)
        : options_(options),
          settings_(std::move(settings)),
          source_(source),
          navigation_(navigation),
          tracks_(tracks),
          pipeline_(settings_.params(), settings_.seed()),
          progress_(source.info(), options.timings) {
        pipeline_.setFanPainting(options.paint_fan);
        if (options.target) pipeline_.designate(options.target->range_m, options.target->from_bow);
    }

    Result<void> run() {
        while (const auto ping = nextPing()) {
            if (!first_) first_ = ping->time;
            last_ = ping->time;
            settings_.apply(source_.takeControls(), pipeline_);
            waitFor(ping->time);
            ++pings_;
            progress_.begin();
            const Update& update = pipeline_.process(*ping, navigation_);
            progress_.end(ping->time);
            without_pose_ += update.navigation_gap;
            if (auto written = write(update, pipeline_.settledUntil()); !written) return written;
        }
        progress_.begin();
        const Update& rest = pipeline_.finish();
        progress_.end(last_);
        return write(rest, Timestamp::max());
    }

    nlohmann::ordered_json summary(const nlohmann::ordered_json& navigation) const {
        const SourceCounts counts = source_.counts();
        nlohmann::ordered_json summary{{"source", source_.info().name},
                                       {"seed", settings_.seed()},
                                       {"overridden", settings_.overridden()},
                                       {"pings", pings_},
                                       {"rejected", nlohmann::ordered_json::object()},
                                       {"ignored", nlohmann::ordered_json::object()},
                                       {"skipped_bytes", counts.skipped_bytes},
                                       {"lost_records", counts.lost_records},
                                       {"unsynchronised_pings", pipeline_.unsynchronisedPings()},
                                       {"late_looks", tracks_ ? tracks_->lateLooks() : 0},
                                       {"navigation", navigation},
                                       {"pings_without_pose", without_pose_},
                                       {"sweeps", pipeline_.sweeps()},
                                       {"tracks", pipeline_.confirmedTracks()},
                                       {"data_seconds", first_ ? secondsBetween(*first_, last_) : 0.0},
                                       {"processing_seconds", progress_.processingSeconds()},
                                       {"exit_reason", exit_reason_}};
        for (const auto& [cause, number] : counts.rejected) summary["rejected"][cause] = number;
        for (const auto& [name, number] : counts.ignored) summary["ignored"][name] = number;
        return summary;
    }

    void tellTimings(std::ostream& out) const { progress_.tellTimings(out); }

private:
    /// The next ping, unless the run is over.
    std::optional<Ping> nextPing() {
        if (isInterrupted()) {
            exit_reason_ = "interrupted";
            return std::nullopt;
        }
        auto ping = source_.next();
        if (ping && first_ && options_.duration_s && secondsBetween(*first_, ping->time) > *options_.duration_s) {
            exit_reason_ = "duration reached";
            return std::nullopt;
        }
        return ping;
    }

    /// Sleeps until a ping's time has come, in short pieces so that an interrupt is heeded.
    void waitFor(Timestamp time) const {
        if (!options_.speed) return;
        using namespace std::chrono;
        const duration<double> due(secondsBetween(*first_, time) / *options_.speed);
        for (auto passed = steady_clock::now() - begun_; passed < due && !isInterrupted();
             passed = steady_clock::now() - begun_)
            std::this_thread::sleep_for(std::min<duration<double>>(due - passed, milliseconds(100)));
    }

    Result<void> write(const Update& update, Timestamp settled) {
        return tracks_ ? tracks_->add(update, settled) : Result<void>{};
    }

    const ReplayOptions& options_;
    RecordedRunSettings settings_;
    PingSource& source_;
    const PoseHistory& navigation_;
    TracksWriter* tracks_;
    ScanningSonarPipeline pipeline_;
    ReplayProgress progress_;
    std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
    std::optional<Timestamp> first_;
    Timestamp last_{};
    std::uint64_t pings_ = 0;
    std::uint64_t without_pose_ = 0;  ///< navigation says nothing near their time
    std::string exit_reason_ = "end of recording";
};

/// Where the poses came from, and what of them was not usable.
nlohmann::ordered_json tellNavigation(const std::optional<NavigationFile>& file, const PingSource& source) {
    if (file)
        return {{"mode", file->mode},
                {"used", file->used},
                {"unused", file->unused},
                {"rejected", file->rejected},
                {"longest_heading_gap_s", file->longest_heading_gap_s},
                {"longest_position_gap_s", file->longest_position_gap_s}};
    if (source.navigation().empty()) return {{"mode", "none: the vehicle is taken to stand still"}};
    return {{"mode", "recorded with the pings"}};
}

/// What was lost or refused, for a person; nothing where all went well.
std::string tellLosses(const nlohmann::ordered_json& summary) {
    std::vector<std::string> parts;
    const auto records = summary["lost_records"].get<std::uint64_t>();
    if (records > 0) parts.push_back("records lost: " + std::to_string(records));
    if (!summary["rejected"].empty()) parts.push_back("rejected: " + summary["rejected"].dump());
    const auto pings = summary["unsynchronised_pings"].get<std::uint64_t>();
    if (pings > 0) parts.push_back("pings without a sure bearing: " + std::to_string(pings));
    const auto& navigation = summary["navigation"];
    if (navigation.contains("rejected") && !navigation["rejected"].empty())
        parts.push_back("navigation lines rejected: " + navigation["rejected"].dump());
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "" : "; ") + part;
    return text;
}

ExitCode conclude(const nlohmann::ordered_json& summary, TracksWriter* tracks) {
    if (tracks) {
        if (const auto written = tracks->finish(summary); !written) return fail(ExitCode::Failed, written.error());
    } else {
        std::cout << nlohmann::ordered_json{{"summary", summary}}.dump(2) << std::endl;
        if (!std::cout) return fail(ExitCode::Failed, "cannot write standard output: it takes no more");
    }
    const std::string losses = tellLosses(summary);
    if (losses.empty()) return ExitCode::Done;
    return fail(ExitCode::Lossy, summary["source"].get<std::string>() + ": " + losses);
}

ExitCode replay(const ReplayArguments& arguments) {
    const auto options = checkReplayOptions(arguments);
    if (!options) return fail(ExitCode::Usage, options.error());
    const Settings& settings = options->settings;
    const auto source = openSource(options->source, {.sound_speed_mps = settings.sound_speed,
                                                     .default_sound_speed_mps = settings.params.head.sound_speed});
    if (!source) return fail(ExitCode::Failed, source.error());
    std::optional<NavigationFile> file;
    if (!options->navigation.empty()) {
        auto read = readNavigationFile(options->navigation);
        if (!read) return fail(ExitCode::Failed, read.error());
        file = *std::move(read);
    }
    const PoseHistory& navigation = file ? file->poses : (*source)->navigation();
    std::unique_ptr<TracksWriter> tracks;
    if (!options->tracks.empty()) {
        auto opened = TracksWriter::open(options->tracks);
        if (!opened) return fail(ExitCode::Failed, opened.error());
        tracks = *std::move(opened);
        tracks->setFirstPing((*source)->info().start);
    }

    cv::setNumThreads(1);  // one core is what a vehicle can spare, and results must not depend on the number
    flushDenormals();
    catchInterrupts();
    auto run_settings = RecordedRunSettings::of(
        **source, {options->parameter_files, options->assignments, options->seed, options->target.has_value()});
    if (!run_settings) return fail(ExitCode::Usage, run_settings.error());
    Replay run(*options, *std::move(run_settings), **source, navigation, tracks.get());
    if (const auto done = run.run(); !done) return fail(ExitCode::Failed, done.error());
    if (options->timings) run.tellTimings(std::cerr);
    return conclude(run.summary(tellNavigation(file, **source)), tracks.get());
}

}  // namespace

Command addReplayCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand("replay", "Run a recording through the tracker");
    auto arguments = std::make_shared<ReplayArguments>();
    addReplayOptions(*command, *arguments);
    return [arguments] { return replay(*arguments); };
}

}  // namespace echotrail
