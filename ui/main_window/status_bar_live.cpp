#include "ui/main_window/status_bar.hpp"
#include "ui/main_window/status_chip.hpp"
#include "ui/panels/connection/connection_panel.hpp"
#include "ui/style/formatter.hpp"

#include <limits>

namespace echotrail {
namespace {

using Health = StatusChip::Health;

constexpr double old_bytes_s = 2.0;  ///< a head that scans or waits says something every second
constexpr double rate_interval_s = 2.0;
constexpr quint64 loss_interval = 50;  ///< messages: of fewer the share would jump about
constexpr double least_loss = 0.005;   ///< less would be shown as none

/// What is wrong with the copy of the run aboard; nothing where it is as it should be.
QString copyText(const RecordingCopy& copy) {
    constexpr qint64 on_their_way = 300;  // rows of about a second
    if (!copy.error.isEmpty()) return StatusBar::tr("no copy here");
    if (!copy.asking) return StatusBar::tr("copy waits");
    if (copy.missed <= on_their_way) return {};
    return StatusBar::tr("copy: %1 rows missed").arg(Formatter::count(static_cast<std::uint64_t>(copy.missed)));
}

QString ageText(const std::optional<double>& age_s) { return age_s ? Formatter::age(*age_s) : QString(); }

}  // namespace

void StatusBar::showLive(const LiveState& state, double longest_heading_gap_s) {
    if (mode_ != Mode::Live) setMode(Mode::Live);
    showTracker(state.tracker);
    showLink(state);
    showSonar(state);
    showHeading(state, longest_heading_gap_s);
    showRecording(state.run.recorder, state.tracker ? state.tracker->record : std::nullopt);
    showCounts(state.run.counts);
}

void StatusBar::showLink(const LiveState& state) {
    const bool fresh = state.sonar.age_s && *state.sonar.age_s < old_bytes_s;
    const QString word = !state.sonar.up ? tr("down") : fresh ? tr("up") : tr("quiet");
    link_->show(state.sonar.up && fresh ? Health::Good : Health::Degraded, word, ageText(state.sonar.age_s));
    link_->setToolTip(state.sonar.reason.isEmpty() ? tr("Age of the last bytes from the head") : state.sonar.reason);
}

void StatusBar::showSonar(const LiveState& state) {
    const bool scanning = state.head.state == seanet::HeadState::Polling;
    const bool fresh = scanning && state.ping_age_s && *state.ping_age_s < old_bytes_s;
    const double rate = pingRate(state);
    QStringList detail;
    if (fresh) detail << Formatter::withUnit(rate, 1, tr("pings/s"));
    if (state.ping_age_s) detail << ageText(state.ping_age_s);
    sonar_->show(fresh ? Health::Good : Health::Degraded, headStateTitle(state.head.state), detail.join("  "));
    sonar_->setToolTip(state.head.advice.empty() ? QString::fromStdString(state.head.head)
                                                 : QString::fromStdString(state.head.advice));
}

void StatusBar::showTracker(const std::optional<TrackerState>& tracker) {
    for (StatusChip* chip : {tracker_, control_}) chip->setVisible(tracker.has_value());
    link_->setVisible(!tracker);  // the head's own link is the tracker's affair; SONAR says how the head is
    if (!tracker) return;
    const bool fresh = tracker->link.age_s && *tracker->link.age_s < old_bytes_s;
    QStringList detail{ageText(tracker->link.age_s)};
    if (fresh && tracker->latency_s) detail << Formatter::withUnit(1e3 * *tracker->latency_s, 0, "ms");
    if (const double loss = lossOf(*tracker); fresh && loss >= least_loss)
        detail << tr("%1 lost", "a share").arg(Formatter::withUnit(100.0 * loss, 0, "%"));
    tracker_->show(tracker->link.up && fresh ? Health::Good : Health::Degraded,
                   !tracker->link.up ? tr("down")
                   : fresh           ? tr("up")
                                     : tr("quiet"),
                   detail.join("  "));
    QStringList about{
        tracker->link.reason.isEmpty()
            ? tr("Age of the tracker's last message, how old an echo is when it is here, and what share of the "
                 "messages is lost")
            : tracker->link.reason + tr("; trying again")};
    if (!tracker->name.isEmpty()) about << tracker->name;
    if (tracker->round_trip_s)
        about << tr("there and back: %1").arg(Formatter::withUnit(1e3 * *tracker->round_trip_s, 0, "ms"));
    about << tr("messages that did not come: %1").arg(Formatter::count(tracker->gaps));
    tracker_->setToolTip(about.join('\n'));
    const bool yours = tracker->link.up && tracker->holds_control;
    control_->show(yours                       ? Health::Good
                   : tracker->holder.isEmpty() ? Health::Absent
                                               : Health::Plain,
                   yours                       ? tr("yours")
                   : tracker->holder.isEmpty() ? tr("nobody's")
                                               : tr("watching"),
                   !tracker->asking.isEmpty() ? tr("asked for by %1").arg(tracker->asking)
                   : yours                    ? QString()
                                              : tracker->holder);
    control_->setToolTip(tr("Who commands the tracker; ask for it, give it or keep it in the menu Sonar"));
}

/// The share of the last messages that did not come.
double StatusBar::lossOf(const TrackerState& tracker) {
    const quint64 all = tracker.messages + tracker.gaps;
    const bool anew = all < loss_counted_ || tracker.gaps < loss_gaps_;
    if (anew) loss_ = 0.0;
    if (!anew && all - loss_counted_ < loss_interval) return loss_;
    if (!anew) loss_ = static_cast<double>(tracker.gaps - loss_gaps_) / static_cast<double>(all - loss_counted_);
    loss_counted_ = all;
    loss_gaps_ = tracker.gaps;
    return loss_;
}

/// Over two seconds of the pings' own time: single lines come too unevenly to be read. Unknown before that.
double StatusBar::pingRate(const LiveState& state) {
    const std::uint64_t pings = state.head.pings;
    const auto& last = state.run.last_ping;
    const bool anew = !last || !rate_since_ || *last < *rate_since_ || pings < rate_pings_;
    const double passed_s = anew ? 0.0 : secondsBetween(*rate_since_, *last);
    if (anew)
        rate_ = std::numeric_limits<double>::quiet_NaN();
    else if (passed_s >= rate_interval_s)
        rate_ = static_cast<double>(pings - rate_pings_) / passed_s;
    if (anew || passed_s >= rate_interval_s) {
        rate_since_ = last;
        rate_pings_ = pings;
    }
    return rate_;
}

void StatusBar::showHeading(const LiveState& state, double longest_gap_s) {
    const auto& heading = state.run.navigation.heading;
    if (!heading || !state.heading_age_s) {
        const bool asked = state.navigation.has_value();
        heading_->show(asked ? Health::Degraded : Health::Absent, {}, asked ? tr("waiting") : tr("no navigation"));
        heading_->setToolTip(state.navigation ? state.navigation->reason : QString());
        return;
    }
    const bool fresh = *state.heading_age_s < longest_gap_s;
    heading_->show(fresh ? Health::Good : Health::Degraded, Formatter::trueBearing(*heading),
                   fresh ? ageText(state.heading_age_s) : tr("stale %1").arg(ageText(state.heading_age_s)));
    heading_->setToolTip(QString::fromStdString(state.run.navigation.heading_kind));
}

/// With a tracker: its log, and what of it is here.
void StatusBar::showRecording(const RecorderStatus& recorder, const std::optional<RecordingCopy>& copy) {
    QStringList about{QString::fromStdString(recorder.error.empty() ? recorder.path : recorder.error)};
    if (copy && !copy->path.isEmpty()) about << tr("copy here: %1").arg(copy->path);
    if (copy && !copy->error.isEmpty()) about << tr("no copy here: %1").arg(copy->error);
    recording_->setToolTip(about.join('\n'));
    if (!recorder.error.empty()) return recording_->show(Health::Degraded, tr("ended"), tr("not recording"));
    if (!recorder.recording) return recording_->show(Health::Absent, tr("off"));
    const bool room = recorder.disk == DiskState::Good;
    const bool copied = !copy || copy->error.isEmpty();
    const QString free = tr("%1 free").arg(Formatter::bytes(recorder.free_bytes));
    const QString of_copy = copy ? copyText(*copy) : QString();  // in place of what is good: there is little room
    recording_->show(room && copied ? Health::Good : Health::Degraded, Formatter::bytes(recorder.bytes),
                     !room               ? tr("disk nearly full: %1").arg(free)
                     : of_copy.isEmpty() ? free
                                         : of_copy);
}

}  // namespace echotrail
