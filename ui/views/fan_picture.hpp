#pragma once

#include "core/runtime/scene.hpp"
#include "ui/views/beam_schedule.hpp"
#include "ui/views/echo_painter.hpp"
#include "ui/views/graticule_painter.hpp"
#include "ui/views/sector_handles.hpp"

#include <QFont>
#include <QPainter>
#include <array>
#include <optional>

namespace echotrail {

/// Two places on the ground between which range and bearing are measured.
struct Measurement {
    Eigen::Vector2d from{0, 0};
    Eigen::Vector2d to{0, 0};
};

/// What the picture shows beside the scene.
struct FanMoment {
    const Scene* scene = nullptr;
    std::uint64_t serial = 0;  ///< names the scene
    const BeamAges* ages = nullptr;
    FanGeometry geometry;
    Layers layers;
    EchoSettings echo;
    Orientation orientation = Orientation::HeadUp;
    bool follow = true;
    double zoom = 1.0;
    int selected_track = 0;
    std::optional<QPointF> cursor;
    bool measuring = false;
    std::optional<Measurement> measurement;
    const SectorHandles* sector = nullptr;
};

/// Paints the whole fan, back to front, and keeps what need not be painted anew.
class FanPicture {
public:
    void paint(QPainter& painter, const QSize& size, const FanMoment& moment, const QFont& font);

private:
    QRectF paintBadges(QPainter& painter, const QRectF& view, const FanMoment& moment, const QFont& font);
    void paintInset(QPainter& painter, const QRectF& view, double top, const FanMoment& moment, const QFont& font);

    EchoPainter echo_;
    EchoPainter inset_echo_;
    GraticulePainter graticule_;
};

}  // namespace echotrail
