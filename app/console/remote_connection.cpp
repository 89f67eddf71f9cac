#include "remote_connection.hpp"

#include "app/io/link_health.hpp"
#include "app/io/recording_path.hpp"

#include <QSysInfo>
#include <algorithm>

namespace echotrail {
namespace {

/// That the tracker says only once a second how old something is makes it no older. When it has missed its turn, nobody
/// knows whether there is anything newer.
double ageNow(double told_s, double report_age_s) {
    constexpr double its_turn_s = 2.0;
    return report_age_s > its_turn_s ? told_s + report_age_s : told_s;
}

LiveLink shown(const LinkEnd& end, double report_age_s) {
    LiveLink link{end.up, QString::fromStdString(end.reason), {}};
    if (end.age_s) link.age_s = ageNow(*end.age_s, report_age_s);
    return link;
}

RecordingCopy shown(const KeptRecording& kept) {
    return {.name = QString::fromStdString(kept.name),
            .path = QString::fromStdString(kept.path),
            .error = QString::fromStdString(kept.error),
            .rows = kept.rows.rows,
            .there = kept.rows.there,
            .missed = kept.rows.missed,
            .bytes = kept.bytes,
            .free_bytes = kept.free_bytes,
            .asking = kept.asking,
            .whole = kept.whole};
}

TrackerState trackerState(const TrackerLinkState& state) {
    const LinkClientStatus& client = state.client;
    TrackerState tracker;
    tracker.link = {state.up, QString::fromStdString(state.reason), state.age_s};
    tracker.name = QString::fromStdString(client.welcome.tracker.name);
    if (client.latency) tracker.latency_s = std::chrono::duration<double>(*client.latency).count();
    if (client.round_trip) tracker.round_trip_s = std::chrono::duration<double>(*client.round_trip).count();
    tracker.messages = client.messages;
    tracker.gaps = client.gaps;
    tracker.holds_control = client.holdsControl();
    tracker.holder = QString::fromStdString(client.control.holder_name);
    tracker.asking = QString::fromStdString(client.control.asking_name);
    tracker.asks_control = state.up && client.control.asking != 0 && client.control.asking == client.welcome.console;
    if (state.record) tracker.record = shown(*state.record);
    if (state.fetched) tracker.fetched = shown(*state.fetched);
    for (const LinkRecordingEntry& each : state.recordings)
        tracker.recordings.append({QString::fromStdString(each.name), each.bytes, each.changed, each.written});
    tracker.recordings_error = QString::fromStdString(state.recordings_error);
    return tracker;
}

}  // namespace

Result<std::unique_ptr<LiveSource>> RemoteConnection::make(const QString& address, bool record) {
    const auto parsed = parseTrackerAddress(address.toStdString());
    if (!parsed) return Error{parsed.error()};
    return std::unique_ptr<LiveSource>(std::make_unique<RemoteConnection>(*parsed, record));
}

RemoteConnection::RemoteConnection(const LinkAddress& address, bool record)
    : link_(address, {QSysInfo::machineHostName().toStdString(), "echotrail-console " ECHOTRAIL_VERSION},
            record ? recordingsFolder() : std::string()) {
    thread_.setObjectName("tracker link");
    link_.moveToThread(&thread_);
}

RemoteConnection::~RemoteConnection() {
    if (!thread_.isRunning()) return;
    QMetaObject::invokeMethod(
        &link_, [this] { link_.close(); }, Qt::BlockingQueuedConnection);
    thread_.quit();
    thread_.wait();
}

void RemoteConnection::start() {
    thread_.start();
    QMetaObject::invokeMethod(&link_, [this] { link_.open(); });
}

void RemoteConnection::setParams(const LiveRunner::Params& params) {
    QMetaObject::invokeMethod(&link_, [this, params] { link_.setParams(params); });
}

void RemoteConnection::designate(double range_m, Bearing from_bow) {
    QMetaObject::invokeMethod(&link_, [this, range_m, from_bow] { link_.designate(range_m, from_bow); });
}

void RemoteConnection::clearDesignation() {
    QMetaObject::invokeMethod(&link_, [this] { link_.clearDesignation(); });
}

void RemoteConnection::drop(int track, double range_m, Bearing from_bow) {
    QMetaObject::invokeMethod(&link_, [this, track, range_m, from_bow] { link_.drop(track, range_m, from_bow); });
}

void RemoteConnection::restore(int track) {
    QMetaObject::invokeMethod(&link_, [this, track] { link_.restore(track); });
}

void RemoteConnection::control(TrackerControl action) {
    ControlAction wanted = ControlAction::Ask;
    if (action == TrackerControl::Give) wanted = ControlAction::Give;
    if (action == TrackerControl::Keep) wanted = ControlAction::Keep;
    if (action == TrackerControl::Take) wanted = ControlAction::Take;
    QMetaObject::invokeMethod(&link_, [this, wanted] { link_.control(wanted); });
}

void RemoteConnection::listRecordings() {
    QMetaObject::invokeMethod(&link_, [this] { link_.listRecordings(); });
}

void RemoteConnection::fetchRecording(const QString& name) {
    QMetaObject::invokeMethod(&link_, [this, name] { link_.fetch(name.toStdString(), recordingsFolder()); });
}

void RemoteConnection::cancelFetch() {
    QMetaObject::invokeMethod(&link_, [this] { link_.cancelFetch(); });
}

std::optional<LiveNotice> RemoteConnection::takeNotice() {
    const auto notice = link_.takeNotice();
    if (!notice) return std::nullopt;
    return LiveNotice{QString::fromStdString(notice->text), !notice->problem};
}

LiveState RemoteConnection::state() const {
    const TrackerLinkState link = link_.state();
    const LinkHealth& health = link.health;
    const auto age_of = [&](const std::optional<Timestamp>& moment) -> std::optional<double> {
        if (!moment || !link.tracker_time) return std::nullopt;
        return std::max(0.0, secondsBetween(*moment, *link.tracker_time));
    };
    const bool told = health.time != Timestamp{};
    const double health_age_s = told ? age_of(health.time).value_or(0.0) : 0.0;
    LiveState state{.sonar = shown(health.sonar, health_age_s),
                    .head = headStatusFrom(health, link.params.head),
                    .run = liveStatusFrom(health)};
    if (health.navigation) state.navigation = shown(*health.navigation, health_age_s);
    state.ping_age_s = age_of(link.last_ping);
    if (health.heading_time)
        state.heading_age_s = ageNow(std::max(0.0, secondsBetween(*health.heading_time, health.time)), health_age_s);
    state.tracker = trackerState(link);
    state.tracker->report_age_s = health_age_s;
    return state;
}

}  // namespace echotrail
