// What forming and smoothing the picture costs, each beside the library's own way in the same run.
// A turn of 200 (or 400) echo lines of 800 bins at 50 m range, seen from a moving and yawing vehicle.
#include "core/base/random.hpp"
#include "core/imaging/fan_projector.hpp"
#include "core/imaging/filters.hpp"
#include "core/imaging/local_enhancement.hpp"
#include "core/imaging/wedge_painter.hpp"

#include <benchmark/benchmark.h>
#include <opencv2/imgproc.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace echotrail {
namespace {

constexpr double range_m = 50.0;
constexpr int bins = 800, side = 961;  // pixels of the tile: 2 R + 20 m

struct Turn {
    std::vector<std::vector<std::uint8_t>> levels;
    std::vector<Ray> rays;

    explicit Turn(double step_deg) {
        const int count = static_cast<int>(std::lround(360.0 / step_deg)) + 1;
        levels.resize(count, std::vector<std::uint8_t>(bins));
        for (int k = 0; k < count; ++k) {
            RandomStream random(1, 2, k);
            for (auto& level : levels[k]) level = static_cast<std::uint8_t>(random.bits() & 0x7F);
            const double seconds = 0.07 * k;
            rays.push_back({.origin_north_m = 0.1 * seconds,
                            .origin_east_m = 0.03 * seconds,
                            .drift_north = 0.1 / 1500.0,
                            .drift_east = 0.03 / 1500.0,
                            .azimuth_rad = wrapRadians(radiansFromDegrees(k * (step_deg + 0.07))),
                            .turn_rad_per_m = radiansFromDegrees(1.0) / 1500.0,
                            .head_bearing = Bearing::degrees(k * step_deg),
                            .step_rad = radiansFromDegrees(step_deg),
                            .bin_size_m = range_m / bins,
                            .time_ms = 70 * k,
                            .levels = levels[k]});
        }
    }
};

FanImage emptyTile() {
    constexpr double pixel = 0.125;
    return {cv::Mat::zeros(side, side, CV_8U), cv::Mat(side, side, CV_32S, cv::Scalar(FanImage::never_scanned)), pixel,
            (side / 2) * pixel, -(side / 2) * pixel};
}

FanImage paintedTile(const Turn& turn) {
    FanImage tile = emptyTile();
    for (std::size_t k = 1; k < turn.rays.size(); ++k) paintWedge(turn.rays[k - 1], turn.rays[k], {0, range_m}, tile);
    return tile;
}

void wedgePerPing(benchmark::State& state) {
    const Turn turn(static_cast<double>(state.range(0)) / 100.0);
    FanImage tile = emptyTile();
    std::size_t k = 1;
    for (auto _ : state) {
        paintWedge(turn.rays[k - 1], turn.rays[k], {0, range_m}, tile);
        if (++k == turn.rays.size()) k = 1;
    }
    const int pixels = cv::countNonZero(paintedTile(turn).beam_time_ms != FanImage::never_scanned);
    state.counters["pixels_per_ping"] = static_cast<double>(pixels) / static_cast<double>(turn.rays.size() - 1);
}
BENCHMARK(wedgePerPing)->ArgName("step_centideg")->Arg(180)->Arg(90)->Arg(45);

void wedgeOfAPatch(benchmark::State& state) {  // as detection paints it: 10 m of range
    const Turn turn(1.8);
    FanImage tile = emptyTile();
    std::size_t k = 1;
    for (auto _ : state) {
        paintWedge(turn.rays[k - 1], turn.rays[k], {20, 30}, tile);
        if (++k == turn.rays.size()) k = 1;
    }
}
BENCHMARK(wedgeOfAPatch);

void projectorPerPing(benchmark::State& state) {
    const Turn turn(1.8);
    FanProjector projector({});
    std::size_t k = 0;
    for (auto _ : state) {
        projector.add(turn.rays[k], range_m, k == 0);
        if (++k == turn.rays.size()) k = 0;
    }
}
BENCHMARK(projectorPerPing);

void wholeFanByWedges(benchmark::State& state) {
    const Turn turn(0.9);
    FanImage tile = emptyTile();
    for (auto _ : state)
        for (std::size_t k = 1; k < turn.rays.size(); ++k)
            paintWedge(turn.rays[k - 1], turn.rays[k], {0, range_m}, tile);
}
BENCHMARK(wholeFanByWedges)->Unit(benchmark::kMicrosecond);

/// One row per beam, as remap and warpPolar want it; the vehicle must then stand still.
cv::Mat polarPicture(const Turn& turn) {
    cv::Mat polar(static_cast<int>(turn.levels.size()) - 1, bins, CV_8U);
    for (int k = 0; k < polar.rows; ++k)
        cv::Mat(1, bins, CV_8U, const_cast<std::uint8_t*>(turn.levels[k].data())).copyTo(polar.row(k));
    return polar;
}

void wholeFanByRemap(benchmark::State& state) {
    cv::setNumThreads(1);
    const cv::Mat polar = polarPicture(Turn(0.9));
    cv::Mat bin(side, side, CV_32F), beam(side, side, CV_32F), map, weights, out;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const double north = (side / 2 - row) * 0.125, east = (column - side / 2) * 0.125;
            bin.at<float>(row, column) = static_cast<float>(std::hypot(north, east) / range_m * bins - 0.5);
            const double turns = std::atan2(east, north) / (2 * std::numbers::pi);
            beam.at<float>(row, column) = static_cast<float>((turns < 0 ? turns + 1 : turns) * polar.rows);
        }
    cv::convertMaps(bin, beam, map, weights, CV_16SC2);
    for (auto _ : state) cv::remap(polar, out, map, weights, cv::INTER_LINEAR, cv::BORDER_CONSTANT);
}
BENCHMARK(wholeFanByRemap)->Unit(benchmark::kMicrosecond);

void wholeFanByWarpPolar(benchmark::State& state) {
    cv::setNumThreads(1);
    const cv::Mat polar = polarPicture(Turn(0.9));
    cv::Mat out;
    for (auto _ : state)
        cv::warpPolar(polar, out, cv::Size(side, side), cv::Point2f(side / 2.0F, side / 2.0F), 400.0,
                      cv::INTER_LINEAR | cv::WARP_INVERSE_MAP);
}
BENCHMARK(wholeFanByWarpPolar)->Unit(benchmark::kMicrosecond);

/// The plain alternative to the library's blur: binomial weights 1 4 6 4 1, rows then columns, in 16 bits.
void binomialBlur(const cv::Mat& in, cv::Mat& out, std::vector<std::uint16_t>& between) {
    const int rows = in.rows, columns = in.cols;
    between.resize(static_cast<std::size_t>(rows) * columns);
    for (int row = 0; row < rows; ++row) {
        const auto* v = in.ptr<std::uint8_t>(row);
        std::uint16_t* sums = between.data() + static_cast<std::size_t>(row) * columns;
        for (int x = 2; x < columns - 2; ++x)
            sums[x] = static_cast<std::uint16_t>(v[x - 2] + v[x + 2] + 4 * (v[x - 1] + v[x + 1]) + 6 * v[x]);
    }
    for (int row = 2; row < rows - 2; ++row) {
        const std::uint16_t* s = between.data() + static_cast<std::size_t>(row) * columns;
        auto* o = out.ptr<std::uint8_t>(row);
        for (int x = 2; x < columns - 2; ++x)
            o[x] = static_cast<std::uint8_t>(
                (s[x - 2 * columns] + s[x + 2 * columns] + 4 * (s[x - columns] + s[x + columns]) + 6 * s[x] + 128) >>
                8);
    }
}

void smoothByBinomial(benchmark::State& state) {
    const cv::Mat levels = paintedTile(Turn(1.8)).levels;
    cv::Mat out = levels.clone();
    std::vector<std::uint16_t> between;
    for (auto _ : state) binomialBlur(levels, out, between);
}
BENCHMARK(smoothByBinomial)->Unit(benchmark::kMicrosecond);

void smoothGaussianOfFan(benchmark::State& state) {
    cv::setNumThreads(1);
    cv::Mat levels = paintedTile(Turn(1.8)).levels;
    for (auto _ : state) smoothGaussian(levels);
}
BENCHMARK(smoothGaussianOfFan)->Unit(benchmark::kMicrosecond);

void smoothGaussianOfPatch(benchmark::State& state) {  // as detection smooths it
    cv::setNumThreads(1);
    cv::Mat levels = paintedTile(Turn(1.8)).levels(cv::Rect(500, 500, 48, 48)).clone();
    for (auto _ : state) smoothGaussian(levels);
}
BENCHMARK(smoothGaussianOfPatch)->Unit(benchmark::kMicrosecond);

void enhanceFan(benchmark::State& state) {
    const FanImage fan = paintedTile(Turn(1.8));
    for (auto _ : state) benchmark::DoNotOptimize(enhanceLocally(fan, {}));
}
BENCHMARK(enhanceFan)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace echotrail
