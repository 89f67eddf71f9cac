#pragma once

#include "core/data/area.hpp"
#include "ui/chart/mark.hpp"
#include "ui/style/palette.hpp"
#include "ui/style/ui_metrics.hpp"
#include "ui/views/fan_geometry.hpp"

#include <QPainter>
#include <optional>

namespace echotrail {

/// Two places on the ground between which range and bearing are measured.
struct Measurement {
    Eigen::Vector2d from{0, 0};
    Eigen::Vector2d to{0, 0};
};

/// "1.92 m  041.0°T  046.2°R": the bearing from the first place to the second.
QString measuredText(const Measurement& measurement, const FanGeometry& geometry, bool heading_known);

/// An area in the making, its corners on the ground.
struct AreaDraft {
    Area::Kind kind = Area::Kind::Guard;
    std::vector<Eigen::Vector2d> corners_m;
};

/// Draws what the operator has laid on the sea: areas, marks, the measure.
class ChartPainter {
public:
    ChartPainter(QPainter& painter, const FanGeometry& geometry, const Pose& vehicle, const Palette& palette,
                 const QFont& font)
        : painter_(painter), geometry_(geometry), vehicle_(vehicle), palette_(palette), font_(font), metrics_(font) {}

    void paintAreas(const QList<Area>& areas, bool guard_zones, bool vetoes);
    void paintMarks(const QList<Mark>& marks);
    void paintMeasurement(const Measurement& measurement);
    /// With a line to the hand.
    void paintDraft(const AreaDraft& draft, const std::optional<QPointF>& hand);

private:
    double px(double at_base) const { return metrics_.length(at_base); }
    void paintArea(const Area& area);
    void label(QPointF place, const QString& text, const QColor& colour);

    QPainter& painter_;
    const FanGeometry& geometry_;
    const Pose& vehicle_;
    const Palette& palette_;
    QFont font_;
    UiMetrics metrics_;
};

}  // namespace echotrail
