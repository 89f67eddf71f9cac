#include "ui/views/halo.hpp"

#include <array>

namespace echotrail {

QPen LineStyle::pen() const {
    QPen pen(colour, width, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
    if (!dashes.isEmpty()) {
        QList<double> pattern;
        for (const double length : dashes) pattern << length / width;
        pen.setDashPattern(pattern);
    }
    return pen;
}

void strokeWithHalo(QPainter& painter, const QPainterPath& path, const LineStyle& style, const QColor& halo) {
    LineStyle under = style;
    under.colour = halo;
    under.width += 2.0;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(under.pen());
    painter.drawPath(path);
    painter.setPen(style.pen());
    painter.drawPath(path);
}

void textWithHalo(QPainter& painter, QPointF place, const QString& text, const QColor& colour, const QColor& halo) {
    // Shifted copies stay as sharp as the text itself, and come from the glyph cache.
    static constexpr std::array<std::pair<int, int>, 8> edge{
        {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};
    painter.setPen(halo);
    for (const auto& [dx, dy] : edge) painter.drawText(place + QPointF(dx, dy), text);
    painter.setPen(colour);
    painter.drawText(place, text);
}

}  // namespace echotrail
