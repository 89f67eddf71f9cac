#include "core/imaging/fan_projector.hpp"

#include "core/imaging/wedge_painter.hpp"

#include <algorithm>
#include <cmath>

namespace echotrail {
namespace {

constexpr double follow_share = 0.75;  // of the margin that the head may leave the middle by
// Pixels are counted from the local frame's origin in 32 bits; navigation beyond this is wrong anyway.
constexpr double farthest_origin_m = 1e6;

FanImage emptyImage(int top, int left, int size, double pixel) {
    return {cv::Mat(size, size, CV_8U, cv::Scalar(0)), cv::Mat(size, size, CV_32S, cv::Scalar(FanImage::never_scanned)),
            pixel, top * pixel, left * pixel};
}

/// Copies what both pictures show, of one pixel size.
void copyCommon(const FanImage& from, FanImage& to) {
    const int down = static_cast<int>(std::lround((from.north_m - to.north_m) / to.pixel_m));
    const int right = static_cast<int>(std::lround((to.east_m - from.east_m) / to.pixel_m));
    // The part of `from`, in its own rows and columns, that lies inside `to`.
    const cv::Rect inside =
        cv::Rect(0, 0, from.levels.cols, from.levels.rows) & cv::Rect(right, down, to.levels.cols, to.levels.rows);
    if (inside.empty()) return;
    const cv::Rect there(inside.x - right, inside.y - down, inside.width, inside.height);
    from.levels(inside).copyTo(to.levels(there));
    from.beam_time_ms(inside).copyTo(to.beam_time_ms(there));
}

/// The same at another pixel size: each new pixel takes over the old one nearest to it.
void resampleCommon(const FanImage& from, FanImage& to) {
    for (int row = 0; row < to.levels.rows; ++row) {
        const int from_row = static_cast<int>(std::lround(from.rowOf(to.northOf(row))));
        if (from_row < 0 || from_row >= from.levels.rows) continue;
        for (int column = 0; column < to.levels.cols; ++column) {
            const int from_column = static_cast<int>(std::lround(from.columnOf(to.eastOf(column))));
            if (from_column < 0 || from_column >= from.levels.cols) continue;
            to.levels.at<std::uint8_t>(row, column) = from.levels.at<std::uint8_t>(from_row, from_column);
            to.beam_time_ms.at<std::int32_t>(row, column) = from.beam_time_ms.at<std::int32_t>(from_row, from_column);
        }
    }
}

}  // namespace

void FanProjector::add(const Ray& ray, double range_scale_m, bool broke_off) {
    const bool placed = follow(ray, range_scale_m);
    if (placed && has_last_ && !broke_off)
        paintWedge(last_, ray, {0.0, std::max(ray.farEnd(), last_.farEnd())}, image_);
    last_levels_.assign(ray.levels.begin(), ray.levels.end());
    last_ = ray;
    last_.levels = last_levels_;
    has_last_ = placed;
}

void FanProjector::reset() {
    image_ = {};
    has_last_ = false;
}

/// Lays the picture about the head unless it still lies well. False where range or place make no sense.
bool FanProjector::follow(const Ray& ray, double range_scale_m) {
    const bool makes_sense = range_scale_m > 0.0 && range_scale_m < farthest_origin_m &&
                             std::abs(ray.origin_north_m) < farthest_origin_m &&
                             std::abs(ray.origin_east_m) < farthest_origin_m;
    if (!makes_sense) return false;
    const double pixel = range_scale_m / params_.fan_pixels_per_range;
    const double margin = std::min(params_.fan_margin_m, range_scale_m / 2.0);
    const int half = static_cast<int>(std::ceil((range_scale_m + margin) / pixel)), size = 2 * half + 1;
    const bool same_shape = image_.pixel_m == pixel && image_.levels.rows == size;
    const bool well_placed = std::abs(image_.rowOf(ray.origin_north_m) - half) * pixel <= follow_share * margin &&
                             std::abs(image_.columnOf(ray.origin_east_m) - half) * pixel <= follow_share * margin;
    if (same_shape && well_placed) return true;

    FanImage next = emptyImage(static_cast<int>(std::lround(ray.origin_north_m / pixel)) + half,
                               static_cast<int>(std::lround(ray.origin_east_m / pixel)) - half, size, pixel);
    if (image_.pixel_m == pixel)
        copyCommon(image_, next);
    else if (!image_.empty())
        resampleCommon(image_, next);
    image_ = next;
    return true;
}

}  // namespace echotrail
