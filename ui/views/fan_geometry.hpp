#pragma once

#include "core/base/angles.hpp"
#include "core/data/pose.hpp"

#include <Eigen/Core>

#include <QMarginsF>
#include <QPointF>
#include <QRectF>

namespace echotrail {

/// The part of a circle that the sonar scans, bearings from the bow.
struct Sector {
    Bearing left;
    double width_rad = 0.0;  ///< clockwise from `left`, up to a full circle
    double range_m = 0.0;

    bool isFullCircle() const;
    Bearing centre() const { return left + width_rad / 2.0; }
    bool contains(Bearing from_bow) const;
    bool operator==(const Sector&) const = default;
};

/// Where things of the local frame appear on the screen (logical pixels, y down).
struct FanGeometry {
    QPointF head_px;  ///< the sonar head
    double north_m = 0.0;
    double east_m = 0.0;
    Bearing heading;  ///< of the bow, from north
    Bearing up;       ///< what points up on the screen, from north
    double px_per_m = 1.0;
    Sector sector;

    QPointF toScreen(double north, double east) const;
    QPointF toScreen(const Eigen::Vector2d& place) const { return toScreen(place.x(), place.y()); }
    QPointF toScreen(const Eigen::Vector2f& place) const {
        return toScreen(static_cast<double>(place.x()), static_cast<double>(place.y()));
    }
    QPointF at(double range_m, Bearing from_bow) const;
    /// North and east of a place on the screen.
    Eigen::Vector2d toLocal(QPointF screen) const;
    double rangeOf(QPointF screen) const;
    Bearing bearingOf(QPointF screen) const;  ///< from the bow
    /// Clockwise from up on the screen.
    double screenAngle(Bearing from_bow) const { return (heading - up) + from_bow.inRadians(); }
    /// Smallest box on the screen that holds the sector.
    QRectF sectorBox() const;
    /// The same view, `times` as large, with this place in the middle of `box`.
    FanGeometry magnified(const Eigen::Vector2d& place, double times, const QRectF& box) const;
    bool operator==(const FanGeometry&) const = default;
};

/// The geometry with `up` (from north) on top that shows the whole sector as large as `box` less `margins` allows.
FanGeometry fitted(const Pose& head, Bearing up, const Sector& sector, const QRectF& box, const QMarginsF& margins);

}  // namespace echotrail
