// How long the GUI thread is busy with one event, while the window does what is hardest on it: a live head, a replay at
// maximum speed, a window that is being resized. An operator's key waits that long. Prints one line for each; exit code
// 1 where an event took more than 50 ms of the thread's processor time.

#include "app/console/live_connection.hpp"
#include "core/runtime/replay_runner.hpp"
#include "ui/main_window/main_window.hpp"
#include "ui/panels/connection/connection_panel.hpp"
#include "ui/views/fan_view.hpp"

#include <QApplication>
#include <QElapsedTimer>
#include <QEvent>
#include <QTimer>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>

namespace echotrail {
namespace {

constexpr double limit_ms = 50.0;
constexpr int watched_ms = 10'000;
constexpr int resize_ms = 30;

double threadMs() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Times each event that comes from the event loop, with all that it brings about.
class WatchedApplication : public QApplication {
public:
    using QApplication::QApplication;
    bool notify(QObject* receiver, QEvent* event) override {
        if (nested_ || !watching_) return QApplication::notify(receiver, event);
        nested_ = true;
        const QEvent::Type type = event->type();
        QElapsedTimer wall;
        wall.start();
        const double before = threadMs();
        const bool taken = QApplication::notify(receiver, event);
        const double busy = threadMs() - before;
        nested_ = false;
        ++events_;
        total_ms_ += busy;
        most_wall_ms_ = std::max(most_wall_ms_, 1e-6 * static_cast<double>(wall.nsecsElapsed()));
        over_ += busy > limit_ms;
        if (busy > most_ms_) {
            most_ms_ = busy;
            most_type_ = type;
        }
        return taken;
    }
    void countScene() { ++scenes_; }
    /// Runs the event loop for a while and tells; false where an event took too long.
    bool watch(const char* what) {
        scenes_ = 0;
        events_ = over_ = 0;
        total_ms_ = most_ms_ = most_wall_ms_ = 0.0;
        watching_ = true;
        QTimer::singleShot(watched_ms, this, [] { exit(0); });  // quit() would close the window
        exec();
        watching_ = false;
        std::printf(
            "%-24s %4d scenes, %5d events, busy %4.1f %%, longest %5.1f ms (event %d; %.1f ms by the clock), %d over "
            "%.0f ms\n",
            what, scenes_, events_, 100.0 * total_ms_ / watched_ms, most_ms_, most_type_, most_wall_ms_, over_,
            limit_ms);
        std::fflush(stdout);
        return over_ == 0;
    }

private:
    int scenes_ = 0;
    bool watching_ = false;
    bool nested_ = false;
    int events_ = 0;
    int over_ = 0;
    int most_type_ = 0;
    double total_ms_ = 0.0, most_ms_ = 0.0, most_wall_ms_ = 0.0;
};

}  // namespace
}  // namespace echotrail

int main(int argc, char** argv) {
    using namespace echotrail;
    if (qEnvironmentVariableIsEmpty("DISPLAY")) qputenv("QT_QPA_PLATFORM", "offscreen");
    WatchedApplication app(argc, argv);
    QApplication::setStyle("Fusion");
    MainWindow window({.remember = false, .live = liveAccess()});
    window.resize(1600, 1000);
    window.show();

    QObject::connect(&window.bridge(), &PipelineBridge::sceneChanged, [&] {
        app.countScene();
        window.fan().repaint();  // at once: without a screen Qt puts paintings off
    });
    window.connection().connectTo("simulation://demo", {}, false);
    bool good = app.watch("live head");
    QTimer resizing;
    int turn = 0;
    QObject::connect(&resizing, &QTimer::timeout, &window, [&] {
        const double swing = std::sin(0.1 * ++turn);
        window.resize(1750 + static_cast<int>(200.0 * swing), 1050 + static_cast<int>(120.0 * swing));
    });
    resizing.start(resize_ms);
    good &= app.watch("live head, resized");
    resizing.stop();

    window.bridge().setSpeed(ReplayRunner::max_speed);
    window.openDemonstration();
    QObject::connect(&window.bridge(), &PipelineBridge::statusChanged, &window, [&](const ReplayStatus& status) {
        if (status.state == ReplayState::Ended) window.bridge().play();  // again from the start
    });
    good &= app.watch("replay at maximum speed");
    resizing.start(resize_ms);
    good &= app.watch("the same, resized");
    return good ? 0 : 1;
}
