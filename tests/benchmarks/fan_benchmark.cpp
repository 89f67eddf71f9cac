#include "tests/ui/look/sample_scene.hpp"
#include "ui/style/palette.hpp"
#include "ui/views/fan_view.hpp"

#include <benchmark/benchmark.h>

#include <QApplication>
#include <QImage>

namespace echotrail {
namespace {

constexpr QSize view_px(1400, 1000);
constexpr int tracks = 10;
constexpr int particles = 5000;
constexpr int regions = 30;

/// What a busy sea comes to: ten tracks with 5 000 particles between them and 30 regions on a fan of echoes.
Scene busyScene() {
    Scene scene = test::bareScene();
    cv::RNG noise(1);
    noise.fill(scene.fan.levels, cv::RNG::UNIFORM, 20, 200);
    const auto place = [](int i, int of) {
        const double angle = radiansFromDegrees(-40.0 + 80.0 * i / (of - 1));
        const double range = 6.0 + 12.0 * (i * 7 % of) / of;
        return std::pair(range * std::cos(angle), range * std::sin(angle));
    };
    constexpr std::array states{TrackState::Confirmed, TrackState::Coasting, TrackState::Tentative, TrackState::Lost};
    for (int i = 0; i < tracks; ++i) {
        const auto [north, east] = place(i, tracks);
        scene.tracks.push_back(
            test::sampleTrack(i + 1, states[static_cast<std::size_t>(i) % states.size()], north, east));
        scene.tracks.back().particles.position_m.resize(particles / tracks);
        scene.tracks.back().particles.weight.resize(particles / tracks);
    }
    scene.tracks[0].target = true;
    for (int i = 0; i < regions; ++i) {
        const auto [north, east] = place(i, regions);
        scene.regions.push_back(test::sampleRegion(static_cast<std::uint32_t>(i + 1), north, east, i % 5 == 0));
    }
    return scene;
}

void paintFan(benchmark::State& state, const Scene& scene, bool new_echoes) {
    applyTheme(*qApp, Theme::Dusk);
    FanView view;
    view.resize(view_px);
    const auto shared = test::shared(scene);
    view.setScene(shared);
    QImage frame(view_px, QImage::Format_RGB32);
    view.render(&frame);  // what is kept from frame to frame
    for (auto each : state) {
        if (new_echoes) view.setScene(shared);
        view.render(&frame);
    }
}

void BM_EmptyFanFrame(benchmark::State& state) { paintFan(state, test::bareScene(), false); }
void BM_BusyFanFrame(benchmark::State& state) { paintFan(state, busyScene(), false); }
void BM_BusyFanFrameWithNewEchoes(benchmark::State& state) { paintFan(state, busyScene(), true); }
BENCHMARK(BM_EmptyFanFrame)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_BusyFanFrame)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_BusyFanFrameWithNewEchoes)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace echotrail

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication app(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
