#pragma once

#include <QColor>
#include <QPainter>
#include <QPointF>
#include <vector>

namespace echotrail {

/// A straight piece of a line, in device pixels. Where it goes on, the joint is round; else it is cut off square. One
/// without length that goes on is a dot.
struct StrokeLeg {
    QPointF from;
    QPointF to;
    bool goes_on_before = false;
    bool goes_on_after = false;
    double opacity = 1.0;  ///< of a line without a halo
};

/// Half the breadth of a line and of the halo about it, in device pixels, and their colours.
struct StrokeInk {
    double line_half = 0.5;
    double halo_half = 0.0;
    QColor line;
    QColor halo;
};

/// Paints legs as one shape: each pixel is covered by how near it lies to the nearest leg, which is as smooth as a
/// path's area for lines a few pixels wide, and many times faster: a fan of targets has hundreds of them. What lies
/// over itself counts once. The painter's transformation is not applied, its clip is.
void paintStroke(QPainter& painter, const std::vector<StrokeLeg>& legs, const StrokeInk& ink);

}  // namespace echotrail
