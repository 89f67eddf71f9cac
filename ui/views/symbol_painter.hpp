#pragma once

#include "core/data/track.hpp"
#include "ui/style/palette.hpp"

#include <QPainter>
#include <optional>

namespace echotrail {

/// How a track's symbol looks.
struct TargetSymbol {
    TrackState state = TrackState::Tentative;
    bool designated = false;             ///< the operator's target: brackets
    bool selected = false;               ///< its card is open: a square
    std::optional<double> motion_angle;  ///< radians clockwise from up; a coasting track's gap points there
    double vector_px = 0.0;              ///< length of the speed vector
};

/// Things that have a small picture of their own in lists and legends.
enum class LayerSymbol {
    Echo,
    RegionKept,
    RegionDropped,
    Particles,
    Track,
    Ellipses,
    History,
    RegionOfInterest,
    GuardZone,
    Veto,
    Mark,
    Trail,
    Moving,
    Graticule,
    Inset
};

/// Draws the marks of the fan, the same in the picture, the table and the lists. `scale` is that of the text.
class SymbolPainter {
public:
    SymbolPainter(QPainter& painter, const Palette& palette, double scale)
        : painter_(painter), palette_(palette), scale_(scale) {}

    void target(QPointF centre, const TargetSymbol& symbol);
    /// The own vehicle, its bow `angle` radians clockwise from up.
    void ownShip(QPointF centre, double angle);
    void nextLookCross(QPointF centre);
    void cursorCross(QPointF centre);
    /// A flag whose staff stands on `foot`.
    void mark(QPointF foot);
    /// The corner of an area, to be taken by the hand.
    void handle(QPointF centre, const QColor& colour);
    void layer(const QRectF& box, LayerSymbol symbol);

    /// Radius of a steady track's circle at scale 1, px.
    static constexpr double steady_radius = 7.0;

private:
    double px(double at_base) const { return at_base * scale_; }
    QColor colourOf(TrackState state) const;

    QPainter& painter_;
    const Palette& palette_;
    double scale_;
};

}  // namespace echotrail
