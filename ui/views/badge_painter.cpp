#include "ui/views/badge_painter.hpp"

#include "core/data/ping.hpp"
#include "ui/style/formatter.hpp"
#include "ui/views/halo.hpp"

#include <QImage>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace echotrail {

void BadgePainter::ground(const QRectF& box) {
    QColor fill = palette_.canvas;
    fill.setAlphaF(0.85F);
    painter_.setRenderHint(QPainter::Antialiasing, false);
    painter_.fillRect(box, fill);
    QColor edge = palette_.graticule;
    edge.setAlphaF(0.45F);
    // For the outline of a rectangle Qt wakes other threads, which costs more than to fill its sides.
    const QRectF outer = box.adjusted(-0.5, -0.5, 0.5, 0.5);
    const QSizeF along(outer.width(), 1.0);
    const QSizeF down(1.0, outer.height() - 2.0);
    for (const QRectF& side :
         {QRectF(outer.topLeft(), along), QRectF(outer.bottomLeft() - QPointF(0.0, 1.0), along),
          QRectF(outer.topLeft() + QPointF(0.0, 1.0), down), QRectF(outer.topRight() + QPointF(-1.0, 1.0), down)})
        painter_.fillRect(side, edge);
    painter_.setRenderHint(QPainter::Antialiasing);
}

QRectF BadgePainter::paint(BadgeCorner corner, const QList<BadgeLine>& lines) {
    const QFontMetricsF font(plain_, painter_.device());
    QList<QList<double>> widths;  // of each part
    double width = 0.0;
    for (const BadgeLine& line : lines) {
        widths.emplaceBack();
        for (const BadgeText& part : line) widths.back() << keptWidth(painter_, part.bold ? bold_ : plain_, part.text);
        width = std::max(width, std::accumulate(widths.back().begin(), widths.back().end(), 0.0));
    }
    const double pad = px(8.0);
    const QSizeF size(std::ceil(width + 2.0 * pad), std::ceil(font.height() * static_cast<double>(lines.size()) + pad));
    const double edge = px(8.0);
    const double x = corner == BadgeCorner::TopRight ? view_.right() - edge - size.width() : view_.left() + edge;
    const double y = corner == BadgeCorner::BottomLeft ? view_.bottom() - edge - size.height() : view_.top() + edge;
    const QRectF box(std::floor(x), std::floor(y), size.width(), size.height());
    ground(box);
    for (qsizetype i = 0; i < lines.size(); ++i) {
        const double line_width = std::accumulate(widths[i].begin(), widths[i].end(), 0.0);
        double at = corner == BadgeCorner::TopRight ? box.right() - pad - line_width : box.x() + pad;
        const double base = box.y() + pad / 2.0 + font.height() * static_cast<double>(i) + font.ascent();
        for (qsizetype part = 0; part < lines[i].size(); ++part) {
            painter_.setFont(lines[i][part].bold ? bold_ : plain_);
            keptText(painter_, QPointF(at, base), lines[i][part].text, lines[i][part].colour);
            at += widths[i][part];
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
    QImage colours(static_cast<int>(bar.width()), 1, QImage::Format_RGB32);
    for (int i = 0; i < colours.width(); ++i) {
        const double db = full_scale_db * (i + 0.5) / colours.width();
        const double share = std::clamp((db - settings.black_db) / span_db, 0.0, 1.0);
        colours.setPixel(i, 0, map[static_cast<std::size_t>(std::lround(share * 255.0))]);
    }
    painter_.drawImage(QRectF(bar.topLeft(), QSizeF(colours.width(), bar.height())), colours);
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
        const double width = keptWidth(painter_, small, text);
        const double left = std::clamp(x - width / 2.0, bar.x(), box.right() - px(4.0) - width);
        keptText(painter_, QPointF(left, bar.bottom() + px(3.0) + font.ascent()), text, palette_.graticule);
    }
    return box;
}

}  // namespace echotrail
