#include "ui/views/fan_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace echotrail {
namespace {

constexpr double full_circle_rad = 2.0 * std::numbers::pi;
constexpr double slit_rad = 1e-6;  ///< a full circle arrives a hair short of 2π

/// Smallest box that holds a sector of radius 1 about the origin, y down, `start` clockwise from up.
QRectF unitBox(double start, double width) {
    double left = 0.0;
    double right = 0.0;
    double top = 0.0;
    double bottom = 0.0;
    const auto take = [&](double angle) {
        left = std::min(left, std::sin(angle));
        right = std::max(right, std::sin(angle));
        top = std::min(top, -std::cos(angle));
        bottom = std::max(bottom, -std::cos(angle));
    };
    take(start);
    take(start + width);
    const double quarter = std::numbers::pi / 2.0;
    for (double angle = std::ceil(start / quarter) * quarter; angle < start + width; angle += quarter) take(angle);
    return {left, top, right - left, bottom - top};
}

}  // namespace

bool Sector::isFullCircle() const { return width_rad >= full_circle_rad - slit_rad; }

bool Sector::contains(Bearing from_bow) const { return std::abs(from_bow - centre()) <= width_rad / 2.0; }

QPointF FanGeometry::toScreen(double north, double east) const {
    const double dn = north - north_m;
    const double de = east - east_m;
    const double cosine = std::cos(up.inRadians());
    const double sine = std::sin(up.inRadians());
    return head_px + px_per_m * QPointF(de * cosine - dn * sine, -(dn * cosine + de * sine));
}

QPointF FanGeometry::at(double range_m, Bearing from_bow) const {
    const double angle = screenAngle(from_bow);
    return head_px + px_per_m * range_m * QPointF(std::sin(angle), -std::cos(angle));
}

Eigen::Vector2d FanGeometry::toLocal(QPointF screen) const {
    const QPointF offset = (screen - head_px) / px_per_m;
    const double cosine = std::cos(up.inRadians());
    const double sine = std::sin(up.inRadians());
    return {north_m - offset.y() * cosine - offset.x() * sine, east_m - offset.y() * sine + offset.x() * cosine};
}

double FanGeometry::rangeOf(QPointF screen) const {
    const QPointF offset = screen - head_px;
    return std::hypot(offset.x(), offset.y()) / px_per_m;
}

Bearing FanGeometry::bearingOf(QPointF screen) const {
    const QPointF offset = screen - head_px;
    return Bearing::radians(std::atan2(offset.x(), -offset.y()) - (heading - up));
}

QRectF FanGeometry::sectorBox() const {
    const QRectF unit = unitBox(screenAngle(sector.left), sector.width_rad);
    const double radius = sector.range_m * px_per_m;
    return {head_px + radius * unit.topLeft(), radius * unit.size()};
}

FanGeometry FanGeometry::magnified(const Eigen::Vector2d& place, double times, const QRectF& box) const {
    FanGeometry larger = *this;
    larger.px_per_m *= times;
    larger.head_px += box.center() - larger.toScreen(place);
    return larger;
}

FanGeometry fitted(const Pose& head, Bearing up, const Sector& sector, const QRectF& box, const QMarginsF& margins) {
    FanGeometry geometry;
    geometry.north_m = head.north_m;
    geometry.east_m = head.east_m;
    geometry.heading = head.heading;
    geometry.up = up;
    geometry.sector = sector;
    const QRectF unit = unitBox(geometry.screenAngle(sector.left), sector.width_rad);
    const QRectF room = box.marginsRemoved(margins);
    const double radius = std::max(
        1.0, std::min(room.width() / std::max(unit.width(), 0.1), room.height() / std::max(unit.height(), 0.1)));
    geometry.px_per_m = radius / std::max(sector.range_m, 0.1);
    geometry.head_px = room.center() - radius * unit.center();
    return geometry;
}

}  // namespace echotrail
