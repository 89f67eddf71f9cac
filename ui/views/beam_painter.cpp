#include "ui/views/beam_painter.hpp"

#include "ui/views/device_pixels.hpp"
#include "ui/views/halo.hpp"
#include "ui/views/stroke_tiles.hpp"
#include "ui/views/symbol_painter.hpp"
#include "ui/views/track_painter.hpp"

#include <array>
#include <cmath>

namespace echotrail {
namespace {

constexpr double ring_distance = 8.0;  ///< from the outer range ring, px at scale 1
constexpr double ring_width = 5.0;
constexpr double least_opacity = 0.10;

void paintAgeRing(QPainter& painter, const BeamAges& ages, const FanGeometry& geometry, const Palette& palette,
                  const UiMetrics& metrics) {
    if (ages.age_s.size() < 2) return;
    const double radius = geometry.sector.range_m * geometry.px_per_m + metrics.length(ring_distance);
    const std::size_t pieces = ages.age_s.size() - 1;
    const double step_rad = geometry.sector.width_rad / static_cast<double>(pieces);
    const QTransform& to_device = painter.deviceTransform();
    const auto corner = [&](std::size_t i) {
        return to_device.map(
            geometry.at(radius / geometry.px_per_m, geometry.sector.left + static_cast<double>(i) * step_rad));
    };
    const auto scanned = [&](std::size_t i) { return i < pieces && ages.age_s[i] >= 0.0F; };
    std::vector<StrokeLeg> legs;
    for (std::size_t i = 0; i < pieces; ++i) {
        if (!scanned(i)) continue;
        const double share = ages.oldest_s > 0.0 ? static_cast<double>(ages.age_s[i]) / ages.oldest_s : 0.0;
        legs.push_back(
            {corner(i), corner(i + 1), i > 0 && scanned(i - 1), scanned(i + 1), 1.0 - (1.0 - least_opacity) * share});
    }
    paintStroke(painter, legs,
                {0.5 * metrics.length(ring_width) * deviceScale(painter), 0.0, palette.track, Qt::transparent});
}

}  // namespace

void paintBeam(QPainter& painter, const Scene& scene, const BeamAges& ages, const FanGeometry& geometry,
               const Palette& palette, const UiMetrics& metrics) {
    paintAgeRing(painter, ages, geometry, palette, metrics);
    const double outer = geometry.sector.range_m;
    const auto beyond = [&](double px) { return outer + metrics.length(px) / geometry.px_per_m; };
    for (const Track& track : scene.tracks) {
        const Bearing bearing = bearingOf(track, scene.latest.pose);
        if (!track.target || !geometry.sector.contains(bearing)) continue;
        QPainterPath tick;
        tick.moveTo(geometry.at(beyond(ring_distance - ring_width), bearing));
        tick.lineTo(geometry.at(beyond(ring_distance + ring_width), bearing));
        strokeWithHalo(painter, tick, {palette.mark, metrics.length(2.0)}, palette.halo);
    }
    const Bearing beam = scene.latest.beam;
    QPainterPath line(geometry.head_px);
    line.lineTo(geometry.at(outer, beam));
    strokeWithHalo(painter, line, {palette.mark, metrics.length(1.2)}, palette.halo);
    const double half_rad = metrics.length(6.0) / geometry.px_per_m / beyond(ring_distance + 6.0);
    const std::array triangle{geometry.at(beyond(2.0), beam), geometry.at(beyond(ring_distance + 5.0), beam + half_rad),
                              geometry.at(beyond(ring_distance + 5.0), beam + -half_rad)};
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette.mark);
    painter.drawPolygon(triangle.data(), static_cast<int>(triangle.size()));
    SymbolPainter(painter, palette, metrics.scale()).ownShip(geometry.head_px, geometry.screenAngle(Bearing()));
}

}  // namespace echotrail
