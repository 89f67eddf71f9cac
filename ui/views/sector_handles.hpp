#pragma once

#include "ui/style/palette.hpp"
#include "ui/style/ui_metrics.hpp"
#include "ui/views/fan_geometry.hpp"
#include "ui/views/sector_edit.hpp"

#include <QFont>
#include <QPainter>
#include <optional>

namespace echotrail {

/// Handles at the edges of the sector that the head is told to scan. A hand drags one, or keys move it; nothing is
/// commanded before it is let go, and giving up leaves all as it was.
class SectorHandles {
public:
    /// What is commanded, and whether the head says that it does so; none: there are no handles. Whether
    /// that is new.
    bool show(const std::optional<CommandedSector>& commanded, bool confirmed);
    bool areThere() const { return commanded_.has_value(); }

    /// The handle under a place, if any.
    std::optional<SectorEdge> at(QPointF place, const FanGeometry& geometry, const QRectF& view, double scale) const;
    /// Begins to move an edge, by hand from `from_bow`, or by keys.
    void take(SectorEdge edge, std::optional<Bearing> from_bow = {});
    bool isHeld() const { return edited_.has_value(); }
    bool isDragged() const { return hand_.has_value(); }
    SectorEdge heldEdge() const { return edge_; }

    void drag(Bearing from_bow);
    /// The held edge clockwise by so many steps.
    void step(int clockwise);
    void cancel();
    /// Ends the edit; the sector to command, where it is another one than before.
    std::optional<CommandedSector> finish();

    /// As it will be, or else as it is commanded. Only while there are handles.
    const CommandedSector& sector() const { return edited_ ? *edited_ : *commanded_; }
    bool isConfirmed() const { return confirmed_ && !edited_; }

    void paint(QPainter& painter, const FanGeometry& geometry, const QRectF& view, const Palette& palette,
               const QFont& font) const;

private:
    std::optional<CommandedSector> commanded_;
    bool confirmed_ = false;
    std::optional<CommandedSector> edited_;
    SectorEdge edge_ = SectorEdge::Right;
    std::optional<Bearing> hand_;     ///< where it is, while it drags
    double dragged_width_deg_ = 0.0;  ///< not snapped, not limited
};

}  // namespace echotrail
