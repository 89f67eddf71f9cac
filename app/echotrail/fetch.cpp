#include "app/io/recording_path.hpp"
#include "app/io/tracker_link.hpp"
#include "commands.hpp"
#include "event_loop.hpp"

#include <CLI/CLI.hpp>

#include <QCoreApplication>
#include <QHostAddress>
#include <QSysInfo>
#include <QTimer>
#include <cstdio>
#include <iostream>

namespace echotrail {
namespace {

struct FetchArguments {
    std::string tracker, recording, folder;
    bool follow = false;
    std::optional<double> duration_s;
};

constexpr int look_ms = 100, tell_every = 10;

std::string megabytes(std::uint64_t bytes) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f MB", static_cast<double>(bytes) / 1e6);
    return text;
}

void print(const std::vector<LinkRecordingEntry>& recordings) {
    for (const LinkRecordingEntry& each : recordings)
        std::cout << each.name << "  " << megabytes(each.bytes) << "  " << toIso8601(each.changed)
                  << (each.written ? "  being written" : "") << "\n";
    std::cout.flush();
}

/// `echotrail fetch`: what it waits for, looked at ten times a second.
class Fetch {
public:
    explicit Fetch(const FetchArguments& arguments, const LinkAddress& address)
        : arguments_(arguments),
          link_(address, {QSysInfo::machineHostName().toStdString(), "echotrail fetch " ECHOTRAIL_VERSION},
                arguments.follow ? arguments.folder : std::string(), false) {
        QObject::connect(&timer_, &QTimer::timeout, [this] { look(); });
        timer_.start(look_ms);
        link_.open();
        if (!arguments.recording.empty()) link_.fetch(arguments.recording, arguments.folder);
    }
    ExitCode run() {
        const std::string reason = runEventLoop(arguments_.duration_s);
        link_.close();
        if (ended_) return *ended_;
        const auto kept = keptNow();
        if (arguments_.follow && kept && kept->error.empty()) return end(*kept);
        return fail(ExitCode::Failed, kept && !kept->error.empty()   ? kept->error
                                      : link_.state().reason.empty() ? reason
                                                                     : link_.state().reason);
    }

private:
    std::optional<KeptRecording> keptNow() const {
        const TrackerLinkState state = link_.state();
        return arguments_.follow ? state.record : state.fetched;
    }
    void look() {
        const TrackerLinkState state = link_.state();
        if (state.up && arguments_.recording.empty() && !arguments_.follow) return look(state);
        const auto kept = keptNow();
        if (!kept) return;
        if (kept->rows.there > 0 && ++looks_ % tell_every == 0)
            std::fprintf(stderr, "echotrail: %lld of %lld rows%s\n", static_cast<long long>(kept->rows.rows),
                         static_cast<long long>(kept->rows.there), state.up ? "" : "; no link, trying again");
        if (!kept->error.empty()) return quit(fail(ExitCode::Failed, kept->error));
        if (!arguments_.follow && kept->whole && !kept->asking) quit(end(*kept));
    }
    void look(const TrackerLinkState& state) {
        if (!state.recordings_error.empty()) return quit(fail(ExitCode::Failed, state.recordings_error));
        if (!listing_) link_.listRecordings();
        listing_ = true;
        if (state.recordings.empty()) return;
        print(state.recordings);
        quit(ExitCode::Done);
    }
    static ExitCode end(const KeptRecording& kept) {
        std::cout << kept.path << std::endl;
        if (kept.whole) return ExitCode::Done;
        return fail(ExitCode::Lossy, std::to_string(kept.rows.there - kept.rows.rows) +
                                         " rows are missing; the same command fetches them");
    }
    void quit(ExitCode code) {
        ended_ = code;
        QCoreApplication::quit();
    }

    FetchArguments arguments_;
    TrackerLink link_;
    QTimer timer_;
    std::optional<ExitCode> ended_;
    bool listing_ = false;
    int looks_ = 0;
};

ExitCode fetch(FetchArguments arguments) {
    const auto address = parseTrackerAddress(arguments.tracker);
    if (!address) return fail(ExitCode::Usage, address.error());
    int argc = 1;
    char program[] = "echotrail";
    char* argv[] = {program, nullptr};
    const QCoreApplication application(argc, argv);
    if (arguments.folder.empty()) arguments.folder = recordingsFolder();
    return Fetch(arguments, *address).run();
}

}  // namespace

Command addFetchCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand(
        "fetch",
        "Fetch a recording from a tracker. Without a name: list those that lie there. What was fetched before "
        "is gone on with; tracks and picture of other consoles are not delayed");
    auto arguments = std::make_shared<FetchArguments>();
    command->add_option("TRACKER", arguments->tracker, "tls://HOST:PORT, or tcp://127.0.0.1:PORT on this machine")
        ->required();
    auto* recording = command->add_option("RECORDING", arguments->recording, "A name of the list");
    command
        ->add_flag("--follow", arguments->follow,
                   "Keep a copy of the run that is recorded there now, as a console does, until Ctrl-C")
        ->excludes(recording);
    command->add_option("--folder", arguments->folder,
                        "Where the copy is made, named by tracker and time (default: "
                        "$XDG_DATA_HOME/echotrail/recordings)");
    command->add_option("--duration", arguments->duration_s, "End after so many seconds")
        ->check(CLI::NonNegativeNumber);
    return [arguments] { return fetch(*arguments); };
}

}  // namespace echotrail
