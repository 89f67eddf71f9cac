#include "core/imaging/filters.hpp"

#include <opencv2/imgproc.hpp>

#include <array>
#include <cstdint>

namespace echotrail {
namespace {

constexpr int background_reduction = 4;
constexpr int background_window = 11;  // of the reduced picture

int medianLevel(const FanImage& fan) {
    std::array<int, 256> histogram{};
    int total = 0;
    for (int row = 0; row < fan.levels.rows; ++row) {
        const auto* levels = fan.levels.ptr<std::uint8_t>(row);
        const auto* times = fan.beam_time_ms.ptr<std::int32_t>(row);
        for (int column = 0; column < fan.levels.cols; ++column) {
            const bool scanned = times[column] != FanImage::never_scanned;
            histogram[levels[column]] += scanned;
            total += scanned;
        }
    }
    int level = 0;
    for (int below = histogram[0]; 2 * below < total; below += histogram[++level]) {
    }
    return level;
}

}  // namespace

void smoothGaussian(cv::Mat& levels, const GaussianParams& params) {
    if (levels.empty()) return;  // OpenCV would throw
    // OpenCV computes 8-bit pictures in fixed point: the same bytes on every machine.
    const int size = params.gaussian_size_pixels | 1;
    cv::GaussianBlur(levels, levels, cv::Size(size, size), params.gaussian_sigma_pixels, params.gaussian_sigma_pixels,
                     cv::BORDER_REPLICATE);
}

cv::Mat medianBackground(const FanImage& fan) {
    if (fan.empty()) return {};
    cv::Mat filled = fan.levels.clone(), small, background;
    filled.setTo(medianLevel(fan), fan.beam_time_ms == FanImage::never_scanned);
    const cv::Size reduced((filled.cols + background_reduction - 1) / background_reduction,
                           (filled.rows + background_reduction - 1) / background_reduction);
    cv::resize(filled, small, reduced, 0, 0, cv::INTER_AREA);
    cv::medianBlur(small, small, background_window);
    cv::resize(small, background, filled.size(), 0, 0, cv::INTER_NEAREST);
    return background;
}

}  // namespace echotrail
