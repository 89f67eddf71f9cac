#include "ui/views/chart_painter.hpp"

#include "ui/style/formatter.hpp"
#include "ui/views/halo.hpp"
#include "ui/views/symbol_painter.hpp"

#include <algorithm>
#include <cmath>

namespace echotrail {
namespace {

constexpr float guard_fill = 0.08F;  ///< opacities; the echoes stay readable below
constexpr float veto_hatch = 0.40F;
constexpr float veto_label = 0.95F;

QColor faded(QColor colour, float opacity) {
    colour.setAlphaF(opacity);
    return colour;
}

}  // namespace

QString measuredText(const Measurement& measurement, const FanGeometry& geometry, bool heading_known) {
    const Eigen::Vector2d leg = measurement.to - measurement.from;
    const Bearing from_north = Bearing::radians(std::atan2(leg.y(), leg.x()));
    QString text = Formatter::range(leg.norm());
    if (heading_known) text += "  " + Formatter::trueBearing(from_north);
    return text + "  " + Formatter::relativeBearing(Bearing::radians(from_north - geometry.heading));
}

void ChartPainter::label(QPointF place, const QString& text, const QColor& colour) {
    painter_.setFont(metrics_.sized(font_, 11.0));
    textWithHalo(painter_, place, text, colour, palette_.halo);
}

void ChartPainter::paintArea(const Area& area) {
    QPolygonF outline;
    for (const Eigen::Vector2f& corner : area.corners_m) outline << geometry_.toScreen(placeOf(area, corner, vehicle_));
    QPainterPath path;
    path.addPolygon(outline);
    path.closeSubpath();
    const bool guard = area.kind == Area::Kind::Guard;
    const QColor& colour = guard ? palette_.guard : palette_.graticule;
    painter_.fillPath(path,
                      guard ? QBrush(faded(colour, guard_fill)) : QBrush(faded(colour, veto_hatch), Qt::BDiagPattern));
    strokeWithHalo(painter_, path, {colour, px(guard ? 1.4 : 1.0)}, palette_.halo);
    SymbolPainter symbols(painter_, palette_, metrics_.scale());
    for (const QPointF& corner : outline) symbols.handle(corner, colour);
    // Above the topmost corner: the echoes inside are what the area is about.
    const auto top = std::min_element(outline.begin(), outline.end(),
                                      [](const QPointF& a, const QPointF& b) { return a.y() < b.y(); });
    const QString name = QString::fromStdString(area.name);
    painter_.setFont(metrics_.sized(font_, 11.0));
    const double width = QFontMetricsF(painter_.font(), painter_.device()).horizontalAdvance(name);
    label(*top - QPointF(width / 2.0, px(7.0)), name, faded(colour, veto_label));
}

void ChartPainter::paintAreas(const QList<Area>& areas, bool guard_zones, bool vetoes) {
    for (const bool guard : {false, true}) {
        if (!(guard ? guard_zones : vetoes)) continue;
        for (const Area& area : areas)
            if ((area.kind == Area::Kind::Guard) == guard) paintArea(area);
    }
}

void ChartPainter::paintMarks(const QList<Mark>& marks) {
    SymbolPainter symbols(painter_, palette_, metrics_.scale());
    for (const Mark& mark : marks) {
        const QPointF foot = geometry_.toScreen(mark.place_m);
        symbols.mark(foot);
        label(foot + QPointF(px(12.0), -px(6.0)), mark.label(), palette_.mark);
    }
}

void ChartPainter::paintMeasurement(const Measurement& measurement) {
    const QPointF from = geometry_.toScreen(measurement.from);
    const QPointF to = geometry_.toScreen(measurement.to);
    const double radius = px(3.0);
    QPainterPath path;
    for (const QPointF& end : {from, to}) path.addEllipse(end, radius, radius);
    const QPointF way = to - from;
    const double length = std::hypot(way.x(), way.y());
    if (length > 2.0 * radius) {  // the ends stay open circles
        path.moveTo(from + way * (radius / length));
        path.lineTo(to - way * (radius / length));
    }
    strokeWithHalo(painter_, path, {palette_.mark, px(1.3)}, palette_.halo);
    if (length > px(24.0)) {
        const QString text = Formatter::range((measurement.to - measurement.from).norm());
        label(to + QPointF(px(8.0), way.y() < 0.0 ? -px(6.0) : px(14.0)), text, palette_.mark);
    }
}

void ChartPainter::paintDraft(const AreaDraft& draft, const std::optional<QPointF>& hand) {
    const QColor& colour = draft.kind == Area::Kind::Guard ? palette_.guard : palette_.graticule;
    QPolygonF outline;
    for (const Eigen::Vector2d& corner : draft.corners_m) outline << geometry_.toScreen(corner);
    QPainterPath path;
    path.addPolygon(hand ? outline + QPolygonF{*hand} : outline);
    strokeWithHalo(painter_, path, {colour, px(1.4), {px(5.0), px(3.0)}}, palette_.halo);
    SymbolPainter symbols(painter_, palette_, metrics_.scale());
    for (const QPointF& corner : outline) symbols.handle(corner, colour);
}

}  // namespace echotrail
