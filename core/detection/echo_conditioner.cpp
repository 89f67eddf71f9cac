#include "core/detection/echo_conditioner.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace echotrail {
namespace {

constexpr int coarse_step = 4;

/// Mean of the bins that fall into each cell; a bin belongs to the cell its centre lies in.
void poolBins(std::span<const std::uint8_t> bins, std::vector<std::uint32_t>& sums, std::vector<std::uint8_t>& cells) {
    const std::size_t n = bins.size();
    sums.resize(n + 1);
    sums[0] = 0;
    for (std::size_t i = 0; i < n; ++i) sums[i + 1] = sums[i] + bins[i];
    const std::size_t m = cells.size();
    std::size_t begin = 0;
    for (std::size_t cell = 0; cell < m; ++cell) {
        const std::size_t end = (cell + 1) * n / m;
        const auto count = static_cast<std::uint32_t>(end - begin);
        cells[cell] = static_cast<std::uint8_t>((sums[end] - sums[begin] + count / 2) / count);
        begin = end;
    }
}

/// Binomial weights 1 4 6 4 1: the Gaussian of 1 cell deviation; ends repeat.
void smoothAlong(std::span<const std::uint8_t> in, std::span<std::uint8_t> out) {
    const int n = static_cast<int>(in.size());
    const auto smoothed = [&](int i0, int i1, int i2, int i3, int i4) {
        return static_cast<std::uint8_t>((in[i0] + in[i4] + 4 * (in[i1] + in[i3]) + 6 * in[i2] + 8) / 16);
    };
    const auto clamped = [n](int i) { return std::clamp(i, 0, n - 1); };
    for (int i = 2; i + 2 < n; ++i) out[i] = smoothed(i - 2, i - 1, i, i + 1, i + 2);
    for (int i = 0; i < n; i = (i == 1 && n > 4) ? n - 2 : i + 1)
        out[i] = smoothed(clamped(i - 2), clamped(i - 1), i, clamped(i + 1), clamped(i + 2));
}

}  // namespace

void runningMedian(std::span<const std::uint8_t> values, int window, std::span<std::uint8_t> medians) {
    assert(window >= 1 && medians.size() == values.size());
    const int n = static_cast<int>(values.size());
    const int half = window / 2;
    std::array<int, 256> histogram{};
    int count = 0;  // values in the window
    int median = 0;
    int below = 0;  // values in the window that are less than `median`
    const auto add = [&](int i) {
        ++histogram[values[i]];
        ++count;
        below += values[i] < median;
    };
    const auto remove = [&](int i) {
        --histogram[values[i]];
        --count;
        below -= values[i] < median;
    };
    for (int i = 0; i < std::min(half, n); ++i) add(i);
    for (int i = 0; i < n; ++i) {
        if (i + half < n) add(i + half);
        if (i - half - 1 >= 0) remove(i - half - 1);
        const int rank = count / 2;  // the median is the value with `rank` values before it in order
        while (below > rank) below -= histogram[--median];
        while (below + histogram[median] <= rank) below += histogram[median++];
        medians[i] = static_cast<std::uint8_t>(median);
    }
}

void EchoConditioner::condition(const Ping& ping, EchoRow& row) {
    const std::size_t bins = ping.levels.size();
    const std::size_t cells = std::min<std::size_t>(bins, max_cells);
    row.cell_m = cells == 0 ? 0.0 : ping.binSize() * static_cast<double>(bins) / static_cast<double>(cells);
    row.level.resize(cells);
    row.smooth.resize(cells);
    row.background.resize(cells);
    if (cells == 0) return;
    poolBins(ping.levels, sums_, row.level);
    smoothAlong(row.level, row.smooth);

    coarse_.resize((cells + coarse_step - 1) / coarse_step);
    coarse_median_.resize(coarse_.size());
    for (std::size_t i = 0; i < coarse_.size(); ++i) {
        const std::size_t begin = i * coarse_step;
        const std::size_t end = std::min(begin + coarse_step, cells);
        int sum = 0;
        for (std::size_t k = begin; k < end; ++k) sum += row.level[k];
        coarse_[i] = static_cast<std::uint8_t>(sum / static_cast<int>(end - begin));
    }
    const int window = std::max(3, static_cast<int>(std::lround(params_.background_window_percent / 100.0 *
                                                                static_cast<double>(coarse_.size()))));
    runningMedian(coarse_, window, coarse_median_);
    for (std::size_t i = 0; i < cells; ++i) row.background[i] = coarse_median_[i / coarse_step];
    followRings(row);
}

void EchoConditioner::followRings(EchoRow& row) {
    const std::size_t cells = row.level.size();
    if (pings_ == 0 || ring_.size() != cells || ring_cell_m_ != row.cell_m) {
        ring_.assign(cells, 0);
        ring_cell_m_ = row.cell_m;
        pings_ = 0;
    }
    // Each ping draws the estimate towards itself by a bounded step: the value where as many pull up as down is
    // the median. The step starts wide, to settle within the first twenty pings.
    const int step = std::max(16 * 255 / (1 + 4 * pings_), 24);
    pings_ = std::min(pings_ + 1, 1'000);
    for (std::size_t i = 0; i < cells; ++i) {
        const int pull = std::clamp(16 * row.smooth[i] - ring_[i], -step, step);
        ring_[i] = static_cast<std::int16_t>(ring_[i] + pull);
    }
    if (!params_.remove_rings) return;
    for (std::size_t i = 0; i < cells; ++i) {
        const auto ring = static_cast<std::uint8_t>(ring_[i] / 16);
        row.background[i] = std::max(row.background[i], ring);
    }
}

}  // namespace echotrail
