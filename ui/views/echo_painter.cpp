#include "ui/views/echo_painter.hpp"

#include "core/data/ping.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace echotrail {
namespace {

constexpr double brightest_trail = 0.65;  ///< of the tracks' colour

/// From device pixels of the picture to columns and rows of the fan, as cv::warpAffine takes it.
cv::Matx23d screenToFan(const auto& fan, const FanGeometry& geometry, const QRect& box, double ratio) {
    const auto fanPoint = [&](double x, double y) {
        // The middle of device pixel (x, y) is half a pixel further on.
        const QPointF logical(box.x() + (x + 0.5) / ratio, box.y() + (y + 0.5) / ratio);
        const Eigen::Vector2d place = geometry.toLocal(logical);
        return cv::Point2d((place.y() - fan.east_m) / fan.pixel_m, (fan.north_m - place.x()) / fan.pixel_m);
    };
    const cv::Point2d origin = fanPoint(0, 0);
    const cv::Point2d along_x = fanPoint(1, 0) - origin;
    const cv::Point2d along_y = fanPoint(0, 1) - origin;
    return {along_x.x, along_y.x, origin.x, along_x.y, along_y.y, origin.y};
}

// Places in a fan are counted in 1/65 536 of a pixel.
constexpr int place_bits = 16;
constexpr std::int32_t half_place = 1 << (place_bits - 1);

std::int32_t fixedPlace(double value) { return static_cast<std::int32_t>(std::lround(value * (1 << place_bits))); }

/// Pixels [from, to) of a row.
struct RowPart {
    int from = 0;
    int to = 0;

    /// Only where 0 ≤ place + step · x ≤ last.
    void keep(double place, double step, double last) {
        double first_x = -place / step;
        double last_x = (last - place) / step;
        if (step == 0.0) {
            if (place < 0.0 || place > last) to = from;
            return;
        }
        if (step < 0.0) std::swap(first_x, last_x);
        from = static_cast<int>(std::clamp(std::ceil(first_x), double(from), double(to)));
        to = static_cast<int>(std::clamp(std::floor(last_x) + 1.0, double(from), double(to)));
    }
};

/// Interpolated between the four pixels about a place that is not on the last row or column. Its level, 0…255.
int levelAt(const std::uint8_t* levels, int stride, std::int32_t column, std::int32_t row) {
    constexpr int whole = 256;
    const auto* above = levels + (row >> place_bits) * stride + (column >> place_bits);
    const auto* below = above + stride;
    const int right = (column >> (place_bits - 8)) & (whole - 1);
    const int lower = (row >> (place_bits - 8)) & (whole - 1);
    const int on_top = above[0] * (whole - right) + above[1] * right;
    const int beneath = below[0] * (whole - right) + below[1] * right;
    return (on_top * (whole - lower) + beneath * lower + whole * whole / 2) / (whole * whole);
}

}  // namespace

void EchoPainter::makeColours(const EchoSettings& settings, Theme theme) {
    if (has_table_ && table_settings_ == settings && table_theme_ == theme) return;
    table_settings_ = settings;
    table_theme_ = theme;
    has_table_ = true;
    canvas_ = paletteOf(theme).canvas.rgb();
    const EchoColours& map = echoColours(settings.map, theme);
    const double span_db = std::max(settings.white_db - settings.black_db, 0.1);
    for (int step = 0; step < fade_steps; ++step) {
        const double light = 1.0 - std::clamp(settings.fade, 0.0, most_fade) * step / (fade_steps - 1);
        const auto dimmed = [&](int channel) { return static_cast<int>(std::lround(channel * light)); };
        for (int level = 0; level < 256; ++level) {
            const double share = std::clamp((level / levels_per_db - settings.black_db) / span_db, 0.0, 1.0);
            const QRgb full = map[static_cast<std::size_t>(std::lround(share * 255.0))];
            table_[static_cast<std::size_t>(step)][static_cast<std::size_t>(level)] =
                qRgb(dimmed(qRed(full)), dimmed(qGreen(full)), dimmed(qBlue(full)));
        }
    }
}

void EchoPainter::colour(const FanImage& fan, const cv::Matx23d& map, const BeamAges& ages) {
    // Ages in fixed point: a step is so many 1/1024 of a millisecond.
    const double oldest_ms = std::max(1.0, 1000.0 * ages.oldest_s);
    const auto scale = static_cast<std::int64_t>((fade_steps - 1) * 1024.0 * 1024.0 / oldest_ms);
    const auto colourOf = [&](std::int32_t time_ms, int level) {
        const std::int64_t step = (std::max(ages.newest_ms - time_ms, 0) * scale) >> 20;
        return table_[static_cast<std::size_t>(std::min<std::int64_t>(step, fade_steps - 1))]
                     [static_cast<std::size_t>(level)];
    };
    const auto* levels = fan.levels.ptr<std::uint8_t>();
    const auto* times = fan.beam_time_ms.ptr<std::int32_t>();
    const auto levels_stride = static_cast<int>(fan.levels.step1());
    const auto times_stride = static_cast<int>(fan.beam_time_ms.step1());
    constexpr double within = 0.05;  // of a pixel: more than steps in fixed point add up to
    image_.fill(canvas_);
    for (int y = 0; y < image_.height(); ++y) {
        const double first_column = map(0, 1) * y + map(0, 2);
        const double first_row = map(1, 1) * y + map(1, 2);
        RowPart part{0, image_.width()};
        part.keep(first_column - within, map(0, 0), fan.levels.cols - 1 - 2.0 * within);
        part.keep(first_row - within, map(1, 0), fan.levels.rows - 1 - 2.0 * within);
        auto* pixel = reinterpret_cast<QRgb*>(image_.scanLine(y));
        std::int32_t column = fixedPlace(first_column + map(0, 0) * part.from);
        std::int32_t row = fixedPlace(first_row + map(1, 0) * part.from);
        const std::int32_t column_step = fixedPlace(map(0, 0));
        const std::int32_t row_step = fixedPlace(map(1, 0));
        for (int x = part.from; x < part.to; ++x, column += column_step, row += row_step) {
            const std::int32_t time_ms =
                times[((row + half_place) >> place_bits) * times_stride + ((column + half_place) >> place_bits)];
            if (time_ms != FanImage::never_scanned)
                pixel[x] = colourOf(time_ms, levelAt(levels, levels_stride, column, row));
        }
    }
}

/// The brighter of echo and trail, channel by channel: an echo is never dimmed by what was there before it.
void EchoPainter::addTrails(const RememberedEchoes& trails, const BeamAges& ages, const FanGeometry& geometry,
                            const QRect& box, double device_pixel_ratio) {
    const cv::Matx23d map = screenToFan(trails, geometry, box, device_pixel_ratio);
    cv::warpAffine(trails.trail_time_ms, times_, map, {image_.width(), image_.height()},
                   cv::INTER_NEAREST | cv::WARP_INVERSE_MAP, cv::BORDER_CONSTANT, cv::Scalar(FanImage::never_scanned));
    const QColor& full = paletteOf(table_theme_).track;
    for (int y = 0; y < times_.rows; ++y) {
        const auto* time = times_.ptr<std::int32_t>(y);
        auto* pixel = reinterpret_cast<QRgb*>(image_.scanLine(y));
        for (int x = 0; x < times_.cols; ++x) {
            if (time[x] == FanImage::never_scanned) continue;
            const double age_s = (ages.newest_ms - time[x]) / 1000.0;
            const double light = brightest_trail * std::clamp(1.0 - age_s / trail_s, 0.0, 1.0);
            const auto lit = [&](int echo, int trail) { return std::max(echo, static_cast<int>(light * trail)); };
            pixel[x] = qRgb(lit(qRed(pixel[x]), full.red()), lit(qGreen(pixel[x]), full.green()),
                            lit(qBlue(pixel[x]), full.blue()));
        }
    }
}

const QImage& EchoPainter::image(const FanImage& fan, std::uint64_t serial, const BeamAges& ages,
                                 const FanGeometry& geometry, const EchoSettings& settings, Theme theme,
                                 const QRect& box, double device_pixel_ratio, const RememberedEchoes* trails) {
    Key key{serial, geometry, settings, theme, box, device_pixel_ratio, trails != nullptr};
    if (!image_.isNull() && key == key_) return image_;
    key_ = std::move(key);
    makeColours(settings, theme);
    const QSize size(static_cast<int>(std::ceil(box.width() * device_pixel_ratio)),
                     static_cast<int>(std::ceil(box.height() * device_pixel_ratio)));
    if (image_.size() != size) image_ = QImage(size, QImage::Format_RGB32);
    image_.setDevicePixelRatio(device_pixel_ratio);
    if (fan.empty() || fan.levels.cols < 2 || fan.levels.rows < 2 || size.isEmpty()) {
        image_.fill(canvas_);
        return image_;
    }
    colour(fan, screenToFan(fan, geometry, box, device_pixel_ratio), ages);
    if (trails) addTrails(*trails, ages, geometry, box, device_pixel_ratio);
    return image_;
}

}  // namespace echotrail
