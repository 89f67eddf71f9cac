#pragma once

#include "core/data/fan_image.hpp"
#include "core/imaging/echo_memory.hpp"
#include "ui/style/palette.hpp"
#include "ui/views/beam_schedule.hpp"
#include "ui/views/fan_settings.hpp"

#include <QImage>
#include <array>

namespace echotrail {

/// Turns a fan picture into pixels of the screen: turned and scaled with interpolated levels, then coloured, the
/// older the darker. Interpolating levels and not colours keeps every pixel on the colour map.
class EchoPainter {
public:
    /// An opaque picture of `box` (logical pixels); what was never scanned has the canvas' colour. Kept until an
    /// argument changes; `serial` names the fan's content
    /// and that of `trails`, which shine through where the echoes are darker; null: none.
    const QImage& image(const FanImage& fan, std::uint64_t serial, const BeamAges& ages, const FanGeometry& geometry,
                        const EchoSettings& settings, Theme theme, const QRect& box, double device_pixel_ratio,
                        const RememberedEchoes* trails = nullptr);

private:
    struct Key {
        std::uint64_t serial = 0;
        FanGeometry geometry;
        EchoSettings settings;
        Theme theme = Theme::Dusk;
        QRect box;
        double device_pixel_ratio = 0.0;
        bool trails = false;
        bool operator==(const Key&) const = default;
    };
    static constexpr int fade_steps = 32;

    void makeColours(const EchoSettings& settings, Theme theme);
    void colour(const FanImage& fan, const cv::Matx23d& map, const BeamAges& ages);
    void addTrails(const RememberedEchoes& trails, const BeamAges& ages, const FanGeometry& geometry, const QRect& box,
                   double device_pixel_ratio);

    Key key_;
    EchoSettings table_settings_;
    Theme table_theme_ = Theme::Dusk;
    bool has_table_ = false;
    std::array<std::array<QRgb, 256>, fade_steps + 1> table_{};  ///< by age, then level; the last: never scanned
    QRgb canvas_ = 0;
    cv::Mat times_;  ///< of trails
    QImage image_;
};

}  // namespace echotrail
