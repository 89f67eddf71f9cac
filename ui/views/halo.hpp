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

/// Draws a path, and dark and wider below it its halo, so that it is seen on every echo level.
void strokeWithHalo(QPainter& painter, const QPainterPath& path, const LineStyle& style, const QColor& halo);

/// Discs of one colour.
void fillDots(QPainter& painter, const QList<QPointF>& places, double radius, const QColor& colour);

/// Text, its base line beginning at `place`. Its picture is kept: most texts are the same in the next frame, and to
/// lay one out takes longer than to copy it.
void keptText(QPainter& painter, QPointF place, const QString& text, const QColor& colour);

/// How wide a text is on the painter's device, kept likewise.
double keptWidth(const QPainter& painter, const QFont& font, const QString& text);

/// The same as keptText() with a dark edge.
void textWithHalo(QPainter& painter, QPointF place, const QString& text, const QColor& colour, const QColor& halo);

}  // namespace echotrail
