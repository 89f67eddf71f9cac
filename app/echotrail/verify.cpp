#include "commands.hpp"
#include "core/recording/echotrail_log.hpp"
#include "core/recording/update_text.hpp"
#include "core/runtime/denormals.hpp"
#include "recorded_run.hpp"

#include <CLI/CLI.hpp>
#include <opencv2/core/utility.hpp>

#include <iostream>

namespace echotrail {

namespace {

/// As logs have it that were written before looks said why they used no echo.
std::string textWithoutCause(TrackLook look) {
    look.no_echo = NoEcho::None;
    return lookText(look);
}

/// Compares what a run says with what the log kept of it, look by look.
class Comparison {
public:
    explicit Comparison(LogReader& recorded) : recorded_(recorded) { recorded_.rewindResults(); }

    /// False at the first difference.
    bool take(const Update& update) {
        for (const TrackLook& look : update.looks) {
            const std::string text = lookText(look);
            const auto expected = nextTrack();
            if (expected && (*expected == text || *expected == textWithoutCause(look))) {
                ++compared_;
                continue;
            }
            difference_ = "track update " + std::to_string(compared_ + 1) + " of " + toIso8601(look.time) +
                          "\n  recorded: " + expected.value_or("nothing") + "\n  now:      " + text;
            return false;
        }
        return true;
    }
    /// Nothing more may be recorded than was found again, unless the run was cut off.
    bool finish() {
        if (const auto more = nextTrack()) {
            difference_ =
                "after " + std::to_string(compared_) + " track updates\n  recorded: " + *more + "\n  now:      nothing";
            return false;
        }
        return true;
    }
    bool recordedEnded() const { return ended_; }
    std::uint64_t compared() const { return compared_; }
    const std::string& difference() const { return difference_; }

private:
    std::optional<std::string> nextTrack() {
        while (auto result = recorded_.nextResult())
            if (result->kind == UpdateKind::Track) return std::move(result->text);
        ended_ = true;
        return std::nullopt;
    }

    LogReader& recorded_;
    std::uint64_t compared_ = 0;
    std::string difference_;
    bool ended_ = false;
};

ExitCode verify(const std::string& path) {
    const auto log = EchotrailLog::open(path, {.without_pings = true});
    if (!log) return fail(ExitCode::Failed, log.error());
    auto settings = RecordedRunSettings::of(**log, {});
    if (!settings) return fail(ExitCode::Failed, settings.error());
    const auto results = LogReader::open(path);
    if (!results) return fail(ExitCode::Failed, results.error());

    cv::setNumThreads(1);
    flushDenormals();
    ScanningSonarPipeline pipeline(settings->params(), settings->seed());
    pipeline.setFanPainting(false);  // the picture is recomputed from the same pings, and not recorded
    Comparison comparison(**results);
    std::uint64_t pings = 0;
    bool same = true;
    while (same) {
        const auto ping = (*log)->next();
        if (!ping) break;
        ++pings;
        settings->apply((*log)->takeControls(), pipeline);
        same = comparison.take(pipeline.process(*ping, (*log)->navigation()));
    }
    // A run that was cut off has not said all that its last events would have brought.
    const bool cut_off = !(*results)->closed() || (*results)->summary().empty();
    if (same) same = comparison.take(pipeline.finish()) && comparison.finish();
    if (!same && cut_off && comparison.recordedEnded()) same = true;
    if (comparison.compared() == 0 && (*results)->closed() && (*results)->summary().empty()) {
        // An imported recording, or a simulated one: no tracker ran when it was made.
        std::cout << "nothing to compare: no tracker ran when this was recorded" << std::endl;
        return ExitCode::Lossy;
    }
    if (!same) {
        std::cout << "different: " << comparison.difference() << std::endl;
        return ExitCode::Lossy;
    }
    std::cout << "identical: " << comparison.compared() << " track updates from " << pings << " pings"
              << (cut_off ? ", as far as the run that was cut off had recorded them" : "") << std::endl;
    if ((*log)->reader().counts().any())
        return fail(ExitCode::Lossy, path + ": parts of the log are missing or damaged; see echotrail info");
    return ExitCode::Done;
}

}  // namespace

Command addVerifyCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand(
        "verify", "Run a recording again and compare its tracks bit for bit with those recorded");
    auto path = std::make_shared<std::string>();
    command->add_option("LOG", *path, "Recording of our own (.echotrail)")->required();
    return [path] { return verify(*path); };
}

}  // namespace echotrail
