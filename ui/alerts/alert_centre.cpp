#include "ui/alerts/alert_centre.hpp"

#include "ui/alerts/alert_rules.hpp"
#include "ui/language/language.hpp"

#include <QApplication>
#include <algorithm>

namespace echotrail {
namespace {

constexpr int tick_ms = 250;  ///< half a period of the fastest flash

/// Ticks for which it is lit, then dark: emergency 2 Hz, alarm 1 Hz, warning 0.5 Hz.
unsigned halfPeriod(AlertPriority priority) {
    return priority == AlertPriority::Emergency ? 1 : priority == AlertPriority::Alarm ? 2 : 4;
}

}  // namespace

AlertCentre::AlertCentre(QObject* parent) : QObject(parent), sound_([] { QApplication::beep(); }) {
    started_ = std::chrono::time_point_cast<Microseconds>(std::chrono::system_clock::now());
    running_.start();
    timer_.setInterval(tick_ms);
    connect(&timer_, &QTimer::timeout, this, &AlertCentre::tick);
    inEveryLanguage(this, [this] {
        book_.reword();
        tell();
    });
}

Timestamp AlertCentre::now() const {
    if (!live_) return replay_time_;
    return clock_ ? clock_() : started_ + std::chrono::milliseconds(running_.elapsed());
}

void AlertCentre::showNothing() {
    book_.clear();
    of_live_.clear();
    of_scene_.clear();
    muted_.clear();
    live_ = false;
    replay_time_ = {};
    tell();
}

void AlertCentre::showLive(const LiveState& state, double longest_heading_gap_s) {
    live_ = true;
    of_live_ = AlertRules::ofLive(state, longest_heading_gap_s);
    update();
}

void AlertCentre::showScene(const Scene& scene, bool live) {
    live_ = live;
    if (!live && scene.latest.time < replay_time_) book_.clear();  // wound back
    if (!live) replay_time_ = scene.latest.time;
    of_scene_ = AlertRules::ofScene(scene, live, names_);
    update();
}

void AlertCentre::update() {
    std::vector<Situation> all = of_live_;
    all.insert(all.end(), of_scene_.begin(), of_scene_.end());
    std::erase_if(all, [this](const Situation& each) { return muted_.contains(each.track); });
    book_.update(all, now());
    tell();
}

void AlertCentre::guardZoneEntered(int track, const QString& zone) {
    if (muted_.contains(track)) return;
    book_.happened(AlertRules::guardZoneEntered(track, zone, names_), now());
    tell();
}

void AlertCentre::setMuted(int track, bool on) {
    if (!on) {
        muted_.remove(track);
        return;
    }
    muted_.insert(track);
    const std::vector<Alert> alerts = book_.alerts();
    for (const Alert& alert : alerts)
        if (alert.situation.track == track) book_.acknowledge(alert.id, now());
    update();
}

void AlertCentre::acknowledge(int id) {
    book_.acknowledge(id, now());
    tell();
}

void AlertCentre::acknowledgeMostUrgent() {
    if (const Alert* alert = book_.mostUrgent()) acknowledge(alert->id);
}

void AlertCentre::silence() {
    sound_rule_.silence(now());
    Q_EMIT changed();
}

void AlertCentre::tell() {
    const auto changes = book_.takeChanges();
    if (live_ && log_ && !log_->write(changes) && !std::exchange(log_failure_told_, true))
        Q_EMIT noticed(tr("Alerts cannot be written to %1. They are only shown.").arg(log_->path()), false);
    model_.setAlerts(book_.alerts());
    const bool asks = book_.mostUrgent() != nullptr;
    if (asks && !timer_.isActive()) phase_ = 0;  // a new one begins lit
    if (asks != timer_.isActive()) asks ? timer_.start() : timer_.stop();
    if (live_ && sound_rule_.isDue(book_, now()) && sound_) sound_();
    Q_EMIT changed();
}

void AlertCentre::tick() {
    ++phase_;
    if (live_) update();  // a link that is silent brings no scene: time goes on all the same
    if (!steady_) Q_EMIT flashed();
}

void AlertCentre::setSteady(bool on) {
    steady_ = on;
    Q_EMIT flashed();
}

bool AlertCentre::isLit(AlertPriority priority) const { return steady_ || phase_ / halfPeriod(priority) % 2 == 0; }

AlertSummary AlertCentre::summary() const {
    AlertSummary summary;
    for (const Alert& alert : book_.alerts()) {
        if (!alert.isOpen()) continue;
        const bool alarm = alert.priority <= AlertPriority::Alarm;
        const bool warning = alert.priority == AlertPriority::Warning;
        ++(alarm ? summary.alarms : warning ? summary.warnings : summary.cautions);
        summary.new_alarm |= alarm && alert.isNew();
        summary.new_warning |= warning && alert.isNew();
    }
    summary.recent = book_.recent(now());
    if (const Alert* alert = book_.mostUrgent()) summary.title = alert->situation.title;
    return summary;
}

}  // namespace echotrail
