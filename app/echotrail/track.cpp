#include "commands.hpp"
#include "core/recording/log_writer.hpp"
#include "event_loop.hpp"
#include "track_options.hpp"
#include "track_run.hpp"

#include <opencv2/core/utility.hpp>

#include <QCoreApplication>
#include <iostream>

namespace echotrail {

namespace {

ExitCode track(const TrackArguments& arguments) {
    const auto options = checkTrackOptions(arguments);
    if (!options) return fail(ExitCode::Usage, options.error());
    int argc = 1;
    char name[] = "echotrail";
    char* argv[] = {name, nullptr};
    const QCoreApplication application(argc, argv);
    cv::setNumThreads(1);

    std::unique_ptr<TracksWriter> tracks;
    if (!options->tracks.empty()) {
        auto opened = TracksWriter::open(options->tracks);
        if (!opened) return fail(ExitCode::Failed, opened.error());
        tracks = *std::move(opened);
    }
    std::unique_ptr<TargetFeed> feed;
    if (options->report) {
        auto opened = TargetFeed::open(*options->report);
        if (!opened) return fail(ExitCode::Usage, "--report: " + opened.error());
        feed = *std::move(opened);
    }
    std::unique_ptr<LogWriter> log;
    if (!options->record.empty()) {
        const LogHeader header{ECHOTRAIL_VERSION, options->addresses.sonarText(), parameterText(options->settings.params),
                               options->seed,
                               std::chrono::time_point_cast<Microseconds>(std::chrono::system_clock::now())};
        auto created = LogWriter::create(options->record, header);
        if (!created) return fail(ExitCode::Failed, created.error());
        log = *std::move(created);
        std::cerr << "echotrail: recording to " << options->record << std::endl;
    }

    TrackRun run(*options, std::move(log), std::move(tracks), std::move(feed));
    if (const auto served = run.serve(); !served) return fail(ExitCode::Failed, served.error());
    run.start();
    const std::string reason = runEventLoop(options->duration_s);
    const auto summary = run.finish(reason.empty() ? "the tracks cannot be written" : reason);
    if (!run.failure().empty()) return fail(ExitCode::Failed, run.failure());
    if (run.tracks()) {
        if (const auto written = run.tracks()->finish(summary); !written)
            return fail(ExitCode::Failed, written.error());
    } else {
        std::cout << nlohmann::ordered_json{{"summary", summary}}.dump(2) << std::endl;
    }
    const std::string losses = run.losses();
    return losses.empty() ? ExitCode::Done : fail(ExitCode::Lossy, losses);
}

}  // namespace

Command addTrackCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand("track", "Poll a head, record everything, follow the target");
    auto arguments = std::make_shared<TrackArguments>();
    addTrackOptions(*command, *arguments);
    return [arguments] { return track(*arguments); };
}

}  // namespace echotrail
