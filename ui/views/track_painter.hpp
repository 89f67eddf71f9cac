#pragma once

#include "core/runtime/scene.hpp"
#include "ui/style/formatter.hpp"
#include "ui/style/palette.hpp"
#include "ui/style/ui_metrics.hpp"
#include "ui/views/fan_geometry.hpp"
#include "ui/views/fan_settings.hpp"

#include <QPainter>

namespace echotrail {

/// Draws what the tracker makes of the echoes, back to front: regions, regions of interest, history, prediction,
/// particles, ellipses, symbols and labels.
class TrackPainter {
public:
    TrackPainter(QPainter& painter, const Scene& scene, const FanGeometry& geometry, const Layers& layers,
                 const Palette& palette, const QFont& font, const TrackNames& names)
        : painter_(painter),
          scene_(scene),
          geometry_(geometry),
          layers_(layers),
          palette_(palette),
          names_(names),
          metrics_(font),
          bold_(metrics_.sized(font, 11.0, true)),
          plain_(metrics_.sized(font, 11.0)) {}

    void paintRegions();
    /// Everything of the tracks but symbols and labels; `only` a track's id, or 0 for all.
    void paintClouds(int only = 0);
    void paintSymbols(int selected);

private:
    double px(double at_base) const { return metrics_.length(at_base); }
    void paintRegionOfInterest(const Track& track);
    void paintHistory(const Track& track);
    void paintPrediction(const Track& track);
    void paintParticles(const Track& track);
    void paintEllipses(const Track& track);
    void paintLabel(const Track& track, QPointF centre, QList<QRectF>& taken);
    QStringList labelOf(const Track& track) const;

    QPainter& painter_;
    const Scene& scene_;
    const FanGeometry& geometry_;
    const Layers& layers_;
    const Palette& palette_;
    const TrackNames& names_;
    UiMetrics metrics_;
    QFont bold_, plain_;  ///< of labels
};

/// A region that no track may use.
inline bool isDropped(const Region& region) { return region.clutter_mass || region.multipath; }
/// Where a track is seen from the head: its range and its bearing from the bow.
double rangeOf(const Track& track, const Pose& pose);
Bearing bearingOf(const Track& track, const Pose& pose);
/// The outline of the ellipse `times` deviations about a place, in the local frame (north, east).
std::vector<Eigen::Vector2d> ellipseOutline(const Eigen::Vector2d& centre, const Eigen::Matrix2d& covariance,
                                            double times);
/// Deviations within which a plane Gaussian has 95 % of its mass: √χ²₂(0.95).
inline constexpr double deviations_95 = 2.4477;

}  // namespace echotrail
