#pragma once

#include "ui/alerts/alert.hpp"

#include <QColor>
#include <QRectF>

class QPainter;

namespace echotrail {

/// The mark of a priority, each of its own shape so that hue is never the only sign: octagon, triangle, disc, square,
/// with an exclamation mark. `ink` is the colour of the mark; filled, it is cut out in `ground`.
void paintAlertIcon(QPainter& painter, const QRectF& box, AlertPriority priority, const QColor& ink,
                    const QColor& ground, bool filled);

}  // namespace echotrail
