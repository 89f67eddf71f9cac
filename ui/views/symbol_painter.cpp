#include "ui/views/symbol_painter.hpp"

#include "ui/views/halo.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace echotrail {
namespace {

constexpr double symbol_line = 1.6;

QPointF polar(double angle, double radius) { return {radius * std::sin(angle), -radius * std::cos(angle)}; }

QRectF around(QPointF centre, double radius) {
    return {centre.x() - radius, centre.y() - radius, 2.0 * radius, 2.0 * radius};
}

/// The four corners of a square, open in between.
QPainterPath brackets(QPointF centre, double half, double corner) {
    QPainterPath path;
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0}) {
            const QPointF tip = centre + QPointF(x * half, y * half);
            path.moveTo(tip - QPointF(x * corner, 0));
            path.lineTo(tip);
            path.lineTo(tip - QPointF(0, y * corner));
        }
    return path;
}

QPainterPath circle(QPointF centre, double radius) {
    QPainterPath path;
    path.addEllipse(centre, radius, radius);
    return path;
}

/// A circle with a gap of 70° in the direction `angle`.
QPainterPath gappedCircle(QPointF centre, double radius, double angle) {
    constexpr double gap_deg = 70.0;
    const double start =
        90.0 - angle * 180.0 / std::numbers::pi + gap_deg / 2.0;  // Qt counts from 3 o'clock, turning left
    QPainterPath path;
    path.arcMoveTo(around(centre, radius), start);
    path.arcTo(around(centre, radius), start, 360.0 - gap_deg);
    return path;
}

}  // namespace

QColor SymbolPainter::colourOf(TrackState state) const {
    return state == TrackState::Lost ? palette_.danger : palette_.track;
}

void SymbolPainter::target(QPointF centre, const TargetSymbol& symbol) {
    const double radius = px(symbol.state == TrackState::Tentative ? steady_radius + 1.0 : steady_radius);
    QPainterPath shape;
    LineStyle style{colourOf(symbol.state), px(symbol_line)};
    switch (symbol.state) {
        case TrackState::Tentative:
            shape = circle(centre, radius);
            // Eight dashes whatever the radius, the gaps somewhat shorter.
            style.dashes = {radius * std::numbers::pi / 4.0 * 0.58, radius * std::numbers::pi / 4.0 * 0.42};
            break;
        case TrackState::Confirmed:
            shape = circle(centre, radius);
            if (symbol.motion_angle && symbol.vector_px > 0.0) {
                shape.moveTo(centre + polar(*symbol.motion_angle, radius));
                shape.lineTo(centre + polar(*symbol.motion_angle, radius + symbol.vector_px));
            }
            break;
        case TrackState::Coasting:
            shape = gappedCircle(centre, radius, symbol.motion_angle.value_or(0.0));
            break;
        case TrackState::Lost: {
            shape = circle(centre, radius);
            const double reach = radius * 0.7 + px(5.0);
            for (const double side : {-1.0, 1.0}) {
                shape.moveTo(centre + QPointF(-reach, -side * reach));
                shape.lineTo(centre + QPointF(reach, side * reach));
            }
            break;
        }
    }
    strokeWithHalo(painter_, shape, style, palette_.halo);
    const double frame = radius + px(5.0);
    if (symbol.designated) {
        strokeWithHalo(painter_, brackets(centre, frame, px(6.0)), {colourOf(symbol.state), px(symbol_line)},
                       palette_.halo);
    } else if (symbol.selected) {
        QPainterPath square;
        square.addRect(around(centre, frame));
        strokeWithHalo(painter_, square, {palette_.mark, px(1.0)}, palette_.halo);
    }
}

void SymbolPainter::ownShip(QPointF centre, double angle) {
    QPainterPath hull;
    hull.moveTo(centre + polar(angle, px(10.0)));
    hull.lineTo(centre + polar(angle + 2.55, px(10.0)));
    hull.lineTo(centre + polar(angle + std::numbers::pi, px(4.0)));
    hull.lineTo(centre + polar(angle - 2.55, px(10.0)));
    hull.closeSubpath();
    strokeWithHalo(painter_, hull, {palette_.mark, px(symbol_line)}, palette_.halo);
}

void SymbolPainter::nextLookCross(QPointF centre) {
    const double reach = px(4.0);
    QPainterPath cross;
    cross.moveTo(centre - QPointF(reach, 0));
    cross.lineTo(centre + QPointF(reach, 0));
    cross.moveTo(centre - QPointF(0, reach));
    cross.lineTo(centre + QPointF(0, reach));
    strokeWithHalo(painter_, cross, {palette_.track, px(symbol_line)}, palette_.halo);
}

void SymbolPainter::cursorCross(QPointF centre) {
    QPainterPath cross;
    for (const QPointF arm : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
        cross.moveTo(centre + arm * px(4.0));
        cross.lineTo(centre + arm * px(11.0));
    }
    strokeWithHalo(painter_, cross, {palette_.mark, px(1.2)}, palette_.halo);
}

void SymbolPainter::mark(QPointF foot) {
    QPainterPath flag(foot);
    flag.lineTo(foot - QPointF(0, px(14.0)));
    flag.lineTo(foot + QPointF(px(10.0), -px(10.5)));
    flag.lineTo(foot - QPointF(0, px(7.0)));
    strokeWithHalo(painter_, flag, {palette_.mark, px(symbol_line)}, palette_.halo);
}

void SymbolPainter::handle(QPointF centre, const QColor& colour) {
    QPainterPath square;
    square.addRect(around(centre, px(2.5)));
    painter_.fillPath(square, palette_.canvas);
    strokeWithHalo(painter_, square, {colour, px(1.2)}, palette_.halo);
}

void SymbolPainter::layer(const QRectF& box, LayerSymbol symbol) {
    const QPointF centre = box.center();
    const double half = std::min(box.width(), box.height()) * 0.32;
    const auto at = [&](double x, double y) { return centre + QPointF(x * half, y * half); };
    const auto line = [&](const QColor& colour, QList<double> dashes = {}) {
        for (double& dash : dashes) dash *= scale_;
        return LineStyle{colour, px(1.2), dashes};
    };
    painter_.save();
    painter_.setRenderHint(QPainter::Antialiasing);
    painter_.fillRect(box, palette_.canvas);
    QPainterPath path;
    switch (symbol) {
        case LayerSymbol::Echo: {
            QColor grey = palette_.mark;
            grey.setAlphaF(0.45F);
            painter_.fillRect(around(centre, half), grey);
            break;
        }
        case LayerSymbol::RegionKept:
        case LayerSymbol::RegionDropped: {
            const std::array outline{at(-1.2, 0.6), at(-1.0, -0.2), at(-0.3, -0.5),
                                     at(0.3, -0.8), at(1.0, -0.2),  at(1.2, 0.6)};
            path.addPolygon(QPolygonF(QList<QPointF>(outline.begin(), outline.end())));
            path.closeSubpath();
            strokeWithHalo(
                painter_, path,
                line(palette_.region, symbol == LayerSymbol::RegionKept ? QList<double>{} : QList<double>{2.0, 2.0}),
                palette_.halo);
            break;
        }
        case LayerSymbol::Particles: {
            painter_.setPen(QPen(palette_.track, px(1.5)));
            for (int i = 0; i < 14; ++i)
                painter_.drawPoint(at(1.1 * std::sin(i * 2.4) * i / 14.0, 1.1 * std::cos(i * 2.4) * i / 14.0));
            break;
        }
        case LayerSymbol::Track: {
            SymbolPainter small(painter_, palette_, scale_ * 0.65);
            small.target(centre + QPointF(-half * 0.3, half * 0.3),
                         {TrackState::Confirmed, false, false, std::numbers::pi / 4.0, px(7.0)});
            break;
        }
        case LayerSymbol::Ellipses: {
            path.addEllipse(centre, half * 0.7, half * 0.45);
            strokeWithHalo(painter_, path, line(palette_.track), palette_.halo);
            QPainterPath outer;
            outer.addEllipse(centre, half * 1.35, half * 0.95);
            strokeWithHalo(painter_, outer, line(palette_.track, {2.5, 2.0}), palette_.halo);
            break;
        }
        case LayerSymbol::History: {
            path.moveTo(at(-1.2, 0.9));
            path.lineTo(at(0.0, 0.0));
            strokeWithHalo(painter_, path, line(palette_.track), palette_.halo);
            QPainterPath ahead;
            ahead.moveTo(at(0.0, 0.0));
            ahead.lineTo(at(1.2, -0.9));
            strokeWithHalo(painter_, ahead, line(palette_.track, {2.5, 2.0}), palette_.halo);
            break;
        }
        case LayerSymbol::RegionOfInterest: {
            const std::array box_outline{at(-1.1, 0.8), at(-0.7, -0.8), at(0.7, -0.8), at(1.1, 0.8)};
            path.addPolygon(QPolygonF(QList<QPointF>(box_outline.begin(), box_outline.end())));
            path.closeSubpath();
            strokeWithHalo(painter_, path, line(palette_.track, {4.0, 2.5}), palette_.halo);
            break;
        }
        case LayerSymbol::GuardZone:
        case LayerSymbol::Veto: {
            const bool guard = symbol == LayerSymbol::GuardZone;
            const QColor& colour = guard ? palette_.guard : palette_.graticule;
            const std::array corners{at(-1.1, 0.9), at(-0.7, -0.9), at(0.7, -0.9), at(1.1, 0.9)};
            path.addPolygon(QPolygonF(QList<QPointF>(corners.begin(), corners.end())));
            path.closeSubpath();
            if (!guard) painter_.fillPath(path, QBrush(colour, Qt::BDiagPattern));
            strokeWithHalo(painter_, path, line(colour), palette_.halo);
            break;
        }
        case LayerSymbol::Mark: {
            SymbolPainter small(painter_, palette_, scale_ * 0.8);
            small.mark(at(-0.5, 1.0));
            break;
        }
        case LayerSymbol::Trail:
        case LayerSymbol::Moving: {
            QColor faint = palette_.track;
            for (int i = 0; i < 4 && symbol == LayerSymbol::Trail; ++i) {
                faint.setAlphaF(0.2F + 0.15F * static_cast<float>(i));
                painter_.fillRect(around(at(-1.2 + 0.6 * i, 0.6 - 0.4 * i), half * 0.32), faint);
            }
            if (symbol == LayerSymbol::Moving) {
                QColor grey = palette_.mark;
                grey.setAlphaF(0.75F);
                painter_.fillRect(around(centre, half * 0.4), grey);
            }
            break;
        }
        case LayerSymbol::Graticule: {
            painter_.setPen(line(palette_.graticule).pen());
            for (const double radius : {0.9, 1.7})
                painter_.drawArc(around(at(0.0, 1.0), radius * half), 45 * 16, 90 * 16);
            break;
        }
        case LayerSymbol::Inset: {
            path.addRect(around(centre, half));
            strokeWithHalo(painter_, path, line(palette_.mark), palette_.halo);
            SymbolPainter small(painter_, palette_, scale_ * 0.55);
            small.target(centre, {TrackState::Confirmed, false, false, {}, 0.0});
            break;
        }
    }
    painter_.restore();
}

}  // namespace echotrail
