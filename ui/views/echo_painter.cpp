#include "ui/views/echo_painter.hpp"

#include "core/data/ping.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

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

/// A place in the fan, and the way from one pixel of the screen to the next.
struct Walk {
    std::int32_t column, row;
    std::int32_t column_step, row_step;

    Walk(const cv::Matx23d& map, int x, int y)
        : column(fixedPlace(map(0, 0) * x + map(0, 1) * y + map(0, 2))),
          row(fixedPlace(map(1, 0) * x + map(1, 1) * y + map(1, 2))),
          column_step(fixedPlace(map(0, 0))),
          row_step(fixedPlace(map(1, 0))) {}
    void advance(int pixels) {
        column += pixels * column_step;
        row += pixels * row_step;
    }
};

/// Ages in steps of the colour table.
struct AgeScale {
    std::int32_t newest_ms;
    float steps_per_ms;
    std::int32_t last_step;

    std::int32_t stepOf(std::int32_t time_ms) const {
        const float steps = static_cast<float>(std::max(newest_ms - time_ms, 0)) * steps_per_ms;
        const auto step = static_cast<std::int32_t>(std::min(steps, static_cast<float>(last_step)));
        return time_ms == FanImage::never_scanned ? last_step + 1 : step;
    }
};

/// A few pixels of a row, taken through one step after the other: what only calculates comes to vector instructions,
/// what only fetches to little else.
class RowBatch {
public:
    static constexpr int most = 128;

    RowBatch(const Walk& walk, int count) : walk_(walk), count_(count) {}

    /// When the beam was at the nearest pixels of the fan. Returns whether it was at any of them.
    bool fetchTimes(const cv::Mat& times) {
        findPlaces(half_place, static_cast<int>(times.step1()));
        const auto* from = times.ptr<std::int32_t>();
        static_assert(FanImage::never_scanned == -1);
        std::int32_t any = -1;  // all bits, which stay only if each has them all
        for (int i = 0; i < count_; ++i) {
            times_[i] = from[places_[i]];
            any &= times_[i];
        }
        return any != FanImage::never_scanned;
    }
    /// The levels of the four pixels about each place, which is not on the last row or column.
    void fetchLevels(const cv::Mat& levels) {
        const auto stride = static_cast<int>(levels.step1());
        findPlaces(0, stride);
        const auto* from = levels.ptr<std::uint8_t>();
        static_assert(std::endian::native == std::endian::little);
        for (int i = 0; i < count_; ++i) {
            std::memcpy(&above_[i], from + places_[i], sizeof(above_[i]));
            std::memcpy(&below_[i], from + places_[i] + stride, sizeof(below_[i]));
        }
    }
    /// Interpolates between the four, in 16 bits: those are multiplied at once on any processor.
    void findLevels() {
        const auto between = [](int first, int second, int share) {
            return static_cast<std::uint16_t>(first * (256 - share) + second * share + 128) >> 8;
        };
        const auto column = static_cast<std::uint16_t>(walk_.column);
        const auto row = static_cast<std::uint16_t>(walk_.row);
        const auto column_step = static_cast<std::uint16_t>(walk_.column_step);
        const auto row_step = static_cast<std::uint16_t>(walk_.row_step);
        for (std::uint16_t i = 0; i < count_; ++i) {
            const int right = static_cast<std::uint16_t>(column + i * column_step) >> 8;
            const int lower = static_cast<std::uint16_t>(row + i * row_step) >> 8;
            const int above = between(above_[i] & 255, above_[i] >> 8, right);
            const int below = between(below_[i] & 255, below_[i] >> 8, right);
            levels_[i] = static_cast<std::uint16_t>(between(above, below, lower));
        }
    }
    /// Entries of a colour table of 256 levels per step of age.
    void findColours(const AgeScale& ages) {
        for (int i = 0; i < count_; ++i) places_[i] = ages.stepOf(times_[i]) * 256 + levels_[i];
    }
    /// `pixel` is no part of the table.
    void paint(QRgb* __restrict pixel, const QRgb* table) const {
        for (int i = 0; i < count_; ++i) pixel[i] = table[places_[i]];
    }

private:
    void findPlaces(std::int32_t rounding, int stride) {
        for (int i = 0; i < count_; ++i)
            places_[i] = ((walk_.row + i * walk_.row_step + rounding) >> place_bits) * stride +
                         ((walk_.column + i * walk_.column_step + rounding) >> place_bits);
    }

    Walk walk_;
    int count_;
    std::array<std::int32_t, most> places_;  ///< first of pixels of the fan, then of colours in the table
    std::array<std::int32_t, most> times_;
    std::array<std::uint16_t, most> above_;  ///< two levels each, the left one first
    std::array<std::uint16_t, most> below_;
    std::array<std::uint16_t, most> levels_;
};

}  // namespace

void EchoPainter::makeColours(const EchoSettings& settings, Theme theme) {
    if (has_table_ && table_settings_ == settings && table_theme_ == theme) return;
    table_settings_ = settings;
    table_theme_ = theme;
    has_table_ = true;
    canvas_ = paletteOf(theme).canvas.rgb();
    const EchoColours& map = echoColours(settings.map, theme);
    const double span_db = std::max(settings.white_db - settings.black_db, 0.1);
    table_[fade_steps].fill(canvas_);
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
    const AgeScale scale{ages.newest_ms, static_cast<float>((fade_steps - 1) / std::max(1.0, 1000.0 * ages.oldest_s)),
                         fade_steps - 1};
    constexpr double within = 0.05;  // of a pixel: more than steps in fixed point add up to
    for (int y = 0; y < image_.height(); ++y) {
        RowPart part{0, image_.width()};
        part.keep(map(0, 1) * y + map(0, 2) - within, map(0, 0), fan.levels.cols - 1 - 2.0 * within);
        part.keep(map(1, 1) * y + map(1, 2) - within, map(1, 0), fan.levels.rows - 1 - 2.0 * within);
        auto* pixel = reinterpret_cast<QRgb*>(image_.scanLine(y));
        std::fill(pixel, pixel + part.from, canvas_);
        std::fill(pixel + part.to, pixel + image_.width(), canvas_);
        Walk walk(map, part.from, y);
        for (int x = part.from; x < part.to; x += RowBatch::most) {
            const int count = std::min(RowBatch::most, part.to - x);
            RowBatch batch(walk, count);
            walk.advance(count);
            if (!batch.fetchTimes(fan.beam_time_ms)) {
                std::fill(pixel + x, pixel + x + count, canvas_);
                continue;
            }
            batch.fetchLevels(fan.levels);
            batch.findLevels();
            batch.findColours(scale);
            batch.paint(pixel + x, table_.front().data());
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
