#include "core/imaging/fan_projector.hpp"

#include "core/imaging/wedge_painter.hpp"

#include <cmath>

namespace echotrail {
namespace {

constexpr double margin_m = 10.0;        // of the picture around the range circle
constexpr double recentre_share = 0.75;  // of the margin, before the picture follows

}  // namespace

void FanProjector::add(const Ray& ray, double range_scale_m, bool broke_off) {
    follow(ray, range_scale_m);
    if (has_last_ && !broke_off) {
        const double length = ray.bin_size_m * static_cast<double>(ray.levels.size());
        paintWedge(last_, ray, {0.0, length}, image_);
    }
    last_ = ray;
    last_levels_.assign(ray.levels.begin(), ray.levels.end());
    last_.levels = last_levels_;
    has_last_ = true;
}

/// Keeps the head in the middle part of the picture. What is still inside stays, at another scale if need be.
void FanProjector::follow(const Ray& ray, double range_scale_m) {
    const double pixel = range_scale_m / params_.pixels_per_range;
    if (!(pixel > 0)) return;
    const int size = 2 * static_cast<int>(std::ceil((range_scale_m + margin_m) / pixel)) + 1;
    const double centre_north = image_.northOf(image_.levels.rows / 2),
                 centre_east = image_.eastOf(image_.levels.cols / 2);
    const bool fits = !image_.empty() && image_.pixel_m == pixel && image_.levels.rows == size &&
                      std::abs(ray.origin_m.x() - centre_north) < recentre_share * margin_m &&
                      std::abs(ray.origin_m.y() - centre_east) < recentre_share * margin_m;
    if (fits) return;
    FanImage next{cv::Mat::zeros(size, size, CV_8U), cv::Mat(size, size, CV_32S, cv::Scalar(FanImage::never_scanned)),
                  pixel, (std::floor(ray.origin_m.x() / pixel) + size / 2) * pixel,
                  (std::floor(ray.origin_m.y() / pixel) - size / 2) * pixel};
    for (int row = 0; row < size && !image_.empty(); ++row) {
        const auto from_row = std::lround(image_.rowOf(next.northOf(row)));
        if (from_row < 0 || from_row >= image_.levels.rows) continue;
        for (int column = 0; column < size; ++column) {
            const auto from_column = std::lround(image_.columnOf(next.eastOf(column)));
            if (from_column < 0 || from_column >= image_.levels.cols) continue;
            const auto r = static_cast<int>(from_row), c = static_cast<int>(from_column);
            next.levels.at<std::uint8_t>(row, column) = image_.levels.at<std::uint8_t>(r, c);
            next.beam_time_ms.at<std::int32_t>(row, column) = image_.beam_time_ms.at<std::int32_t>(r, c);
        }
    }
    image_ = next;
}

}  // namespace echotrail
