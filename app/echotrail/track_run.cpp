#include "track_run.hpp"

#include "app/io/recording_path.hpp"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>

namespace echotrail {

namespace {

void note(const std::string& text) { std::fprintf(stderr, "echotrail: %s\n", text.c_str()); }

}  // namespace

TrackRun::TrackRun(const TrackOptions& options, std::unique_ptr<LogWriter> log, std::unique_ptr<TracksWriter> tracks,
                   std::unique_ptr<TargetFeed> feed)
    : options_(options),
      tracks_(std::move(tracks)),
      feed_(std::move(feed)),
      runner_(options.settings.params, options.seed, std::move(log),
              [this](const Update& update, Timestamp settled, const ScanningSonarPipeline& pipeline) {
                  hear(update, settled, pipeline);
              }),
      link_(std::make_unique<HeadLink>(options.addresses, options.settings.params.head, runner_)) {
    runner_.setFanPainting(options.paint_fan);
}

Result<void> TrackRun::serve() {
    if (!options_.serve) return {};
    service_ =
        std::make_unique<TrackerService>(options_.settings.params, runner_, *link_, "echotrail " ECHOTRAIL_VERSION,
                                         RecordingShelf(recordingsFolder(), options_.record));
    connect(service_.get(), &TrackerService::noted, this,
            [this](const QString& text) { tell(LinkLog::Weight::Note, text.toStdString()); });
    const auto address = service_->start(*options_.serve, options_.datagrams);
    if (!address) return Error{address.error()};
    note("consoles are served at " + toText(*address));
    const bool by_tls = address->kind == LinkAddress::Kind::Tls;
    const auto known = TrustStore::ofUser().list();
    const auto is_console = [](const TrustStore::Peer& peer) { return peer.role == TrustStore::Role::Console; };
    if (by_tls && std::none_of(known.begin(), known.end(), is_console))
        note("no console is paired yet, so that none may come in; run echotrail pair");
    return {};
}

void TrackRun::tell(LinkLog::Weight weight, const std::string& text) {
    const char* word = weight == LinkLog::Weight::Alarm     ? "ALARM: "
                       : weight == LinkLog::Weight::Warning ? "WARNING: "
                                                            : "";
    note(word + text);
    if (service_) service_->say(weight, text);
}

void TrackRun::start() {
    if (options_.target) runner_.designate(options_.target->range_m, options_.target->from_bow);
    connect(link_.get(), &HeadLink::noted, this,
            [this](const QString& text) { tell(LinkLog::Weight::Note, text.toStdString()); });
    connect(&health_, &QTimer::timeout, this, [this] { tellHealth(); });
    health_.start(1000);
    if (feed_) {
        connect(&reports_, &QTimer::timeout, this, [this] {
            std::optional<Timestamp> first;
            {
                const std::scoped_lock lock(mutex_);
                first = first_ping_;
            }
            if (first) feed_->send(runner_.now(), *first, runner_.status().navigation.plane);
        });
        constexpr double usual_hz = 10.0;
        const double rate_hz = options_.report->rate_hz > 0.0 ? options_.report->rate_hz : usual_hz;
        reports_.setTimerType(Qt::PreciseTimer);
        reports_.start(static_cast<int>(std::lround(1e3 / rate_hz)));
    }
    link_->open();
}

/// On the pipeline's thread.
void TrackRun::hear(const Update& update, Timestamp settled, const ScanningSonarPipeline& pipeline) {
    if (service_) service_->take(runner_.lastPing(), update, pipeline);
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
    if (!failure().empty()) QCoreApplication::quit();
    if (std::exchange(disk_told_, live.recorder.disk) != live.recorder.disk && live.recorder.disk != DiskState::Good)
        tell(live.recorder.disk == DiskState::Full ? LinkLog::Weight::Alarm : LinkLog::Weight::Warning,
             "only " + std::to_string(live.recorder.free_bytes / 1'000'000) +
                 " MB are free where the log is written; make room");
    if (!live.recorder.error.empty() && !std::exchange(log_told_, true))
        tell(LinkLog::Weight::Alarm, "recording has ended: " + live.recorder.error);
    if (options_.quiet) return;
    std::uint64_t rejected = 0;
    for (const auto& [cause, number] : live.counts.rejected) rejected += number;
    std::fprintf(
        stderr,
        "echotrail: %.0f s  %s  %llu pings/s  %llu rejected  queue %zu rows  lag %.0f ms  log %.1f MB, %.1f GB free"
        "  tracks %llu\n",
        std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count(),
        headStateText(link_->state().head.state).c_str(), static_cast<unsigned long long>(live.pings - pings_told_),
        static_cast<unsigned long long>(rejected), live.queued + live.recorder.queued, 1e3 * live.lag_s,
        static_cast<double>(live.recorder.bytes) / 1e6, static_cast<double>(live.recorder.free_bytes) / 1e9,
        static_cast<unsigned long long>(live.confirmed));
    pings_told_ = live.pings;
}

nlohmann::ordered_json TrackRun::finish(const std::string& reason) {
    health_.stop();
    reports_.stop();
    const HeadLinkState link = link_->state();
    if (service_) service_->stop();  // it works with the link
    link_.reset();
    runner_.finish();
    const LiveStatus live = runner_.status();
    const seanet::HeadStatus& head = link.head;
    const NavigationStatus& navigation = live.navigation;
    const double data_s = live.first_ping && live.last_ping ? secondsBetween(*live.first_ping, *live.last_ping) : 0.0;
    nlohmann::ordered_json summary{{"source", options_.addresses.sonarText()},
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
                                   {"connections", link.sonar.counts.times_up},
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
    if (feed_) summary["reports"] = {{"sent", feed_->counts().sent}, {"dropped", feed_->counts().dropped}};
    if (service_) {
        const TrackerService::Counts& counts = service_->counts();
        summary["consoles"] = {{"connections", counts.link.connections},
                               {"turned_away", counts.link.turned_away},
                               {"malformed", counts.link.malformed},
                               {"refused", counts.link.refused},
                               {"dropped", counts.link.dropped},
                               {"resynchronised", counts.link.resynchronised},
                               {"not_let_in", counts.turned_away},
                               {"missed_moments", counts.missed},
                               {"record_bytes", counts.link.record_bytes},
                               {"datagrams", counts.link.datagrams},
                               {"datagrams_refused", counts.datagrams_refused}};
    }
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
