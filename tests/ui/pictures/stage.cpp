// Puts the window into a state that needs a live head, without one and without a clock, and takes its picture:
//   ui_stage STAGE PALETTE LANGUAGE WIDTH HEIGHT FILE

#include "scripted_source.hpp"
#include "ui/alerts/alert_centre.hpp"
#include "ui/chart/area_model.hpp"
#include "ui/main_window/main_window.hpp"
#include "ui/style/palette.hpp"

#include <QApplication>
#include <QElapsedTimer>
#include <iostream>
#include <map>

namespace echotrail::test {
namespace {

constexpr double step_s = 0.5;
constexpr int settled_ms = 400;  // longer than the bridge waits between two states

class Stage {
public:
    Stage(std::string_view scenario, const QString& language)
        : head_(scenario),
          window_({.remember = false,
                   .language = language,
                   .steady_alerts = true,
                   .unhurried = true,
                   .live = {.open = [this](const LiveRequest&) -> Opened { return source(); },
                            .open_tracker = [this](const QString&, bool) -> Opened { return source(); }}}) {
        head_.goTo(at_s_);
        script_.state = head_.state();
        window_.alerts().setSound({});
        window_.alerts().setClock([this] { return head_.now() + microsecondsFromSeconds(waited_s_); });
    }

    MainWindow& window() { return window_; }
    ScriptedHead& head() { return head_; }
    void connectHead() { window_.bridge().openLive("tcp://sonar:4000", "udp://sonar:4001?listen=4001", true); }
    void connectTracker() { window_.bridge().openTracker("tls://vehicle:7001", false); }

    /// Shows the pings up to so many seconds from the first; `change` is what is not in good health.
    void goTo(double seconds, const std::function<void(LiveState&)>& change = {}) {
        for (; at_s_ < seconds; at_s_ += step_s) {
            head_.goTo(at_s_);
            script_.scene = head_.scene();
            script_.timeline = head_.timeline();
            tell(change);
        }
    }
    /// Nothing comes any more, but time goes on.
    void wait(double seconds, const std::function<void(LiveState&)>& change) {
        for (const double end = waited_s_ + seconds; waited_s_ < end; waited_s_ += step_s) tell(change);
        tell(change);
    }
    double waited() const { return waited_s_; }
    /// What the window does by timers has been done.
    void settle() {
        QElapsedTimer clock;
        clock.start();
        while (clock.elapsed() < settled_ms) QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
    }

private:
    using Opened = Result<std::unique_ptr<LiveSource>>;
    std::unique_ptr<LiveSource> source() { return std::make_unique<ScriptedSource>(script_); }
    void tell(const std::function<void(LiveState&)>& change) {
        script_.state = head_.state();
        if (change) change(script_.state);
        window_.bridge().poll();
        Q_EMIT window_.bridge().liveChanged(script_.state);
    }

    ScriptedHead head_;
    ScriptedSource::Script script_;
    double at_s_ = step_s;
    double waited_s_ = 0.0;
    MainWindow window_;
};

TrackerState tracker() {
    TrackerState state;
    state.link = {true, {}, 0.2};
    state.name = "vehicle";
    state.latency_s = 0.31;
    state.round_trip_s = 0.52;
    state.holds_control = true;
    state.holder = "bridge";
    return state;
}

void live(Stage& stage) {
    stage.head().designate(40.0, Bearing::degrees(-25.0));
    stage.connectHead();
    stage.goTo(60.0);
}

void lost(Stage& stage) {
    stage.head().designate(22.0, {});
    stage.connectHead();
    stage.goTo(255.0);
}

void stale(Stage& stage) {
    stage.head().designate(40.0, Bearing::degrees(-25.0));
    stage.connectTracker();
    stage.goTo(50.0, [](LiveState& state) { state.tracker = tracker(); });
    stage.wait(8.0, [&](LiveState& state) {
        state.tracker = tracker();
        state.tracker->link = {false, "connection refused", 0.2 + stage.waited()};
        state.ping_age_s = state.heading_age_s = 0.1 + stage.waited();
    });
}

void alerts(Stage& stage) {
    stage.head().designate(40.0, Bearing::degrees(-25.0));
    stage.connectHead();
    stage.window().areas().add(
        {Area::Kind::Guard, "ahead", true, {{22.0F, -6.0F}, {32.0F, -6.0F}, {32.0F, 8.0F}, {22.0F, 8.0F}}});
    stage.window().areas().add(
        {Area::Kind::Guard, "pier", true, {{34.0F, 12.0F}, {42.0F, 12.0F}, {42.0F, 26.0F}, {34.0F, 26.0F}}});
    const auto low_disk = [](LiveState& state) {
        state.run.recorder.free_bytes = 1'200'000'000;
        state.run.recorder.disk = DiskState::Low;
    };
    stage.goTo(45.0, low_disk);
    stage.window().alerts().acknowledgeMostUrgent();
    stage.goTo(60.0, [&](LiveState& state) {
        low_disk(state);
        state.navigation = LiveLink{false, "no answer", 9.0};
        state.heading_age_s = 9.0;
    });
}

}  // namespace
}  // namespace echotrail::test

int main(int argc, char** argv) {
    using namespace echotrail;
    struct Play {
        const char* scenario;
        void (*act)(test::Stage&);
    };
    const std::map<QString, Play> plays{{"live", {"demonstration", test::live}},
                                        {"lost", {"leaving", test::lost}},
                                        {"stale", {"demonstration", test::stale}},
                                        {"alerts", {"demonstration", test::alerts}}};
    QApplication app(argc, argv);
    QApplication::setStyle("Fusion");
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() != 7 || !plays.contains(arguments[1])) {
        std::cerr << "ui_stage STAGE PALETTE LANGUAGE WIDTH HEIGHT FILE\n";
        return 2;
    }
    const Play& play = plays.at(arguments[1]);
    test::Stage stage(play.scenario, arguments[3]);
    stage.window().setTheme(themeFromName(arguments[2]));
    stage.window().resize(arguments[4].toInt(), arguments[5].toInt());
    stage.window().show();
    QCoreApplication::processEvents();  // the window has changed to its language
    play.act(stage);
    stage.settle();
    return stage.window().saveScreenshot(arguments[6]) ? 0 : 1;
}
