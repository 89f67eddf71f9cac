#include "screenshot.hpp"

#include <QCoreApplication>
#include <QTimer>
#include <iostream>
#include <utility>

namespace echotrail {

Screenshot::Screenshot(MainWindow& window, const QString& path, std::optional<double> at_s, bool has_source)
    : QObject(&window), window_(window), path_(path), at_s_(at_s) {
    connect(&window.bridge(), &PipelineBridge::statusChanged, this, &Screenshot::follow);
    connect(&window.bridge(), &PipelineBridge::openFailed, this,
            [this](const QString& name, const QString& reason) { fail(name + ": " + reason); });
    if (window.bridge().isLive() && at_s_)
        QTimer::singleShot(static_cast<int>(*at_s_ * 1000.0), this, &Screenshot::shoot);
    else if (window.bridge().isLive())
        waitForSweep();
    if (!has_source) QTimer::singleShot(0, this, &Screenshot::shoot);
}

void Screenshot::waitForSweep() {
    connect(&window_.bridge(), &PipelineBridge::liveChanged, this, [this](const LiveState& state) {
        if (state.run.sweeps == 0 || !window_.bridge().scene() || std::exchange(shot_, true)) return;
        QTimer::singleShot(0, this, &Screenshot::shoot);
    });
}

void Screenshot::follow(const ReplayStatus& status) {
    if (window_.bridge().isLive()) return;
    if (status.state == ReplayState::Failed) return fail(QString::fromStdString(status.error));
    const bool rests = (status.state == ReplayState::Paused || status.state == ReplayState::Ended) &&
                       !status.analysing && status.goal == status.position;
    if (!rests || shot_) return;
    if (!sought_) {
        sought_ = true;
        if (at_s_)
            window_.bridge().seekSeconds(*at_s_);
        else
            window_.bridge().seekPosition(status.total);
    } else if (window_.bridge().scene() && window_.bridge().scene()->position == status.position &&
               status.position > 0) {
        shot_ = true;
        QTimer::singleShot(0, this, &Screenshot::shoot);  // after the widgets have taken in the last scene
    }
}

void Screenshot::shoot() {
    if (!window_.saveScreenshot(path_)) return fail(path_ + " could not be written");
    QCoreApplication::exit(0);
}

void Screenshot::fail(const QString& reason) {
    std::cerr << "echotrail-console: " << reason.toStdString() << "\n";
    QCoreApplication::exit(1);
}

}  // namespace echotrail
