#include "ui/panels/alerts/alert_icon.hpp"

#include <QPainter>
#include <QPainterPath>

namespace echotrail {
namespace {

QPainterPath shapeOf(AlertPriority priority, const QRectF& box) {
    const auto at = [&](double x, double y) { return QPointF(box.x() + x * box.width(), box.y() + y * box.height()); };
    QPainterPath path;
    switch (priority) {
        case AlertPriority::Emergency:
            path.addPolygon(QPolygonF(
                {at(0.3, 0), at(0.7, 0), at(1, 0.3), at(1, 0.7), at(0.7, 1), at(0.3, 1), at(0, 0.7), at(0, 0.3)}));
            path.closeSubpath();
            break;
        case AlertPriority::Alarm:
            path.addPolygon(QPolygonF({at(0.5, 0), at(1, 0.95), at(0, 0.95)}));
            path.closeSubpath();
            break;
        case AlertPriority::Warning:
            path.addEllipse(box);
            break;
        case AlertPriority::Caution:
            path.addRect(
                box.adjusted(0.06 * box.width(), 0.06 * box.height(), -0.06 * box.width(), -0.06 * box.height()));
            break;
    }
    return path;
}

}  // namespace

void paintAlertIcon(QPainter& painter, const QRectF& box, AlertPriority priority, const QColor& ink,
                    const QColor& ground, bool filled) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const double stroke = box.width() / 9.0;
    painter.setPen(QPen(ink, stroke, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.setBrush(filled ? QBrush(ink) : QBrush(Qt::NoBrush));
    painter.drawPath(shapeOf(priority, box.adjusted(stroke / 2, stroke / 2, -stroke / 2, -stroke / 2)));
    painter.setPen(QPen(filled ? ground : ink, 1.2 * stroke, Qt::SolidLine, Qt::SquareCap));
    const double x = box.center().x();
    const double low = priority == AlertPriority::Alarm ? 0.08 * box.height() : 0.0;
    painter.drawLine(QPointF(x, box.top() + 0.30 * box.height() + low),
                     QPointF(x, box.top() + 0.52 * box.height() + low));
    painter.drawPoint(QPointF(x, box.top() + 0.73 * box.height() + low));
    painter.restore();
}

}  // namespace echotrail
