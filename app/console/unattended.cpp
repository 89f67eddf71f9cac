#include "unattended.hpp"

#include "app/io/interrupts.hpp"

#include <QCoreApplication>
#include <QDockWidget>
#include <algorithm>
#include <iostream>
#include <utility>

namespace echotrail {
namespace {

constexpr int turn_ms = 1;
constexpr double step_s = 0.5;      // of a recording: no look of a track is missed by its charts
constexpr double watched_s = 60.0;  // before a picture; what lies further back is passed at once

enum ExitCode { done = 0, failed = 1, lossy = 3 };

}  // namespace

Unattended::Unattended(MainWindow& window, Schedule schedule, bool has_source)
    : QObject(&window), window_(window), schedule_(std::move(schedule)), has_source_(has_source) {
    std::stable_sort(schedule_.pictures.begin(), schedule_.pictures.end(),
                     [](const auto& a, const auto& b) { return a.at_s < b.at_s; });
    connect(&window.bridge(), &PipelineBridge::openFailed, this,
            [this](const QString& name, const QString& reason) { fail(name + ": " + reason); });
    connect(&timer_, &QTimer::timeout, this, &Unattended::turn);
    since_start_.start();
    timer_.start(turn_ms);
}

void Unattended::turn() {
    if (isInterrupted()) return conclude();
    const PipelineBridge& bridge = window_.bridge();
    const bool ready = bridge.isOpen() || !has_source_;  // what is opened brings docks of its own to the front
    if (ready && !schedule_.dock.isEmpty())
        window_.findChild<QDockWidget*>(std::exchange(schedule_.dock, QString()))->raise();
    if (has_source_ && !bridge.isLive())
        followRecording();
    else
        followClock();
}

double Unattended::nextMoment() const {
    if (!schedule_.pictures.empty()) return schedule_.pictures.front().at_s;
    return schedule_.exit_at_s.value_or(Schedule::unsaid);
}

bool Unattended::isDue(const Schedule::Picture& picture) const {
    if (picture.at_s != Schedule::unsaid) return 1e-3 * static_cast<double>(since_start_.elapsed()) >= picture.at_s;
    const PipelineBridge& bridge = window_.bridge();
    return !bridge.isLive() || (bridge.liveState().run.sweeps > 0 && bridge.scene());
}

void Unattended::followClock() {
    const bool ends_with_pictures = !schedule_.pictures.empty() && !schedule_.exit_at_s;
    while (!schedule_.pictures.empty() && isDue(schedule_.pictures.front()))
        if (!shoot()) return;
    const bool over = schedule_.exit_at_s && 1e-3 * static_cast<double>(since_start_.elapsed()) >= *schedule_.exit_at_s;
    if (over || (ends_with_pictures && schedule_.pictures.empty())) conclude();
}

std::uint64_t Unattended::positionOf(double at_s) const {
    const Timeline& timeline = window_.bridge().timeline();
    const auto& times = *timeline.ping_times;
    if (at_s >= secondsBetween(times.front(), times.back())) return timeline.pings();
    return timeline.positionAt(times.front() + microsecondsFromSeconds(at_s));
}

std::uint64_t Unattended::stepTowards(std::uint64_t goal) const {
    const Timeline& timeline = window_.bridge().timeline();
    const auto timeOf = [&](std::uint64_t position) { return (*timeline.ping_times)[position - 1]; };
    const std::uint64_t unwatched = timeline.positionAt(timeOf(goal) - microsecondsFromSeconds(watched_s));
    if (*position_ < unwatched) return unwatched;
    if (*position_ == 0) return 1;
    const std::uint64_t step = timeline.positionAt(timeOf(*position_) + microsecondsFromSeconds(step_s));
    return std::min(goal, std::max(step, *position_ + 1));
}

bool Unattended::restsAt(std::uint64_t position) const {
    const ReplayStatus& status = window_.bridge().status();
    const auto& scene = window_.bridge().scene();
    const bool rests = status.state == ReplayState::Paused || status.state == ReplayState::Ended;
    return rests && status.position == position && status.goal == position && scene && scene->position == position &&
           (position < status.total || scene->at_end);
}

/// The time line is worked out while nothing else is to be done, and that must be over in a picture.
bool Unattended::isWhole(const Timeline& timeline) const {
    return timeline.pings() > 0 && timeline.analysed == timeline.pings() &&
           timeline.revision == window_.bridge().status().revision;
}

void Unattended::followRecording() {
    PipelineBridge& bridge = window_.bridge();
    bridge.poll();  // sooner than the display asks
    const ReplayStatus& status = bridge.status();
    if (status.state == ReplayState::Failed) return fail(QString::fromStdString(status.error));
    if (!bridge.isOpen() || !isWhole(bridge.timeline()) || !restsAt(position_.value_or(0))) return;
    const double moment = nextMoment();
    const std::uint64_t goal = positionOf(moment);
    if (position_.value_or(0) < goal) {
        if (!position_) position_ = 0;
        position_ = stepTowards(goal);
        return bridge.seekPosition(*position_);
    }
    const auto& times = *bridge.timeline().ping_times;
    past_end_ |= moment != Schedule::unsaid && moment > secondsBetween(times.front(), times.back()) + step_s;
    if (schedule_.pictures.empty()) return conclude();
    if (shoot() && schedule_.pictures.empty() && !schedule_.exit_at_s) conclude();
}

bool Unattended::shoot() {
    const QString path = schedule_.pictures.front().path;
    schedule_.pictures.erase(schedule_.pictures.begin());
    if (window_.saveScreenshot(path)) return true;
    fail(path + " could not be written");
    return false;
}

QString Unattended::losses() const {
    QStringList parts;
    if (past_end_) parts << "a moment asked for lies past the end of the recording";
    if (window_.bridge().isLive()) {
        const LiveStatus& run = window_.bridge().liveState().run;
        if (!run.recorder.error.empty()) parts << "recording has ended: " + QString::fromStdString(run.recorder.error);
        if (run.skipped > 0) parts << QString("pings skipped: %1").arg(run.skipped);
    } else if (const auto& scene = window_.bridge().scene()) {
        if (scene->counts.lost_records > 0) parts << QString("records lost: %1").arg(scene->counts.lost_records);
        for (const auto& [cause, count] : scene->counts.rejected)
            parts << QString("rejected for %1: %2").arg(QString::fromStdString(cause)).arg(count);
    }
    return parts.join("; ");
}

void Unattended::conclude() {
    timer_.stop();
    const QString lost = losses();
    if (!lost.isEmpty()) std::cerr << "echotrail-console: " << lost.toStdString() << "\n";
    QCoreApplication::exit(lost.isEmpty() ? done : lossy);
}

void Unattended::fail(const QString& reason) {
    timer_.stop();
    std::cerr << "echotrail-console: " << reason.toStdString() << "\n";
    QCoreApplication::exit(failed);
}

}  // namespace echotrail
