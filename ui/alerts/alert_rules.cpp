#include "ui/alerts/alert_rules.hpp"

#include "ui/views/track_painter.hpp"

#include <algorithm>

namespace echotrail {
namespace {

QString text(const std::string& plain) { return QString::fromStdString(plain); }

/// What a far tracker said last, some time ago, says nothing about now.
bool isTold(const LiveState& state) {
    return !state.tracker || (state.tracker->link.up && state.tracker->report_age_s <= AlertRules::stale_link_s);
}

}  // namespace

QString priorityWord(AlertPriority priority) {
    switch (priority) {
        case AlertPriority::Emergency:
            return AlertRules::tr("emergency");
        case AlertPriority::Alarm:
            return AlertRules::tr("alarm");
        case AlertPriority::Warning:
            return AlertRules::tr("warning");
        case AlertPriority::Caution:
            break;
    }
    return AlertRules::tr("caution");
}

std::optional<double> minutesLeft(const LiveStatus& run) {
    if (!run.first_ping || !run.last_ping) return std::nullopt;
    const double lasted_s = secondsBetween(*run.first_ping, *run.last_ping);
    if (lasted_s < AlertRules::least_rate_time_s || run.recorder.bytes == 0) return std::nullopt;
    return static_cast<double>(run.recorder.free_bytes) / static_cast<double>(run.recorder.bytes) * lasted_s / 60.0;
}

std::vector<Situation> AlertRules::ofLive(const LiveState& state, double longest_heading_gap_s) {
    std::vector<Situation> situations;
    addLinks(state, situations);
    if (!isTold(state)) return situations;
    addHeading(state, longest_heading_gap_s, situations);
    addRecording(state.run, situations);
    if (state.tracker && state.tracker->record && !state.tracker->record->error.isEmpty())
        situations.push_back(
            {"copy", AlertPriority::Caution, tr("The run is not copied here"), state.tracker->record->error});
    return situations;
}

void AlertRules::addLinks(const LiveState& state, std::vector<Situation>& situations) {
    const auto judge = [&](const LiveLink& link, const QString& key, const QString& broken, const QString& quiet) {
        const bool stale = link.age_s.value_or(0.0) > stale_link_s;
        if (link.up && !stale) return true;
        const QString age = link.age_s ? tr("last heard %1 ago").arg(Formatter::age(*link.age_s)) : tr("never heard");
        situations.push_back({key, AlertPriority::Warning, link.up ? quiet : broken,
                              link.reason.isEmpty() ? age : link.reason + " · " + age, link_delay_s});
        return false;
    };
    if (state.tracker) {
        LiveLink link = state.tracker->link;
        if (link.age_s) link.age_s = std::max(*link.age_s, state.tracker->report_age_s);
        if (!judge(link, "tracker_link", tr("Link to the tracker lost"), tr("Tracker is quiet")))
            return;  // the head's link is known through it only
    }
    if (!judge(state.sonar, "sonar_link", tr("Link to the sonar lost"), tr("Sonar is quiet"))) return;
    if (!state.head.advice.empty())
        situations.push_back(
            {"head", AlertPriority::Warning, tr("The sonar head needs a look"), text(state.head.advice), link_delay_s});
}

void AlertRules::addHeading(const LiveState& state, double longest_gap_s, std::vector<Situation>& situations) {
    if (!state.navigation && !state.run.navigation_expected) return;  // nobody asked for one
    if (state.heading_age_s && *state.heading_age_s <= longest_gap_s) return;
    const QString reason = state.navigation ? state.navigation->reason : QString();
    const QString so = tr("tracks coast until it is back");
    situations.push_back(
        {"heading", AlertPriority::Warning,
         state.heading_age_s ? tr("Heading old, limit %1").arg(Formatter::age(longest_gap_s)) : tr("No heading"),
         reason.isEmpty() ? so : reason + " · " + so, heading_delay_s});
}

void AlertRules::addRecording(const LiveStatus& run, std::vector<Situation>& situations) {
    const RecorderStatus& recorder = run.recorder;
    if (!recorder.error.empty()) {
        situations.push_back({"recording", AlertPriority::Alarm, tr("Recording has ended"),
                              text(recorder.error) + " · " + tr("make room and connect again")});
        return;
    }
    if (!recorder.recording) return;
    const auto minutes = minutesLeft(run);
    const bool full = recorder.disk == DiskState::Full || minutes.value_or(disk_alarm_min) < disk_alarm_min;
    const bool low = recorder.disk == DiskState::Low || minutes.value_or(disk_caution_min) < disk_caution_min;
    if (!full && !low) return;
    const QString free = tr("%1 free").arg(Formatter::bytes(recorder.free_bytes));
    situations.push_back({"disk", full ? AlertPriority::Alarm : AlertPriority::Caution, tr("Disk nearly full"),
                          minutes ? free + " · " + tr("room for %1 min").arg(Formatter::number(*minutes, 0)) : free});
}

std::vector<Situation> AlertRules::ofScene(const Scene& scene, bool live, const TrackNames& names) {
    std::vector<Situation> situations;
    for (const Track& track : scene.tracks) {
        if (!track.target || track.state != TrackState::Lost) continue;
        const Pose& pose = scene.latest.pose;
        situations.push_back(
            {QString("track_lost/%1").arg(track.id), AlertPriority::Alarm,
             tr("%1 lost, no echo for %2")
                 .arg(Formatter::trackLabel(track.id, names),
                      Formatter::age(secondsBetween(track.last_seen, scene.latest.time))),
             tr("expected at %1 %2")
                 .arg(Formatter::range(rangeOf(track, pose)), Formatter::relativeBearing(bearingOf(track, pose))),
             0.0, track.id});
    }
    if (!live && scene.navigation_known && scene.latest.navigation_gap)
        situations.push_back({"heading", AlertPriority::Warning, tr("No heading"), tr("tracks coast until it is back"),
                              heading_delay_s});
    return situations;
}

Situation AlertRules::guardZoneEntered(int track, const QString& zone, const TrackNames& names) {
    return {QString("guard/%1/%2").arg(zone).arg(track),
            AlertPriority::Alarm,
            tr("%1 in guard zone %2").arg(Formatter::trackLabel(track, names), zone),
            tr("a confirmed track has come in"),
            0.0,
            track,
            zone};
}

}  // namespace echotrail
