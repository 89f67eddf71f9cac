#pragma once

#include "ui/style/palette.hpp"
#include "ui/style/ui_metrics.hpp"
#include "ui/views/fan_settings.hpp"

#include <QPainter>

namespace echotrail {

/// A piece of a badge's line, in one look.
struct BadgeText {
    QString text;
    QColor colour;
    bool bold = false;
};
using BadgeLine = QList<BadgeText>;

enum class BadgeCorner { TopLeft, TopRight, BottomLeft };

/// Boxes with a few words in the corners of the fan.
class BadgePainter {
public:
    BadgePainter(QPainter& painter, const QRectF& view, const Palette& palette, const QFont& font)
        : painter_(painter),
          view_(view),
          palette_(palette),
          font_(font),
          metrics_(font),
          plain_(metrics_.sized(font, UiMetrics::base_pixel_size)),
          bold_(metrics_.sized(font, UiMetrics::base_pixel_size, true)) {}

    /// The box that was filled.
    QRectF paint(BadgeCorner corner, const QList<BadgeLine>& lines);
    /// The colour map with its decibels and the points that are black and white, standing on `foot` (y).
    QRectF paintLegend(const EchoSettings& settings, Theme theme, double foot);

private:
    double px(double at_base) const { return metrics_.length(at_base); }
    void ground(const QRectF& box);

    QPainter& painter_;
    QRectF view_;
    const Palette& palette_;
    QFont font_;
    UiMetrics metrics_;
    QFont plain_, bold_;
};

}  // namespace echotrail
