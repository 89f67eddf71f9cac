#pragma once

#include "core/runtime/scene.hpp"
#include "ui/chart/mark.hpp"
#include "ui/style/formatter.hpp"
#include "ui/views/beam_schedule.hpp"
#include "ui/views/chart_painter.hpp"
#include "ui/views/echo_painter.hpp"
#include "ui/views/fan_settings.hpp"
#include "ui/views/graticule_painter.hpp"
#include "ui/views/sector_handles.hpp"

#include <QFont>
#include <QPainter>
#include <array>
#include <optional>

namespace echotrail {

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
    bool off_centre = false;
    double zoom = 1.0;
    int selected_track = 0;
    std::optional<QPointF> cursor;
    bool measuring = false;
    std::optional<Measurement> measurement;
    const SectorHandles* sector = nullptr;
    const FanImage* moving = nullptr;  ///< the fan without its background; null unless asked for
    const QList<Mark>* marks = nullptr;
    const QList<Area>* areas = nullptr;
    std::optional<AreaDraft> draft;
    TrackNames track_names;
};

/// The picture that is shown, and how its levels become colours.
const FanImage& shownFan(const FanMoment& moment);
EchoSettings shownEcho(const FanMoment& moment);

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
