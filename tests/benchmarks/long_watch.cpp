// Eight hours at the console, 64 times as fast: the demonstration over and over without a break, its target lost and
// found anew each time, a guard zone in its way, nobody who acknowledges anything. Prints how much memory the program
// holds as the hours go by; exit code 1 where the second half of the watch needs more than the first.
//   long_watch [HOURS [SPEED]]

#include "core/simulation/demonstration.hpp"
#include "ui/alerts/alert_centre.hpp"
#include "ui/chart/area_model.hpp"
#include "ui/main_window/main_window.hpp"
#include "ui/views/fan_view.hpp"

#include <unistd.h>

#include <QApplication>
#include <QElapsedTimer>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <vector>

namespace echotrail {
namespace {

constexpr double default_hours = 8.0;
constexpr double default_speed = 64.0;
constexpr int samples = 32;  ///< of the memory in use, over the watch
constexpr double most_growth_mb = 4.0;
constexpr Microseconds pose_spacing{50'000};
constexpr double round_gap_s = 0.2;  ///< from the last ping of a round to the first of the next

/// A simulation that begins again when it ends, its time going on.
class Rounds final : public PingSource {
public:
    Rounds(std::unique_ptr<SimulatedSource> one, double lasting_s) : one_(std::move(one)) {
        one_->keepPings();
        info_ = one_->info();
        round_ = info_.end - info_.start + microsecondsFromSeconds(round_gap_s);
        rounds_ = std::max(1, static_cast<int>(microsecondsFromSeconds(lasting_s) / round_));
        info_.name = "a long watch";
        info_.pings *= static_cast<std::uint64_t>(rounds_);
        info_.end += (rounds_ - 1) * round_;
        rewind();
    }
    std::optional<Ping> next() override {
        auto ping = one_->next();
        if (!ping && number_ + 1 < rounds_) {
            begin(number_ + 1);
            ping = one_->next();
        }
        if (ping) ping->time += number_ * round_;
        return ping;
    }
    void rewind() override { begin(0); }
    const SourceInfo& info() const override { return info_; }
    SourceCounts counts() const override { return {}; }
    const PoseHistory& navigation() const override { return navigation_; }

private:
    void begin(int number) {
        number_ = number;
        one_->rewind();
        navigation_ = {};
        for (Microseconds at{}; at < round_; at += pose_spacing) {
            const Timestamp time = one_->info().start + at;
            if (const auto pose = one_->navigation().at(time, 1.0)) navigation_.add({time + number_ * round_, *pose});
        }
    }

    std::unique_ptr<SimulatedSource> one_;
    SourceInfo info_;
    Microseconds round_{};
    int rounds_ = 1;
    int number_ = 0;
    PoseHistory navigation_;
};

/// Of the whole program, in memory now.
double residentMb() {
    std::ifstream file("/proc/self/statm");
    long all = 0, resident = 0;
    file >> all >> resident;
    return static_cast<double>(resident * sysconf(_SC_PAGESIZE)) / 1e6;
}

/// Watches a run that has been opened; false where its memory grows.
bool watch(MainWindow& window) {
    std::vector<double> held_mb;
    QElapsedTimer clock;
    clock.start();
    int scenes = 0;
    QObject::connect(&window.bridge(), &PipelineBridge::sceneChanged, [&](const std::shared_ptr<const Scene>& scene) {
        ++scenes;
        window.fan().repaint();  // at once: without a screen Qt puts paintings off
        const std::uint64_t total = window.bridge().status().total;
        if (scene->position * (samples + 1) < total * (held_mb.size() + 1)) return;
        held_mb.push_back(residentMb());
        std::printf("%5.2f h: %7.1f MB, %6d scenes, %3zu tracks, %3d alerts, %6.1f s by the clock\n",
                    secondsBetween(window.bridge().info().start, scene->latest.time) / 3600.0, held_mb.back(), scenes,
                    scene->tracks.size(), window.alerts().model().rowCount(),
                    1e-3 * static_cast<double>(clock.elapsed()));
        std::fflush(stdout);
    });
    QObject::connect(&window.bridge(), &PipelineBridge::statusChanged, [&](const ReplayStatus& status) {
        if (status.state == ReplayState::Ended || status.state == ReplayState::Failed) QApplication::exit(0);
    });
    window.bridge().play();
    QApplication::exec();
    if (held_mb.size() < samples) return false;
    // Pages come and go with each picture: peaks are what tells.
    const auto half = held_mb.begin() + samples / 2;
    const double growth = *std::max_element(half, held_mb.end()) - *std::max_element(held_mb.begin(), half);
    std::printf("the second half needs %.1f MB more than the first\n", growth);
    return growth <= most_growth_mb;
}

}  // namespace
}  // namespace echotrail

int main(int argc, char** argv) {
    using namespace echotrail;
    if (qEnvironmentVariableIsEmpty("DISPLAY")) qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication app(argc, argv);
    QApplication::setStyle("Fusion");
    const double hours = argc > 1 ? std::atof(argv[1]) : default_hours;
    MainWindow window({.remember = false, .play_on_open = false});
    window.resize(1600, 1000);
    window.show();
    Layers layers = window.fan().layers();
    layers.trails = true;
    window.fan().setLayers(layers);
    window.bridge().setSpeed(argc > 2 ? std::atof(argv[2]) : default_speed);
    window.bridge().open("a long watch", [hours]() -> SourceOpener::Outcome {
        auto one = openSimulation("demonstration", default_scenario_seed);
        if (!one) return Error{one.error()};
        return std::unique_ptr<PingSource>(std::make_unique<Rounds>(*std::move(one), 3600.0 * hours));
    });
    const auto reading =
        QObject::connect(&window.bridge(), &PipelineBridge::statusChanged, [&](const ReplayStatus& status) {
            if (status.state == ReplayState::Paused) QApplication::exit(0);
        });
    QApplication::exec();  // until it has been read
    QObject::disconnect(reading);
    window.areas().add({Area::Kind::Guard, "", false, {{34.0F, -8.0F}, {46.0F, -8.0F}, {46.0F, 8.0F}, {34.0F, 8.0F}}});
    window.bridge().designate(40.0, radiansFromDegrees(-25.0));
    return watch(window) ? 0 : 1;
}
