#include "ui/views/sector_handles.hpp"

#include "ui/style/formatter.hpp"
#include "ui/views/halo.hpp"

#include <QPainterPath>
#include <algorithm>
#include <utility>

namespace echotrail {
namespace {

constexpr double grip_distance = -30.0;  ///< from the outer range ring, clear of what is written at it; px at scale 1
constexpr double grip_radius = 6.0;
constexpr double grip_reach = 12.0;    ///< of the hand
constexpr double edge_of_view = 14.0;  ///< grips stay this far inside
constexpr double nearest_grip = 40.0;  ///< to the head

/// Near the outer ring, or as far out as the view goes.
QPointF gripPlace(const FanGeometry& geometry, Bearing edge, const QRectF& view, double scale) {
    const double inset = edge_of_view * scale;
    const QRectF room = view.adjusted(inset, inset, -inset, -inset);
    const double outermost = geometry.sector.range_m * geometry.px_per_m + grip_distance * scale;
    for (double radius = outermost; radius > nearest_grip * scale; radius -= 2.0)
        if (const QPointF place = geometry.at(radius / geometry.px_per_m, edge); room.contains(place)) return place;
    return geometry.at(outermost / geometry.px_per_m, edge);
}

}  // namespace

bool SectorHandles::show(const std::optional<CommandedSector>& commanded, bool confirmed) {
    if (commanded == commanded_ && confirmed == confirmed_) return false;
    commanded_ = commanded;
    confirmed_ = confirmed;
    if (!commanded_) cancel();
    return true;
}

std::optional<SectorEdge> SectorHandles::at(QPointF place, const FanGeometry& geometry, const QRectF& view,
                                            double scale) const {
    if (!commanded_) return std::nullopt;
    std::optional<SectorEdge> found;
    double nearest = grip_reach * scale;
    const bool to_port = geometry.bearingOf(place) - Bearing::degrees(sector().centre_deg) < 0.0;
    // Where both lie at one place, astern of a full circle, it is the one on whose side the hand is.
    for (const SectorEdge edge :
         {to_port ? SectorEdge::Left : SectorEdge::Right, to_port ? SectorEdge::Right : SectorEdge::Left}) {
        const double away = QLineF(place, gripPlace(geometry, sector().edge(edge), view, scale)).length();
        if (away >= (found ? nearest - 1.0 : nearest)) continue;
        nearest = away;
        found = edge;
    }
    return found;
}

void SectorHandles::take(SectorEdge edge, std::optional<Bearing> from_bow) {
    if (!commanded_) return;
    edge_ = edge;
    hand_ = from_bow;
    if (!edited_) edited_ = commanded_;
    dragged_width_deg_ = edited_->width_deg;
}

void SectorHandles::drag(Bearing from_bow) {
    if (!edited_ || !hand_) return;
    // Turn by turn, so that a hand that goes on past the other edge, or round astern, changes nothing suddenly.
    const double clockwise_deg = degreesFromRadians(from_bow - *hand_);
    dragged_width_deg_ += edge_ == SectorEdge::Right ? clockwise_deg : -clockwise_deg;
    hand_ = from_bow;
    *edited_ = withWidth(*edited_, edge_, dragged_width_deg_);
}

void SectorHandles::step(int clockwise) {
    if (edited_) *edited_ = widened(*edited_, edge_, edge_ == SectorEdge::Right ? clockwise : -clockwise);
}

void SectorHandles::cancel() {
    edited_.reset();
    hand_.reset();
}

std::optional<CommandedSector> SectorHandles::finish() {
    hand_.reset();
    auto edited = std::exchange(edited_, std::nullopt);
    if (edited == commanded_) return std::nullopt;
    // Shown as commanded from now on, until its owner says what is.
    commanded_ = edited;
    confirmed_ = false;
    return edited;
}

void SectorHandles::paint(QPainter& painter, const FanGeometry& geometry, const QRectF& view, const Palette& palette,
                          const QFont& font) const {
    if (!commanded_) return;
    const UiMetrics metrics(font);
    const double radius = metrics.length(grip_radius);
    painter.setFont(metrics.sized(font, 11.0, true));
    for (const SectorEdge edge : {SectorEdge::Left, SectorEdge::Right}) {
        const bool held = isHeld() && edge == edge_;
        const QColor colour = isConfirmed() ? palette.mark : palette.caution;
        const Bearing bearing = sector().edge(edge);
        const QPointF grip = gripPlace(geometry, bearing, view, metrics.scale());
        if (!isConfirmed()) {
            QPainterPath line(geometry.head_px);
            line.lineTo(grip);
            strokeWithHalo(painter, line, {colour, metrics.length(1.4), {6.0, 4.0}}, palette.halo);
        }
        painter.setPen(QPen(palette.halo, metrics.length(4.0)));
        painter.setBrush(held ? colour : palette.canvas);
        painter.drawEllipse(grip, radius, radius);
        painter.setPen(QPen(colour, metrics.length(2.0)));
        painter.drawEllipse(grip, radius, radius);
        if (isConfirmed()) continue;
        const QString text = Formatter::relativeBearing(bearing);
        const double width = QFontMetricsF(painter.font(), painter.device()).horizontalAdvance(text);
        const double x = std::clamp(grip.x() - width / 2.0, view.left() + radius, view.right() - width - radius);
        const double y = grip.y() - 2.0 * radius < view.top() + metrics.length(14.0) ? grip.y() + 3.5 * radius
                                                                                     : grip.y() - 2.0 * radius;
        textWithHalo(painter, {x, y}, text, colour, palette.halo);
    }
}

}  // namespace echotrail
