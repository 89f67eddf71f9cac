#include "track_run.hpp"

#include <cstdio>
#include <iostream>

namespace echotrail {

namespace {

using seanet::HeadState;

const char* nameOf(HeadState state) {
    switch (state) {
        case HeadState::NoLink:
            return "no link";
        case HeadState::Waiting:
            return "waiting for the head";
        case HeadState::Identifying:
            return "asking what it is";
        case HeadState::Centring:
            return "centring";
        case HeadState::Configuring:
            return "sending parameters";
        case HeadState::Polling:
            return "scanning";
        case HeadState::Silent:
            return "head silent";
        case HeadState::WrongDevice:
            return "wrong device";
    }
    return "";
}

std::vector<std::uint8_t> bytesOf(const QByteArray& bytes) { return {bytes.begin(), bytes.end()}; }
std::vector<std::uint8_t> textBytes(std::string_view text) { return {text.begin(), text.end()}; }

std::uint32_t timeOfDayMs() {
    using namespace std::chrono;
    const auto now = system_clock::now();
    return static_cast<std::uint32_t>(duration_cast<milliseconds>(now - floor<days>(now)).count());
}

}  // namespace

TrackRun::TrackRun(const TrackOptions& options, std::unique_ptr<LogWriter> log, std::unique_ptr<TracksWriter> tracks)
    : options_(options),
      tracks_(std::move(tracks)),
      feed_(options.report ? std::make_unique<TargetFeed>(*options.report) : nullptr),
      sonar_(makeChannel(options.sonar)),
      navigation_(options.navigation ? makeChannel(*options.navigation) : nullptr),
      session_(options.settings.params.head),
      runner_(options.settings.params, options.seed, std::move(log),
              [this](const Update& update, Timestamp settled, const ScanningSonarPipeline& pipeline) {
                  hear(update, settled, pipeline);
              }) {
    runner_.setFanPainting(options.paint_fan);
    failed_.setSingleShot(true);
}

void TrackRun::start() {
    connectSonar();
    if (navigation_) connectNavigation();
    if (options_.target) runner_.designate(options_.target->range_m, options_.target->from_bow);
    deadline_.setSingleShot(true);
    deadline_.setTimerType(Qt::PreciseTimer);
    connect(&deadline_, &QTimer::timeout, this, [this] {
        session_.tick(now());
        converse();
    });
    connect(&health_, &QTimer::timeout, this, [this] { tellHealth(); });
    health_.start(1000);
    if (feed_) {
        connect(&reports_, &QTimer::timeout, this, [this] {
            std::optional<Timestamp> first;
            {
                const std::scoped_lock lock(mutex_);
                first = first_ping_;
            }
            if (first) feed_->send(runner_.now(), *first);
        });
        reports_.start(100);
    }
    sonar_->open();
    if (navigation_) navigation_->open();
}

void TrackRun::connectSonar() {
    connect(sonar_.get(), &ByteChannel::wentUp, this, [this] {
        note("sonar " + toText(options_.sonar) + ": connected");
        runner_.post(EventKind::SonarLink, textBytes("up"));
        session_.linkUp(now(), timeOfDayMs());
        converse();
    });
    connect(sonar_.get(), &ByteChannel::wentDown, this, [this](const QString& reason) {
        note("sonar: " + reason.toStdString());
        runner_.post(EventKind::SonarLink, textBytes("down"));
        session_.linkDown(now());
        converse();
    });
    connect(sonar_.get(), &ByteChannel::received, this, [this](const QByteArray& bytes) {
        auto payload = bytesOf(bytes);
        runner_.post(EventKind::SonarBytes, payload);
        session_.received(now(), payload);
        converse();
    });
}

void TrackRun::connectNavigation() {
    // Said first of all, so that pings wait for poses from the first one on.
    runner_.post(EventKind::NavigationLink, textBytes("down"));
    connect(navigation_.get(), &ByteChannel::wentUp, this, [this] {
        note("navigation " + toText(*options_.navigation) + ": connected");
        runner_.post(EventKind::NavigationLink, textBytes("up"));
    });
    connect(navigation_.get(), &ByteChannel::wentDown, this, [this](const QString& reason) {
        note("navigation: " + reason.toStdString());
        runner_.post(EventKind::NavigationLink, textBytes("down"));
    });
    connect(navigation_.get(), &ByteChannel::received, this,
            [this](const QByteArray& bytes) { runner_.post(EventKind::NavigationBytes, bytesOf(bytes)); });
}

/// Sends what the session wants to say, and comes back when it wants to be called.
void TrackRun::converse() {
    while (const auto frame = session_.takeOutput()) {
        runner_.post(EventKind::SentBytes, *frame);
        sonar_->send(QByteArray(reinterpret_cast<const char*>(frame->data()), static_cast<int>(frame->size())));
    }
    if (const auto at = session_.deadline())
        deadline_.start(
            std::max(std::chrono::ceil<std::chrono::milliseconds>(*at - now()), std::chrono::milliseconds(0)));
    else
        deadline_.stop();
    const seanet::HeadStatus& status = session_.status();
    if (std::exchange(last_state_, status.state) != status.state)
        note(std::string("head: ") + nameOf(status.state) + (status.head.empty() ? "" : " (" + status.head + ")"));
    if (last_difference_ != status.difference && !status.difference.empty())
        note("head: not as commanded: " + status.difference);
    last_difference_ = status.difference;
    if (last_advice_ != status.advice && !status.advice.empty()) note("head: " + status.advice);
    last_advice_ = status.advice;
}

/// On the pipeline's thread.
void TrackRun::hear(const Update& update, Timestamp settled, const ScanningSonarPipeline& pipeline) {
    const std::scoped_lock lock(mutex_);
    if (!first_ping_) {
        first_ping_ = update.time;
        if (tracks_) tracks_->setFirstPing(update.time);
    }
    if (feed_) feed_->take(update, pipeline);
    if (!tracks_ || !failure_.empty()) return;
    if (const auto written = tracks_->add(update, settled); !written) failure_ = written.error();
}

std::string TrackRun::failure() const {
    const std::scoped_lock lock(mutex_);
    return failure_;
}

void TrackRun::tellHealth() {
    const LiveStatus live = runner_.status();
    if (!failure().empty()) failed_.start(0);
    if (live.recorder.disk != DiskState::Good && !std::exchange(disk_told_, true))
        note("WARNING: only " + std::to_string(live.recorder.free_bytes / 1'000'000) +
             " MB are free where the log is written; make room");
    if (!live.recorder.error.empty() && !std::exchange(log_told_, true))
        note("ALARM: recording has ended: " + live.recorder.error);
    if (options_.quiet) return;
    std::uint64_t rejected = 0;
    for (const auto& [cause, number] : live.counts.rejected) rejected += number;
    std::fprintf(stderr,
                 "echotrail: %.0f s  %s  %llu pings/s  %llu rejected  queue %zu  lag %.0f ms  log %.1f MB, %.1f GB free"
                 "  tracks %llu\n",
                 std::chrono::duration<double>(now()).count(), nameOf(session_.status().state),
                 static_cast<unsigned long long>(live.pings - pings_told_), static_cast<unsigned long long>(rejected),
                 live.queued + live.recorder.queued, 1e3 * live.lag_s, static_cast<double>(live.recorder.bytes) / 1e6,
                 static_cast<double>(live.recorder.free_bytes) / 1e9, static_cast<unsigned long long>(live.confirmed));
    pings_told_ = live.pings;
}

void TrackRun::note(const std::string& text) const { std::fprintf(stderr, "echotrail: %s\n", text.c_str()); }

Microseconds TrackRun::now() const {
    return std::chrono::duration_cast<Microseconds>(std::chrono::steady_clock::now() - started_);
}

nlohmann::ordered_json TrackRun::finish(const std::string& reason) {
    for (QTimer* timer : {&deadline_, &health_, &reports_}) timer->stop();
    sonar_->disconnect(this);
    sonar_->close();
    if (navigation_) {
        navigation_->disconnect(this);
        navigation_->close();
    }
    runner_.finish();
    const LiveStatus live = runner_.status();
    const seanet::HeadStatus& head = session_.status();
    const NavigationStatus& navigation = live.navigation;
    const double data_s = live.first_ping && live.last_ping ? secondsBetween(*live.first_ping, *live.last_ping) : 0.0;
    nlohmann::ordered_json summary{{"source", toText(options_.sonar)},
                                   {"head", head.head},
                                   {"seed", options_.seed},
                                   {"pings", live.pings},
                                   {"rejected", live.counts.rejected},
                                   {"ignored", live.counts.ignored},
                                   {"skipped_bytes", live.counts.skipped_bytes},
                                   {"lost_records", live.counts.lost_records},
                                   {"skipped_pings", live.skipped},
                                   {"unsynchronised_pings", live.unsynchronised},
                                   {"late_looks", tracks_ ? tracks_->lateLooks() : 0},
                                   {"connections", sonar_->counts().times_up},
                                   {"timeouts", head.timeouts},
                                   {"retries", head.retries},
                                   {"head_resets", head.head_resets},
                                   {"navigation",
                                    {{"heading", navigation.heading_kind.empty() ? "none" : navigation.heading_kind},
                                     {"position", navigation.position_kind.empty() ? "none" : navigation.position_kind},
                                     {"used", navigation.used},
                                     {"unused", navigation.unused},
                                     {"rejected", navigation.rejected}}},
                                   {"pings_without_pose", live.without_pose},
                                   {"sweeps", live.sweeps},
                                   {"tracks", live.confirmed},
                                   {"data_seconds", data_s},
                                   {"processing_seconds", live.processing_s},
                                   {"log", live.recorder.path},
                                   {"exit_reason", reason}};
    if (feed_) summary["reports"] = {{"sent", feed_->sent()}, {"dropped_bytes", feed_->counts().dropped_bytes}};
    runner_.record({UpdateKind::Summary, runner_.now(), summary.dump()});
    runner_.closeLog();
    return summary;
}

std::string TrackRun::losses() const {
    const LiveStatus live = runner_.status();
    std::string text;
    const auto tell = [&](const std::string& what, std::uint64_t number) {
        if (number > 0) text += (text.empty() ? "" : "; ") + what + ": " + std::to_string(number);
    };
    tell("pings lost on the way", live.counts.lost_records);
    for (const auto& [cause, number] : live.counts.rejected) tell("rejected for " + cause, number);
    tell("pings the tracker could not take in time", live.skipped);
    tell("pings without a sure bearing", live.unsynchronised);
    tell("events that are not in the log", live.recorder.unsaved);
    return text;
}

}  // namespace echotrail
