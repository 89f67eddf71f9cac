#include "tests/ui/look/sample_scene.hpp"
#include "ui/style/palette.hpp"
#include "ui/views/echo_painter.hpp"
#include "ui/views/fan_view.hpp"

#include <benchmark/benchmark.h>
#include <opencv2/imgproc.hpp>

#include <QApplication>
#include <QImage>

// What it takes to paint the fan in software, all threads counted.

namespace echotrail {
namespace {

constexpr QSize view_px(1400, 1000);
constexpr int tracks = 10;
constexpr int particles = 5000;
constexpr int regions = 30;
constexpr double cloud_m = 2.0;  ///< deviation of the particles
constexpr int scene_count = 8;
constexpr double between_scenes_s = 0.1;

/// What a busy sea comes to: ten tracks with 5 000 particles between them and 30 regions on a fan of echoes.
Scene busyScene(double after_s) {
    Scene scene = test::bareScene();
    cv::RNG noise(1);
    noise.fill(scene.fan.levels, cv::RNG::UNIFORM, 20, 200);
    const auto place = [after_s](int i, int of) {
        const double angle = radiansFromDegrees(-40.0 + 80.0 * i / (of - 1));
        const double range = 6.0 + 12.0 * (i * 7 % of) / of + 0.3 * after_s;
        return std::pair(range * std::cos(angle), range * std::sin(angle));
    };
    constexpr std::array states{TrackState::Confirmed, TrackState::Coasting, TrackState::Tentative, TrackState::Lost};
    for (int i = 0; i < tracks; ++i) {
        const auto [north, east] = place(i, tracks);
        scene.tracks.push_back(
            test::sampleTrack(i + 1, states[static_cast<std::size_t>(i) % states.size()], north, east));
        ParticleCloud& cloud = scene.tracks.back().particles;
        cloud.position_m.resize(particles / tracks);
        cloud.weight.resize(particles / tracks);
        for (std::size_t k = 0; k < cloud.position_m.size(); ++k) {
            cloud.position_m[k] = {static_cast<float>(north + noise.gaussian(cloud_m)),
                                   static_cast<float>(east + noise.gaussian(cloud_m))};
            cloud.weight[k] = noise.uniform(0.1F, 1.0F);
        }
    }
    scene.tracks[0].target = true;
    for (int i = 0; i < regions; ++i) {
        const auto [north, east] = place(i, regions);
        scene.regions.push_back(test::sampleRegion(static_cast<std::uint32_t>(i + 1), north, east, i % 5 == 0));
    }
    scene.latest.time += microsecondsFromSeconds(after_s);
    return scene;
}

void paintFan(benchmark::State& state, const std::vector<std::shared_ptr<const Scene>>& scenes) {
    applyTheme(*qApp, Theme::Dusk);
    FanView view;
    view.resize(view_px);
    view.setScene(scenes.front());
    QImage frame(view_px, QImage::Format_RGB32);
    view.render(&frame);  // what is kept from frame to frame
    std::size_t next = 0;
    for (auto each : state) {
        if (scenes.size() > 1) view.setScene(scenes[++next % scenes.size()]);
        view.render(&frame);
    }
}

/// Nothing but echoes.
void BM_EmptyFanFrame(benchmark::State& state) { paintFan(state, {test::shared(test::bareScene())}); }
/// All of the tracker's findings are painted, the picture of the echoes is kept: the hand moves the cursor, or the
/// picture of a sweep stands still.
void BM_BusyFanFrame(benchmark::State& state) { paintFan(state, {test::shared(busyScene(0.0))}); }
/// Another scene each time: the picture of the echoes, too, and all texts that tell an age are made anew.
void BM_BusyFanFrameOfANewScene(benchmark::State& state) {
    std::vector<std::shared_ptr<const Scene>> scenes;
    for (int i = 0; i < scene_count; ++i) scenes.push_back(test::shared(busyScene(between_scenes_s * i)));
    paintFan(state, scenes);
}

/// The echoes of a vehicle that has turned, so that rows of the screen are no rows of the fan.
FanGeometry turnedGeometry(const Scene& scene) {
    Pose pose;
    pose.heading = Bearing::degrees(20.0);
    return fitted(pose, pose.heading, sectorOf(scene), QRectF(QPointF(), view_px), {});
}

/// Levels interpolated and coloured by the console's own walk through the fan.
void BM_ColourEchoes(benchmark::State& state) {
    const Scene scene = busyScene(0.0);
    const BeamAges ages = beamAges(scene, sectorOf(scene));
    const FanGeometry geometry = turnedGeometry(scene);
    EchoPainter painter;
    std::uint64_t serial = 0;
    for (auto each : state)
        painter.image(scene.fan, ++serial, ages, geometry, {}, Theme::Dusk, QRect(QPoint(), view_px), 1.0);
}

/// The same by OpenCV: steps of age are found once per pixel of the fan, levels and steps are warped, then coloured.
void BM_ColourEchoesByWarpAffine(benchmark::State& state) {
    constexpr int fade_steps = 32;
    const Scene scene = busyScene(0.0);
    const BeamAges ages = beamAges(scene, sectorOf(scene));
    const FanGeometry geometry = turnedGeometry(scene);
    const auto fanPoint = [&](double x, double y) {
        const Eigen::Vector2d place = geometry.toLocal({x + 0.5, y + 0.5});
        return cv::Point2d(scene.fan.columnOf(place.y()), scene.fan.rowOf(place.x()));
    };
    const cv::Point2d origin = fanPoint(0, 0);
    const cv::Point2d along_x = fanPoint(1, 0) - origin;
    const cv::Point2d along_y = fanPoint(0, 1) - origin;
    const cv::Matx23d map(along_x.x, along_y.x, origin.x, along_x.y, along_y.y, origin.y);
    std::vector<QRgb> table((fade_steps + 1) * 256, qRgb(1, 2, 3));
    const double scale = (fade_steps - 1) / (1000.0 * ages.oldest_s);
    const cv::Size size(view_px.width(), view_px.height());
    cv::Mat steps;
    cv::Mat warped_steps;
    cv::Mat levels;
    QImage image(view_px, QImage::Format_RGB32);
    for (auto each : state) {
        scene.fan.beam_time_ms.convertTo(steps, CV_8U, -scale, ages.newest_ms * scale);
        cv::min(steps, fade_steps - 1, steps);
        steps.setTo(fade_steps, scene.fan.beam_time_ms == FanImage::never_scanned);
        cv::warpAffine(scene.fan.levels, levels, map, size, cv::INTER_LINEAR | cv::WARP_INVERSE_MAP);
        cv::warpAffine(steps, warped_steps, map, size, cv::INTER_NEAREST | cv::WARP_INVERSE_MAP, cv::BORDER_CONSTANT,
                       cv::Scalar(fade_steps));
        for (int y = 0; y < size.height; ++y) {
            const auto* level = levels.ptr<std::uint8_t>(y);
            const auto* step = warped_steps.ptr<std::uint8_t>(y);
            auto* pixel = reinterpret_cast<QRgb*>(image.scanLine(y));
            for (int x = 0; x < size.width; ++x) pixel[x] = table[step[x] * 256U + level[x]];
        }
    }
}
BENCHMARK(BM_ColourEchoes)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK(BM_ColourEchoesByWarpAffine)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK(BM_EmptyFanFrame)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK(BM_BusyFanFrame)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK(BM_BusyFanFrameOfANewScene)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

}  // namespace
}  // namespace echotrail

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication app(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
