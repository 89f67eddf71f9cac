#include "ui/alerts/alert_rules.hpp"

#include "ui/views/track_painter.hpp"

#include <algorithm>
#include <utility>

namespace echotrail {
namespace {

QString text(const std::string& plain) { return QString::fromStdString(plain); }

/// What a far tracker said last, some time ago, says nothing about now.
bool isTold(const LiveState& state) {
    return !state.tracker || (state.tracker->link.up && state.tracker->report_age_s <= AlertRules::stale_link_s);
}

/// `words` must hold all it needs: it may be asked for them again long afterwards.
Situation situationOf(const QString& key, AlertPriority priority, double delay_s, std::function<AlertWords()> words,
                      int track = 0) {
    const AlertWords now = words();
    return {key, priority, now.title, now.cause, delay_s, track, std::move(words)};
}

QString joined(const QString& first, const QString& then) { return first.isEmpty() ? then : first + " · " + then; }

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
            situationOf("copy", AlertPriority::Caution, 0.0, [error = state.tracker->record->error]() -> AlertWords {
                return {tr("The run is not copied here"), error};
            }));
    return situations;
}

void AlertRules::addLinks(const LiveState& state, std::vector<Situation>& situations) {
    const auto judge = [&](const LiveLink& link, const QString& key, const char* broken, const char* quiet) {
        const bool stale = link.age_s.value_or(0.0) > stale_link_s;
        if (link.up && !stale) return true;
        situations.push_back(situationOf(key, AlertPriority::Warning, link_delay_s, [=]() -> AlertWords {
            const QString age =
                link.age_s ? tr("last heard %1 ago").arg(Formatter::age(*link.age_s)) : tr("never heard");
            return {tr(link.up ? quiet : broken), joined(link.reason, age)};
        }));
        return false;
    };
    if (state.tracker) {
        LiveLink link = state.tracker->link;
        if (link.age_s) link.age_s = std::max(*link.age_s, state.tracker->report_age_s);
        if (!judge(link, "tracker_link", QT_TR_NOOP("Link to the tracker lost"), QT_TR_NOOP("Tracker is quiet")))
            return;  // the head's link is known through it only
    }
    if (!judge(state.sonar, "sonar_link", QT_TR_NOOP("Link to the sonar lost"), QT_TR_NOOP("Sonar is quiet"))) return;
    if (!state.head.advice.empty())
        situations.push_back(
            situationOf("head", AlertPriority::Warning, link_delay_s, [advice = state.head.advice]() -> AlertWords {
                return {tr("The sonar head needs a look"), text(advice)};
            }));
}

void AlertRules::addHeading(const LiveState& state, double longest_gap_s, std::vector<Situation>& situations) {
    if (!state.navigation && !state.run.navigation_expected) return;  // nobody asked for one
    if (state.heading_age_s && *state.heading_age_s <= longest_gap_s) return;
    const QString reason = state.navigation ? state.navigation->reason : QString();
    const bool old = state.heading_age_s.has_value();
    situations.push_back(situationOf("heading", AlertPriority::Warning, heading_delay_s, [=]() -> AlertWords {
        return {old ? tr("Heading old, limit %1").arg(Formatter::age(longest_gap_s)) : tr("No heading"),
                joined(reason, tr("tracks coast until it is back"))};
    }));
}

void AlertRules::addRecording(const LiveStatus& run, std::vector<Situation>& situations) {
    const RecorderStatus& recorder = run.recorder;
    if (!recorder.error.empty()) {
        situations.push_back(
            situationOf("recording", AlertPriority::Alarm, 0.0, [error = recorder.error]() -> AlertWords {
                return {tr("Recording has ended"), joined(text(error), tr("make room and connect again"))};
            }));
        return;
    }
    if (!recorder.recording) return;
    const auto minutes = minutesLeft(run);
    const bool full = recorder.disk == DiskState::Full || minutes.value_or(disk_alarm_min) < disk_alarm_min;
    const bool low = recorder.disk == DiskState::Low || minutes.value_or(disk_caution_min) < disk_caution_min;
    if (!full && !low) return;
    situations.push_back(situationOf(
        "disk", full ? AlertPriority::Alarm : AlertPriority::Caution, 0.0,
        [minutes, bytes = recorder.free_bytes]() -> AlertWords {
            const QString free = tr("%1 free").arg(Formatter::bytes(bytes));
            return {tr("Disk nearly full"),
                    minutes ? joined(free, tr("room for %1 min").arg(Formatter::number(*minutes, 0))) : free};
        }));
}

std::vector<Situation> AlertRules::ofScene(const Scene& scene, bool live, const TrackNames& names) {
    std::vector<Situation> situations;
    for (const Track& track : scene.tracks) {
        if (!track.target || track.state != TrackState::Lost) continue;
        const Pose& pose = scene.latest.pose;
        situations.push_back(situationOf(
            QString("track_lost/%1").arg(track.id), AlertPriority::Alarm, 0.0,
            [label = Formatter::trackLabel(track.id, names),
             silent_s = secondsBetween(track.last_seen, scene.latest.time), range_m = rangeOf(track, pose),
             bearing = bearingOf(track, pose)]() -> AlertWords {
                return {tr("%1 lost, no echo for %2").arg(label, Formatter::age(silent_s)),
                        tr("expected at %1 %2").arg(Formatter::range(range_m), Formatter::relativeBearing(bearing))};
            },
            track.id));
    }
    if (!live && scene.navigation_known && scene.latest.navigation_gap)
        situations.push_back(situationOf("heading", AlertPriority::Warning, heading_delay_s, []() -> AlertWords {
            return {tr("No heading"), tr("tracks coast until it is back")};
        }));
    return situations;
}

Situation AlertRules::guardZoneEntered(int track, const QString& zone, const TrackNames& names) {
    return situationOf(
        QString("guard/%1/%2").arg(zone).arg(track), AlertPriority::Alarm, 0.0,
        [label = Formatter::trackLabel(track, names), zone]() -> AlertWords {
            return {tr("%1 in guard zone %2").arg(label, zone), tr("a confirmed track has come in")};
        },
        track);
}

}  // namespace echotrail
