#include "ui/views/echo_painter.hpp"

#include "core/data/ping.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace echotrail {
namespace {

constexpr QSize size(300, 200);
constexpr int side = 60;  ///< of the fan, pixels of 1 m

/// Noise, in the west never scanned, in the east by one beam.
FanImage noisyFan() {
    FanImage fan;
    fan.pixel_m = 1.0;
    fan.north_m = 30.0;
    fan.east_m = -30.0;
    fan.levels.create(side, side, CV_8U);
    cv::RNG(1).fill(fan.levels, cv::RNG::UNIFORM, 0, 256);
    fan.beam_time_ms = cv::Mat(side, side, CV_32S, cv::Scalar(FanImage::never_scanned));
    fan.beam_time_ms.colRange(side / 2, side) = 1000;
    return fan;
}

FanGeometry turned(double degrees) {
    FanGeometry geometry;
    geometry.head_px = {150.0, 100.0};
    geometry.up = Bearing::degrees(degrees);
    geometry.px_per_m = 4.3;
    return geometry;
}

/// Everything that a level can show: 0 is the map's first colour, 255 its last.
EchoSettings wholeScale() {
    EchoSettings settings;
    settings.black_db = 0.0;
    settings.white_db = full_scale_db;
    return settings;
}

double interpolated(const FanImage& fan, double row, double column) {
    const int top = static_cast<int>(row);
    const int left = static_cast<int>(column);
    const auto level = [&](int y, int x) { return double(fan.levels.at<std::uint8_t>(y, x)); };
    const double right = column - left;
    const double above = level(top, left) * (1.0 - right) + level(top, left + 1) * right;
    const double below = level(top + 1, left) * (1.0 - right) + level(top + 1, left + 1) * right;
    return above + (below - above) * (row - top);
}

class EchoPicture : public testing::TestWithParam<double> {
protected:
    QImage painted(const BeamAges& ages) {
        return painter_.image(fan_, ++serial_, ages, geometry_, wholeScale(), Theme::Dusk, QRect(QPoint(), size), 1.0);
    }
    /// Calls `visit(row, column, x, y)` for every pixel that shows the fan, but for its edges.
    void forEachPixel(const auto& visit) const {
        for (int y = 0; y < size.height(); ++y)
            for (int x = 0; x < size.width(); ++x) {
                const Eigen::Vector2d place = geometry_.toLocal({x + 0.5, y + 0.5});
                const double row = fan_.rowOf(place.x());
                const double column = fan_.columnOf(place.y());
                if (std::min(row, column) > 0.1 && std::max(row, column) < side - 1.1) visit(row, column, x, y);
            }
    }

    FanImage fan_ = noisyFan();
    FanGeometry geometry_ = turned(GetParam());
    EchoPainter painter_;
    std::uint64_t serial_ = 0;
};

TEST_P(EchoPicture, ShowsTheLevelsBetweenThePixelsOfTheFan) {
    const QImage picture = painted({1000, 3.0, {}});
    const EchoColours& colours = echoColours(EchoMap::Grey, Theme::Dusk);
    int seen = 0;
    forEachPixel([&](double row, double column, int x, int y) {
        if (column < side / 2) return;
        const double level = interpolated(fan_, row, column);
        const auto grey = [&](double off) {
            return qGray(colours[static_cast<std::size_t>(std::clamp(std::lround(level + off), 0L, 255L))]);
        };
        ++seen;
        const int shown = qGray(picture.pixel(x, y));
        EXPECT_TRUE(shown >= grey(-2.5) && shown <= grey(2.5)) << x << " " << y << ": " << shown << ", " << level;
    });
    EXPECT_GT(seen, 10'000);
}

TEST_P(EchoPicture, HasTheCanvasWhereNothingWasScanned) {
    const QImage picture = painted({1000, 3.0, {}});
    const QRgb canvas = paletteOf(Theme::Dusk).canvas.rgb();
    forEachPixel([&](double, double column, int x, int y) {
        if (column < side / 2 - 0.6) {
            EXPECT_EQ(picture.pixel(x, y), canvas) << x << " " << y;
        }
    });
}

TEST_P(EchoPicture, IsDarkerTheLongerAgoTheBeamWasThere) {
    const QImage fresh = painted({1000, 3.0, {}});
    const QImage old = painted({4000, 3.0, {}});
    forEachPixel([&](double, double column, int x, int y) {
        if (column < side / 2) return;
        EXPECT_NEAR(qGray(old.pixel(x, y)), (1.0 - most_fade) * qGray(fresh.pixel(x, y)), 1.5) << x << " " << y;
    });
}

INSTANTIATE_TEST_SUITE_P(Turned, EchoPicture, testing::Values(0.0, 20.0, 90.0, 217.0));

}  // namespace
}  // namespace echotrail
