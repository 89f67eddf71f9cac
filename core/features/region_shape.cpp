#include "core/features/region_shape.hpp"

#include "core/data/ping.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace echotrail {
namespace {

struct Box {
    int top, left, rows, columns;
};

Box boxOf(std::span<const RegionPixel> mask) {
    const auto [top, bottom] =
        std::minmax_element(mask.begin(), mask.end(), [](auto& a, auto& b) { return a.row < b.row; });
    const auto [left, right] =
        std::minmax_element(mask.begin(), mask.end(), [](auto& a, auto& b) { return a.column < b.column; });
    return {top->row, left->column, bottom->row - top->row + 1, right->column - left->column + 1};
}

/// Second central moments of the mask in pixels².
struct SecondMoments {
    double row_row = 0, row_column = 0, column_column = 0;
};

SecondMoments secondMoments(std::span<const RegionPixel> mask) {
    std::int64_t rows = 0, columns = 0, rr = 0, rc = 0, cc = 0;
    const int top = mask.front().row, left = mask.front().column;  // an origin nearby keeps the sums small and exact
    for (const RegionPixel& pixel : mask) {
        const std::int64_t r = pixel.row - top, c = pixel.column - left;
        rows += r;
        columns += c;
        rr += r * r;
        rc += r * c;
        cc += c * c;
    }
    const auto n = static_cast<double>(mask.size());
    const double mean_row = static_cast<double>(rows) / n, mean_column = static_cast<double>(columns) / n;
    return {static_cast<double>(rr) / n - mean_row * mean_row, static_cast<double>(rc) / n - mean_row * mean_column,
            static_cast<double>(cc) / n - mean_column * mean_column};
}

/// Hu's second invariant (η20 − η02)² + 4 η11², where η = μ / μ00² = (second moment per pixel) / (number of pixels).
double secondInvariant(const SecondMoments& m, std::size_t pixels) {
    const auto n = static_cast<double>(pixels);
    const double difference = (m.column_column - m.row_row) / n, mixed = m.row_column / n;
    return difference * difference + 4.0 * mixed * mixed;
}

std::vector<Eigen::Vector2f> outlineOf(std::span<const RegionPixel> mask, const FanImage& picture) {
    const Box box = boxOf(mask);
    cv::Mat image(box.rows, box.columns, CV_8U, cv::Scalar(0));
    for (const RegionPixel& pixel : mask) image.at<std::uint8_t>(pixel.row - box.top, pixel.column - box.left) = 1;
    std::vector<std::vector<cv::Point>> contours;
    cv::findContours(image, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_SIMPLE);
    const auto longest = std::max_element(contours.begin(), contours.end(),
                                          [](const auto& a, const auto& b) { return a.size() < b.size(); });
    std::vector<Eigen::Vector2f> outline;
    for (const cv::Point& point : *longest)
        outline.emplace_back(static_cast<float>(picture.northOf(box.top + point.y)),
                             static_cast<float>(picture.eastOf(box.left + point.x)));
    return outline;
}

/// Of an excess in levels.
std::array<double, 256> amplitudeTable() {
    std::array<double, 256> table{};
    for (std::size_t level = 0; level < table.size(); ++level)
        table[level] = std::pow(10.0, static_cast<double>(level) / levels_per_db / 20.0);
    return table;
}

}  // namespace

std::array<double, 7> huInvariants(std::span<const RegionPixel> mask) {
    assert(!mask.empty());
    const Box box = boxOf(mask);
    cv::Mat image(box.rows, box.columns, CV_8U, cv::Scalar(0));
    for (const RegionPixel& pixel : mask) image.at<std::uint8_t>(pixel.row - box.top, pixel.column - box.left) = 1;
    std::array<double, 7> invariants{};
    cv::HuMoments(cv::moments(image, true), invariants.data());
    return invariants;
}

double momentFeature(double m2) { return std::log10(m2 + 1e-3); }

Region measureRegion(const RegionPixels& region, const FanImage& picture, Timestamp epoch,
                     const RegionShapeParams& params) {
    assert(!region.pixels.empty());
    static const std::array<double, 256> amplitudes = amplitudeTable();
    Region measured;
    double weight = 0, row = 0, column = 0, time_ms = 0, levels = 0;
    int clipped = 0, excess = 0;
    for (const RegionPixel& pixel : region.pixels) {
        const int stands_out = std::clamp<int>(pixel.excess, 1, 255);
        const double w = params.centroid == CentroidWeight::Amplitude ? amplitudes[stands_out] : stands_out;
        weight += w;
        row += w * pixel.row;
        column += w * pixel.column;
        const std::int32_t beam_time = picture.beam_time_ms.at<std::int32_t>(pixel.row, pixel.column);
        time_ms += w * beam_time;
        levels += pixel.level;
        clipped += pixel.level == 255;
        excess = std::max<int>(excess, pixel.excess);
    }
    const auto n = static_cast<double>(region.pixels.size());
    measured.position_m = {picture.northOf(row / weight), picture.eastOf(column / weight)};
    measured.time = epoch + Microseconds(std::llround(time_ms / weight * 1e3));
    measured.features.area_m2 = n * picture.pixel_m * picture.pixel_m;
    measured.features.moment = momentFeature(secondInvariant(secondMoments(region.pixels), region.pixels.size()));
    measured.peak_db = region.peak.level / levels_per_db;
    measured.mean_db = levels / n / levels_per_db;
    measured.features.level_db = measured.peak_db;
    measured.contrast_db = measured.features.strength_db = excess / levels_per_db;
    measured.pixels = static_cast<int>(region.pixels.size());
    measured.clipped_fraction = clipped / n;
    measured.clutter_mass = region.clutter_mass;
    measured.outline_m = outlineOf(region.pixels, picture);
    return measured;
}

void seenFromHead(Region& region, const RegionPixels& pixels, const FanImage& picture, const Pose& head) {
    const double north = region.position_m.x() - head.north_m, east = region.position_m.y() - head.east_m;
    region.head = head;
    region.range_m = std::hypot(north, east);
    const double azimuth = std::atan2(east, north);
    region.bearing = Bearing::radians(azimuth - head.heading.inRadians());
    // Rows run south and columns east; turn the second moments into the line of sight and across it.
    const SecondMoments m = secondMoments(pixels.pixels);
    const double c = std::cos(azimuth), s = std::sin(azimuth);
    const double nn = m.row_row, ee = m.column_column, ne = -m.row_column;
    const double pixel_variance = 1.0 / 12.0;  // of a pixel's own extent
    const double along = c * c * nn + 2 * c * s * ne + s * s * ee + pixel_variance;
    const double across = s * s * nn - 2 * c * s * ne + c * c * ee + pixel_variance;
    region.features.along_range_m = 4.0 * std::sqrt(along) * picture.pixel_m;
    region.features.across_range_m = 4.0 * std::sqrt(across) * picture.pixel_m;
}

}  // namespace echotrail
