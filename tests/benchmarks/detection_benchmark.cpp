// Region growing on a 1024² fan, beside the library's labelling of the same mask in the same run.
#include "core/base/random.hpp"
#include "core/data/ping.hpp"
#include "core/detection/region_grower.hpp"

#include <benchmark/benchmark.h>
#include <opencv2/imgproc.hpp>

#include <cmath>

namespace echotrail {
namespace {

constexpr int size = 1024, targets = 29;

/// A smooth noisy fan with 29 targets 25 dB above it.
FanImage fan() {
    RandomStream random(1, 0, 0);
    cv::Mat levels(size, size, CV_8U);
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column)
            levels.at<std::uint8_t>(row, column) = static_cast<std::uint8_t>(
                std::clamp((20 + 10 * std::log10(-std::log(random.uniform()))) * levels_per_db, 0.0, 255.0));
    for (int i = 0; i < targets; ++i) {
        const cv::Point centre(static_cast<int>(40 + random.uniform() * (size - 80)),
                               static_cast<int>(40 + random.uniform() * (size - 80)));
        cv::ellipse(levels, centre, {14, 6}, 30.0 * i, 0, 360, cv::Scalar(std::round(45 * levels_per_db)), cv::FILLED);
    }
    cv::GaussianBlur(levels, levels, {5, 5}, 1.0);
    return {levels, cv::Mat(size, size, CV_32S, cv::Scalar(0)), 0.125, 0, 0};
}

const cv::Mat background(size, size, CV_8U, cv::Scalar(std::round(18 * levels_per_db)));

void growRegions(benchmark::State& state) {
    cv::setNumThreads(1);
    const FanImage picture = fan();
    RegionGrower grower(RegionGrowerParams{});
    std::size_t regions = 0;
    for (auto _ : state)
        regions = grower(picture, background, static_cast<int>(std::lround(12 * levels_per_db))).size();
    state.counters["regions"] = static_cast<double>(regions);
}
BENCHMARK(growRegions)->Unit(benchmark::kMicrosecond);

void connectedComponentsWithStats(benchmark::State& state) {
    cv::setNumThreads(1);
    const FanImage picture = fan();
    const cv::Mat mask = picture.levels - background > std::round(12 * levels_per_db);
    cv::Mat labels, stats, centroids;
    int count = 0;
    for (auto _ : state) count = cv::connectedComponentsWithStats(mask, labels, stats, centroids, 8);
    state.counters["regions"] = count - 1;
}
BENCHMARK(connectedComponentsWithStats)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace echotrail
