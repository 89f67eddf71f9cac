#include "core/imaging/local_enhancement.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <vector>

namespace echotrail {
namespace {

/// Sums over a column of the window; 31 × 31 squared levels fit.
struct ColumnSums {
    std::vector<std::int32_t> count, level, squared;

    explicit ColumnSums(int columns) : count(columns), level(columns), squared(columns) {}

    /// Takes in a row of the picture, or with `sign` -1 takes it out again.
    void add(const FanImage& fan, int row, std::int32_t sign) {
        const auto* levels = fan.levels.ptr<std::uint8_t>(row);
        const auto* times = fan.beam_time_ms.ptr<std::int32_t>(row);
        const int columns = fan.levels.cols;
        std::int32_t *counts = count.data(), *sums = level.data(), *squares = squared.data();
        for (int x = 0; x < columns; ++x) {
            const std::int32_t scanned = times[x] != FanImage::never_scanned ? sign : 0;
            counts[x] += scanned;
            sums[x] += scanned * levels[x];
            squares[x] += scanned * levels[x] * levels[x];
        }
    }
};

/// Mean and deviation of the scanned pixels in the window, in levels, along one row of the picture.
struct WindowStatistics {
    std::vector<float> mean, deviation;
    std::vector<std::int32_t> count, level, squared;

    explicit WindowStatistics(int columns)
        : mean(columns), deviation(columns), count(columns), level(columns), squared(columns) {}

    void compute(const ColumnSums& sums, int reach) {
        slide(sums.count, reach, count);
        slide(sums.level, reach, level);
        slide(sums.squared, reach, squared);
        for (std::size_t x = 0; x < mean.size(); ++x) {
            const float n = static_cast<float>(std::max(count[x], 1));
            const float m = static_cast<float>(level[x]) / n;
            mean[x] = m;
            deviation[x] = std::sqrt(std::max(static_cast<float>(squared[x]) / n - m * m, 0.0F));
        }
    }

private:
    static void slide(const std::vector<std::int32_t>& columns, int reach, std::vector<std::int32_t>& windows) {
        const int size = static_cast<int>(columns.size());
        std::int32_t sum = 0;
        for (int x = 0; x < std::min(reach, size); ++x) sum += columns[x];
        for (int x = 0; x < size; ++x) {
            if (x + reach < size) sum += columns[x + reach];
            windows[x] = sum;
            if (x >= reach) sum -= columns[x - reach];
        }
    }
};

/// m^a for means in 64ths of a level.
constexpr int power_steps = 64;
std::vector<float> powersOfMean(double exponent) {
    std::vector<float> powers(255 * power_steps + 1);
    for (std::size_t i = 0; i < powers.size(); ++i)
        powers[i] = static_cast<float>(std::pow(static_cast<double>(i) / (255.0 * power_steps), exponent));
    return powers;
}

/// D: the mean over the scanned pixels, in [0, 1]; 0 if there are none.
double fanMean(const FanImage& fan) {
    std::int64_t sum = 0, count = 0;
    for (int row = 0; row < fan.levels.rows; ++row) {
        const auto* levels = fan.levels.ptr<std::uint8_t>(row);
        const auto* times = fan.beam_time_ms.ptr<std::int32_t>(row);
        std::int32_t row_sum = 0, row_count = 0;
        for (int x = 0; x < fan.levels.cols; ++x) {
            const std::int32_t scanned = times[x] != FanImage::never_scanned;
            row_sum += scanned * levels[x];
            row_count += scanned;
        }
        sum += row_sum;
        count += row_count;
    }
    return count > 0 ? static_cast<double>(sum) / (255.0 * static_cast<double>(count)) : 0.0;
}

}  // namespace

FanImage enhanceLocally(const FanImage& fan, const LocalEnhancementParams& params) {
    assert(fan.levels.size() == fan.beam_time_ms.size());
    if (fan.empty()) return {};
    FanImage enhanced{cv::Mat(fan.levels.size(), CV_8U), fan.beam_time_ms, fan.pixel_m, fan.north_m, fan.east_m};
    const int rows = fan.levels.rows, columns = fan.levels.cols, reach = params.enhance_window_pixels / 2;
    const float gain = static_cast<float>(params.enhance_k * fanMean(fan));
    const float b = static_cast<float>(params.enhance_b), c = static_cast<float>(params.enhance_c);
    const std::vector<float> powers = powersOfMean(params.enhance_a);
    ColumnSums sums(columns);
    WindowStatistics window(columns);

    for (int row = 0; row < std::min(reach, rows); ++row) sums.add(fan, row, 1);
    for (int row = 0; row < rows; ++row) {
        if (row + reach < rows) sums.add(fan, row + reach, 1);
        if (row > reach) sums.add(fan, row - reach - 1, -1);
        window.compute(sums, reach);
        const auto* levels = fan.levels.ptr<std::uint8_t>(row);
        const auto* times = fan.beam_time_ms.ptr<std::int32_t>(row);
        auto* out = enhanced.levels.ptr<std::uint8_t>(row);
        for (int x = 0; x < columns; ++x) {
            const float f = static_cast<float>(levels[x]) / 255.0F, m = window.mean[x] / 255.0F;
            const float power = powers[static_cast<std::size_t>(window.mean[x] * power_steps + 0.5F)];
            const float g = gain / (window.deviation[x] / 255.0F + b) * (f - c * m) + power;
            const float level = std::min(std::max(g, 0.0F), 1.0F) * 255.0F + 0.5F;
            out[x] = times[x] == FanImage::never_scanned ? std::uint8_t{0} : static_cast<std::uint8_t>(level);
        }
    }
    return enhanced;
}

}  // namespace echotrail
