#include "ui/views/badge_painter.hpp"

#include "core/data/ping.hpp"
#include "ui/style/formatter.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace echotrail {

void BadgePainter::ground(const QRectF& box) {
    QColor fill = palette_.canvas;
    fill.setAlphaF(0.85F);
    painter_.setRenderHint(QPainter::Antialiasing, false);
    painter_.fillRect(box, fill);
    QColor edge = palette_.graticule;
    edge.setAlphaF(0.45F);
    painter_.setPen(QPen(edge, 1.0));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawRect(box);
    painter_.setRenderHint(QPainter::Antialiasing);
}

double BadgePainter::widthOf(const BadgeLine& line) const {
    double width = 0.0;
    for (const BadgeText& part : line)
        width += QFontMetricsF(fontOf(part), painter_.device()).horizontalAdvance(part.text);
    return width;
}

QRectF BadgePainter::paint(BadgeCorner corner, const QList<BadgeLine>& lines) {
    const QFontMetricsF font(fontOf({}), painter_.device());
    double width = 0.0;
    for (const BadgeLine& line : lines) width = std::max(width, widthOf(line));
    const double pad = px(8.0);
    const QSizeF size(std::ceil(width + 2.0 * pad), std::ceil(font.height() * static_cast<double>(lines.size()) + pad));
    const double edge = px(8.0);
    const double x = corner == BadgeCorner::TopRight ? view_.right() - edge - size.width() : view_.left() + edge;
    const double y = corner == BadgeCorner::BottomLeft ? view_.bottom() - edge - size.height() : view_.top() + edge;
    const QRectF box(std::floor(x), std::floor(y), size.width(), size.height());
    ground(box);
    for (qsizetype i = 0; i < lines.size(); ++i) {
        double at = corner == BadgeCorner::TopRight ? box.right() - pad - widthOf(lines[i]) : box.x() + pad;
        for (const BadgeText& part : lines[i]) {
            painter_.setFont(fontOf(part));
            painter_.setPen(part.colour);
            painter_.drawText(QPointF(at, box.y() + pad / 2.0 + font.height() * static_cast<double>(i) + font.ascent()),
                              part.text);
            at += QFontMetricsF(fontOf(part), painter_.device()).horizontalAdvance(part.text);
        }
    }
    return box;
}

QRectF BadgePainter::paintLegend(const EchoSettings& settings, Theme theme, double foot) {
    const QFont small = metrics_.sized(font_, 10.0);
    const QFontMetricsF font(small, painter_.device());
    const double pad = px(8.0);
    const QSizeF bar_size(px(190.0), px(9.0));
    const double marks = px(5.0);  // room for the black and white points above the bar
    const QSizeF size(bar_size.width() + 2.0 * pad + px(6.0),
                      pad + marks + bar_size.height() + px(4.0) + font.height() + pad / 2.0);
    const QRectF box(std::floor(view_.left() + px(8.0)), std::floor(foot - size.height()), std::ceil(size.width()),
                     std::ceil(size.height()));
    ground(box);
    const QRectF bar(QPointF(box.x() + pad, box.y() + pad / 2.0 + marks), bar_size);
    const EchoColours& map = echoColours(settings.map, theme);
    const double span_db = std::max(settings.white_db - settings.black_db, 0.1);
    const auto xOf = [&](double db) { return bar.x() + bar.width() * std::clamp(db / full_scale_db, 0.0, 1.0); };
    const int columns = static_cast<int>(bar.width());
    for (int i = 0; i < columns; ++i) {
        const double db = full_scale_db * (i + 0.5) / columns;
        const double share = std::clamp((db - settings.black_db) / span_db, 0.0, 1.0);
        painter_.fillRect(QRectF(bar.x() + i, bar.y(), 1.0, bar.height()),
                          QColor(map[static_cast<std::size_t>(std::lround(share * 255.0))]));
    }
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(palette_.mark);
    for (const double db : {settings.black_db, settings.white_db}) {
        const double x = xOf(db);
        const std::array point{QPointF(x - marks * 0.7, bar.y() - marks), QPointF(x + marks * 0.7, bar.y() - marks),
                               QPointF(x, bar.y())};
        painter_.drawPolygon(point.data(), static_cast<int>(point.size()));
    }
    painter_.setFont(small);
    painter_.setPen(palette_.graticule);
    for (int db = 0; db <= 80; db += 20) {
        const QString text = db == 80 ? Formatter::withUnit(db, 0, "dB") : Formatter::number(db, 0);
        const double x = xOf(db);
        painter_.drawLine(QPointF(x, bar.bottom()), QPointF(x, bar.bottom() + px(3.0)));
        const double left = std::clamp(x - font.horizontalAdvance(text) / 2.0, bar.x(),
                                       box.right() - px(4.0) - font.horizontalAdvance(text));
        painter_.drawText(QPointF(left, bar.bottom() + px(3.0) + font.ascent()), text);
    }
    return box;
}

}  // namespace echotrail
