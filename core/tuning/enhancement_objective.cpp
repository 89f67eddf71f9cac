#include "core/tuning/enhancement_objective.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace echotrail {
namespace {

constexpr double published_edge = 0.2 * 255.0;  // in levels
constexpr double guarded_sigma_pixels = 2.0, guarded_edge_deviations = 5.0, speckle_cost = 3.0;
constexpr int speckle_window = 9;

cv::Mat scannedPixels(const FanImage& fan) { return fan.beam_time_ms != FanImage::never_scanned; }

/// Magnitudes of the gradient wherever all pixels of the 3×3 window were scanned.
std::vector<float> gradients(const cv::Mat& levels, const cv::Mat& scanned) {
    cv::Mat right, down, whole;
    cv::Sobel(levels, right, CV_32F, 1, 0);
    cv::Sobel(levels, down, CV_32F, 0, 1);
    cv::erode(scanned, whole, cv::Mat(), cv::Point(-1, -1), 1, cv::BORDER_CONSTANT, cv::Scalar(0));
    std::vector<float> magnitudes;
    for (int row = 0; row < levels.rows; ++row) {
        const auto *x = right.ptr<float>(row), *y = down.ptr<float>(row);
        const auto* counts = whole.ptr<std::uint8_t>(row);
        for (int column = 0; column < levels.cols; ++column)
            if (counts[column]) magnitudes.push_back(std::sqrt(x[column] * x[column] + y[column] * y[column]));
    }
    return magnitudes;
}

struct Edges {
    double sum = 0.0;  ///< of their gradients
    double number = 0.0;
};

Edges edgesAbove(const std::vector<float>& magnitudes, double threshold) {
    Edges edges;
    for (const float magnitude : magnitudes)
        if (magnitude > threshold) {
            edges.sum += magnitude;
            ++edges.number;
        }
    return edges;
}

double medianOf(std::vector<float>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

std::array<double, 256> histogramOf(const cv::Mat& levels, const cv::Mat& scanned) {
    std::array<double, 256> histogram{};
    for (int row = 0; row < levels.rows; ++row)
        for (int column = 0; column < levels.cols; ++column)
            if (scanned.at<std::uint8_t>(row, column)) ++histogram[levels.at<std::uint8_t>(row, column)];
    return histogram;
}

double totalOf(const std::array<double, 256>& histogram) {
    double total = 0;
    for (const double count : histogram) total += count;
    return total;
}

double entropyBits(const std::array<double, 256>& histogram, double total) {
    double entropy = 0;
    for (const double count : histogram)
        if (count > 0) entropy -= count / total * std::log2(count / total);
    return entropy;
}

/// The lowest level that at least this share of the pixels does not exceed.
double quantile(const std::array<double, 256>& histogram, double total, double share) {
    double below = 0;
    for (std::size_t level = 0; level < histogram.size(); ++level)
        if ((below += histogram[level]) >= share * total) return static_cast<double>(level);
    return 255.0;
}

/// Sums over a square window; in whole numbers below 2^24, so exact.
cv::Mat windowSums(const cv::Mat& values) {
    cv::Mat sums;
    cv::boxFilter(values, sums, CV_32F, {speckle_window, speckle_window}, {-1, -1}, false, cv::BORDER_CONSTANT);
    return sums;
}

std::vector<float> windowDeviations(const cv::Mat& levels, const cv::Mat& scanned) {
    cv::Mat level, one;
    scanned.convertTo(one, CV_32F, 1.0 / 255.0);
    levels.convertTo(level, CV_32F);
    level = level.mul(one);
    const cv::Mat counts = windowSums(one), sums = windowSums(level), squares = windowSums(level.mul(level));
    std::vector<float> deviations;
    for (int row = 0; row < levels.rows; ++row)
        for (int column = 0; column < levels.cols; ++column) {
            if (!scanned.at<std::uint8_t>(row, column)) continue;
            const float n = counts.at<float>(row, column), mean = sums.at<float>(row, column) / n;
            deviations.push_back(std::sqrt(std::max(squares.at<float>(row, column) / n - mean * mean, 0.0F)));
        }
    return deviations;
}

}  // namespace

double publishedObjective(const FanImage& enhanced) {
    if (enhanced.empty()) return 0.0;
    const cv::Mat scanned = scannedPixels(enhanced);
    const auto histogram = histogramOf(enhanced.levels, scanned);
    const double total = totalOf(histogram);
    const Edges edges = edgesAbove(gradients(enhanced.levels, scanned), published_edge);
    if (edges.number == 0) return 0.0;
    return std::log(std::log(edges.sum + std::numbers::e)) * edges.number / total * entropyBits(histogram, total);
}

double speckleOf(const FanImage& fan) {
    if (fan.empty()) return 0.0;
    const cv::Mat scanned = scannedPixels(fan);
    auto deviations = windowDeviations(fan.levels, scanned);
    if (deviations.empty()) return 0.0;
    const auto histogram = histogramOf(fan.levels, scanned);
    const double total = totalOf(histogram);
    const double contrast = quantile(histogram, total, 0.995) - quantile(histogram, total, 0.5);
    return medianOf(deviations) / std::max(contrast, 1.0);
}

double guardedObjective(const FanImage& plain, const FanImage& enhanced) {
    if (enhanced.empty()) return 0.0;
    const cv::Mat scanned = scannedPixels(enhanced);
    cv::Mat smooth;
    cv::GaussianBlur(enhanced.levels, smooth, {}, guarded_sigma_pixels, guarded_sigma_pixels, cv::BORDER_REPLICATE);
    const auto magnitudes = gradients(smooth, scanned);
    if (magnitudes.empty()) return 0.0;
    auto sorted = magnitudes;
    const auto median = static_cast<float>(medianOf(sorted));
    for (float& magnitude : sorted) magnitude = std::abs(magnitude - median);
    const Edges edges = edgesAbove(magnitudes, median + guarded_edge_deviations * medianOf(sorted));
    if (edges.number == 0) return 0.0;
    const auto histogram = histogramOf(enhanced.levels, scanned);
    const double total = totalOf(histogram), speckle = speckleOf(plain);
    const double worse = speckle > 0 ? std::max(speckleOf(enhanced) / speckle - 1.0, 0.0) : 0.0;
    return std::log(std::log(edges.sum + std::numbers::e) + 1.0) * edges.number / total *
           entropyBits(histogram, total) * std::exp(-speckle_cost * worse);
}

}  // namespace echotrail
