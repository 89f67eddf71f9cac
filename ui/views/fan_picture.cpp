#include "ui/views/fan_picture.hpp"

#include "core/data/ping.hpp"
#include "ui/views/badge_painter.hpp"
#include "ui/views/beam_painter.hpp"
#include "ui/views/fan_badges.hpp"
#include "ui/views/fan_text.hpp"
#include "ui/views/halo.hpp"
#include "ui/views/symbol_painter.hpp"
#include "ui/views/track_painter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace echotrail {
namespace {

constexpr double inset_magnification = 4.0;
constexpr double inset_size = 200.0;
constexpr double least_view_for_inset = 520.0;  ///< px at scale 1; smaller pictures need their room
constexpr double least_view_for_legend = 380.0;
// Without its background the picture shows by how much an echo stands out.
constexpr double moving_black_db = 3.0;
constexpr double moving_white_db = 30.0;

/// Where echoes can be: within range, and within the sector unless the vehicle has turned since they were seen.
QRect echoBox(const FanMoment& moment, const QRectF& view) {
    FanGeometry reach = moment.geometry;
    if (headingKnown(*moment.scene)) reach.sector.width_rad = 2.0 * std::numbers::pi;
    return reach.sectorBox().adjusted(-2, -2, 2, 2).intersected(view).toAlignedRect();
}

const Track* trackToMagnify(const FanMoment& moment) {
    const Track* found = nullptr;
    for (const Track& track : moment.scene->tracks) {
        if (track.target) return &track;
        if (track.id == moment.selected_track) found = &track;
    }
    return found;
}

void paintScaleBar(QPainter& painter, const QRectF& box, double px_per_m, const Palette& palette,
                   const UiMetrics& metrics) {
    const double metres = ringStep(box.width() / px_per_m * 1.5);
    const double right = box.right() - metrics.length(8.0);
    const double y = box.bottom() - metrics.length(8.0);
    const double left = right - metres * px_per_m;
    QPainterPath bar;
    bar.moveTo(left, y - metrics.length(4.0));
    bar.lineTo(left, y);
    bar.lineTo(right, y);
    bar.lineTo(right, y - metrics.length(4.0));
    strokeWithHalo(painter, bar, {palette.mark, metrics.length(1.2)}, palette.halo);
    const QString label = Formatter::number(metres, metres < 1.0 ? 2 : 0) + " m";
    const double width = keptWidth(painter, painter.font(), label);
    textWithHalo(painter, {(left + right - width) / 2.0, y - metrics.length(6.0)}, label, palette.mark, palette.halo);
}

}  // namespace

const FanImage& shownFan(const FanMoment& moment) {
    if (moment.moving) return *moment.moving;
    const bool enhanced = moment.layers.enhanced && !moment.scene->enhanced.empty();
    return enhanced ? moment.scene->enhanced : moment.scene->fan;
}

EchoSettings shownEcho(const FanMoment& moment) {
    EchoSettings echo = moment.echo;
    if (!moment.moving) return echo;
    echo.black_db = moving_black_db;
    echo.white_db = moving_white_db;
    return echo;
}

void FanPicture::paintInset(QPainter& painter, const QRectF& view, double top, const FanMoment& moment,
                            const QFont& font) {
    const Palette& palette = currentPalette();
    const UiMetrics metrics(font);
    const Track* track = moment.layers.inset ? trackToMagnify(moment) : nullptr;
    if (!track || std::min(view.width(), view.height()) < metrics.length(least_view_for_inset)) return;
    const double side = std::floor(metrics.length(inset_size));
    const double edge = metrics.length(8.0);
    QRectF box(std::floor(view.right() - edge - side), std::floor(view.bottom() - edge - side), side, side);
    const Eigen::Vector2d place = track->estimate.mean.head<2>();
    // The corner must not hide what it explains.
    if (box.contains(moment.geometry.toScreen(place))) box.moveTop(std::ceil(top + edge));
    const FanGeometry geometry = moment.geometry.magnified(place, inset_magnification / moment.zoom, box);
    painter.save();
    painter.setClipRect(box);
    if (moment.layers.echoes)
        painter.drawImage(box.topLeft(),
                          inset_echo_.image(shownFan(moment), moment.serial, *moment.ages, geometry, shownEcho(moment),
                                            currentTheme(), box.toRect(), painter.device()->devicePixelRatioF()));
    else
        painter.fillRect(box, palette.canvas);
    Layers layers = moment.layers;
    layers.region_of_interest = false;  // larger than the box
    TrackPainter tracks(painter, *moment.scene, geometry, layers, palette, font, moment.track_names);
    tracks.paintRegions();
    tracks.paintClouds(track->id);
    painter.setFont(metrics.sized(font, 11.0, true));
    const QString magnified = " ×4";
    const QPointF name(box.x() + edge, box.y() + metrics.length(16.0));
    const QFontMetricsF letters(painter.font(), painter.device());
    const QString label = letters.elidedText(Formatter::trackLabel(track->id, moment.track_names), Qt::ElideRight,
                                             side - 2.0 * edge - letters.horizontalAdvance(magnified));
    textWithHalo(painter, name, label + magnified, palette.track, palette.halo);
    painter.setFont(metrics.sized(font, 10.0));
    const std::size_t particles = track->particles.size();
    const QString effective =
        particles > 0 ? FanText::tr("ESS %1 / %2")
                            .arg(Formatter::number(track->particles.effective, 0), Formatter::count(particles))
                      : FanText::tr("no particles");
    textWithHalo(painter, {box.x() + edge, box.bottom() - edge}, effective, palette.mark, palette.halo);
    paintScaleBar(painter, box, geometry.px_per_m, palette, metrics);
    painter.restore();
    painter.setPen(QPen(palette.graticule, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(box);
}

QRectF FanPicture::paintBadges(QPainter& painter, const QRectF& view, const FanMoment& moment, const QFont& font) {
    const Palette& palette = currentPalette();
    const UiMetrics metrics(font);
    BadgePainter badges(painter, view, palette, font);
    const QRectF cursor = badges.paint(BadgeCorner::BottomLeft, cursorLines(moment, palette));
    if (std::min(view.width(), view.height()) >= metrics.length(least_view_for_legend) && moment.layers.echoes)
        badges.paintLegend(shownEcho(moment), currentTheme(), cursor.top() - metrics.length(4.0));
    badges.paint(BadgeCorner::TopLeft, viewLines(moment, palette));
    return badges.paint(BadgeCorner::TopRight, sweepLines(moment, palette));
}

void FanPicture::paint(QPainter& painter, const QSize& size, const FanMoment& moment, const QFont& font) {
    const Palette& palette = currentPalette();
    const UiMetrics metrics(font);
    const QRectF view(QPointF(), size);
    if (!moment.scene || moment.scene->position == 0) {
        painter.fillRect(view, palette.canvas);
        painter.setPen(palette.graticule);
        painter.drawText(view, Qt::AlignCenter, FanText::tr("No echoes yet"));
        return;
    }
    const QRect box = moment.layers.echoes ? echoBox(moment, view) : QRect();
    for (const QRect& part : QRegion(view.toRect()) - box) painter.fillRect(part, palette.canvas);
    if (!box.isEmpty()) {
        const RememberedEchoes* trails = moment.layers.trails ? moment.scene->remembered.get() : nullptr;
        painter.drawImage(box.topLeft(),
                          echo_.image(shownFan(moment), moment.serial, *moment.ages, moment.geometry, shownEcho(moment),
                                      currentTheme(), box, painter.device()->devicePixelRatioF(), trails));
    }
    painter.setRenderHint(QPainter::Antialiasing);
    if (moment.layers.graticule)
        graticule_.paint(painter, size, moment.geometry, palette, font, headingKnown(*moment.scene));
    TrackPainter tracks(painter, *moment.scene, moment.geometry, moment.layers, palette, font, moment.track_names);
    ChartPainter chart(painter, moment.geometry, moment.scene->latest.pose, palette, font);
    if (moment.areas) chart.paintAreas(*moment.areas, moment.layers.guard_zones, moment.layers.vetoes);
    tracks.paintRegions();
    tracks.paintClouds();
    tracks.paintSymbols(moment.selected_track);
    if (moment.marks && moment.layers.marks) chart.paintMarks(*moment.marks);
    if (moment.measurement) chart.paintMeasurement(*moment.measurement);
    if (moment.draft) chart.paintDraft(*moment.draft, moment.cursor);
    if (moment.cursor && moment.geometry.rangeOf(*moment.cursor) <= moment.geometry.sector.range_m)
        SymbolPainter(painter, palette, metrics.scale()).cursorCross(*moment.cursor);
    paintBeam(painter, *moment.scene, *moment.ages, moment.geometry, palette, metrics);
    if (moment.sector) moment.sector->paint(painter, moment.geometry, view, palette, font);
    const QRectF top_right = paintBadges(painter, view, moment, font);
    paintInset(painter, view, top_right.bottom(), moment, font);
}

}  // namespace echotrail
