#pragma once

#include "ui/style/palette.hpp"

#include <QPainter>
#include <QPainterPath>

namespace echotrail {

/// A line on the fan: its dashes are lengths, not multiples of the width.
struct LineStyle {
    QColor colour;
    double width = 1.0;
    QList<double> dashes = {};  ///< drawn, gap, …; empty: solid

    QPen pen() const;
};

/// Draws a path twice: dark and wider first, so that it is seen on every echo level.
void strokeWithHalo(QPainter& painter, const QPainterPath& path, const LineStyle& style, const QColor& halo);

/// Text with a dark edge, its base line beginning at `place`.
void textWithHalo(QPainter& painter, QPointF place, const QString& text, const QColor& colour, const QColor& halo);

}  // namespace echotrail
