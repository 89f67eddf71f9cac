#include "ui/views/fan_picture.hpp"

#include "core/data/ping.hpp"
#include "ui/style/formatter.hpp"
#include "ui/views/badge_painter.hpp"
#include "ui/views/beam_painter.hpp"
#include "ui/views/halo.hpp"
#include "ui/views/symbol_painter.hpp"
#include "ui/views/track_painter.hpp"

#include <QCoreApplication>
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

QString text(const char* source) { return QCoreApplication::translate("FanView", source); }

const FanImage& shownFan(const FanMoment& moment) {
    const bool enhanced = moment.layers.enhanced && !moment.scene->enhanced.empty();
    return enhanced ? moment.scene->enhanced : moment.scene->fan;
}

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

struct UnderCursor {
    double level_db = std::numeric_limits<double>::quiet_NaN();
    double age_s = std::numeric_limits<double>::quiet_NaN();
};

UnderCursor echoAt(const FanMoment& moment, const Eigen::Vector2d& place) {
    const FanImage& fan = shownFan(moment);
    if (fan.empty()) return {};
    const long row = std::lround(fan.rowOf(place.x()));
    const long column = std::lround(fan.columnOf(place.y()));
    if (row < 0 || column < 0 || row >= fan.levels.rows || column >= fan.levels.cols) return {};
    const cv::Point pixel(static_cast<int>(column), static_cast<int>(row));
    const std::int32_t time = fan.beam_time_ms.at<std::int32_t>(pixel);
    if (time == FanImage::never_scanned) return {};
    return {fan.levels.at<std::uint8_t>(pixel) / levels_per_db, (moment.ages->newest_ms - time) / 1000.0};
}

QList<BadgeLine> cursorLines(const FanMoment& moment, const Palette& p) {
    const FanGeometry& geometry = moment.geometry;
    QList<BadgeLine> lines;
    if (moment.measuring) {
        BadgeLine line{{text("Measure "), p.graticule}};
        if (moment.measurement) {
            const Eigen::Vector2d leg = moment.measurement->to - moment.measurement->from;
            const Bearing from_north = Bearing::radians(std::atan2(leg.y(), leg.x()));
            line << BadgeText{Formatter::range(leg.norm()), p.mark, true}
                 << BadgeText{"  " + Formatter::relativeBearing(Bearing::radians(from_north - geometry.heading)),
                              p.mark};
        } else {
            line << BadgeText{text("click the first place"), p.mark};
        }
        lines << line;
    }
    if (moment.sector && moment.sector->areThere() && !moment.sector->isConfirmed()) {
        const bool held = moment.sector->isHeld();
        lines << BadgeLine{
            {text("Sector "), p.graticule},
            {Formatter::number(moment.sector->sector().width_deg, 1) + "°", p.caution, true},
            {"  " + (held ? text("Enter or let go commands, Esc gives up") : text("commanded, not confirmed")),
             p.mark}};
    }
    BadgeLine place{{text("Cursor "), p.graticule}};
    if (!moment.cursor || !moment.scene) {
        place << BadgeText{Formatter::unknown(), p.graticule};
        return lines << place;
    }
    const Bearing bearing = geometry.bearingOf(*moment.cursor);
    place << BadgeText{Formatter::range(geometry.rangeOf(*moment.cursor)) + "  " + Formatter::relativeBearing(bearing),
                       p.mark, true};
    if (headingKnown(*moment.scene))
        place << BadgeText{"  " + Formatter::trueBearing(bearing + geometry.heading.inRadians()), p.mark, true};
    const UnderCursor echo = echoAt(moment, geometry.toLocal(*moment.cursor));
    lines << place;
    lines << BadgeLine{{text("level "), p.graticule},
                       {Formatter::withUnit(echo.level_db, 0, "dB"), p.mark},
                       {text("  beam age "), p.graticule},
                       {Formatter::age(echo.age_s), p.mark}};
    return lines;
}

QList<BadgeLine> viewLines(const FanMoment& moment, const Palette& p) {
    const Scene& scene = *moment.scene;
    QString how = moment.orientation == Orientation::HeadUp ? text("HEAD UP") : text("NORTH UP");
    if (moment.orientation == Orientation::NorthUp && !headingKnown(scene))
        how = text("NORTH UP: no heading, north is the bow");
    if (!moment.follow) how += "  " + text("GROUND FIXED");
    const bool wants = moment.layers.enhanced;
    const QString layer = !moment.layers.echoes              ? text("ECHO OFF")
                          : wants && !scene.enhanced.empty() ? text("ENHANCED")
                                                             : text("RAW");
    BadgeLine first{{Formatter::withUnit(moment.geometry.sector.range_m, 0, "m"), p.mark, true},
                    {"  " + how + "  " + layer, p.mark}};
    if (std::abs(moment.zoom - 1.0) > 0.01) first << BadgeText{"  ×" + Formatter::number(moment.zoom, 1), p.mark, true};
    QList<BadgeLine> lines{first};
    const auto dropped = std::count_if(scene.regions.begin(), scene.regions.end(), isDropped);
    if (dropped > 0)
        lines << BadgeLine{
            {text("FILTERS ACTIVE"), p.caution, true},
            {"  " + QCoreApplication::translate("FanView", "%n region(s) dropped", nullptr, static_cast<int>(dropped)),
             p.mark}};
    if (scene.latest.navigation_gap)
        lines << BadgeLine{{text("NAVIGATION GAP"), p.caution, true}, {"  " + text("tracks coast"), p.mark}};
    return lines;
}

QList<BadgeLine> sweepLines(const FanMoment& moment, const Palette& p) {
    const Scene& scene = *moment.scene;
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    QList<BadgeLine> lines{
        {{text("Sweep "), p.graticule},
         {Formatter::age(scene.sweep_s > 0.0 ? scene.sweep_s : unknown), p.mark, true},
         {text("  oldest beam "), p.graticule},
         {Formatter::age(moment.ages->age_s.empty() ? unknown : moment.ages->oldest_s), p.mark, true}}};
    const auto target = std::find_if(scene.tracks.begin(), scene.tracks.end(), [](const Track& t) { return t.target; });
    if (target == scene.tracks.end()) return lines;
    const auto wait = secondsToNextLook(scene, bearingOf(*target, scene.latest.pose));
    lines << BadgeLine{{text("Next look at %1 in ").arg(Formatter::trackId(target->id)), p.graticule},
                       {Formatter::age(wait.value_or(unknown)), p.track, true}};
    return lines;
}

void paintMeasurement(QPainter& painter, const FanMoment& moment, const Palette& palette, const UiMetrics& metrics) {
    if (!moment.measurement) return;
    const QPointF from = moment.geometry.toScreen(moment.measurement->from);
    const QPointF to = moment.geometry.toScreen(moment.measurement->to);
    QPainterPath path(from);
    path.lineTo(to);
    for (const QPointF& end : {from, to}) path.addEllipse(end, metrics.length(3.0), metrics.length(3.0));
    strokeWithHalo(painter, path, {palette.mark, metrics.length(1.3)}, palette.halo);
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
    const double width = QFontMetricsF(painter.font(), painter.device()).horizontalAdvance(label);
    textWithHalo(painter, {(left + right - width) / 2.0, y - metrics.length(6.0)}, label, palette.mark, palette.halo);
}

}  // namespace

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
                          inset_echo_.image(shownFan(moment), moment.serial, *moment.ages, geometry, moment.echo,
                                            currentTheme(), box.toRect(), painter.device()->devicePixelRatioF()));
    else
        painter.fillRect(box, palette.canvas);
    Layers layers = moment.layers;
    layers.region_of_interest = false;  // larger than the box
    TrackPainter tracks(painter, *moment.scene, geometry, layers, palette, font);
    tracks.paintRegions();
    tracks.paintClouds(track->id);
    painter.setFont(metrics.sized(font, 11.0, true));
    const QPointF name(box.x() + edge, box.y() + metrics.length(16.0));
    textWithHalo(painter, name, Formatter::trackId(track->id) + " ×4", palette.track, palette.halo);
    painter.setFont(metrics.sized(font, 10.0));
    const std::size_t particles = track->particles.weight.size();
    const QString effective = particles > 0 ? text("ESS ") + Formatter::number(track->particles.effective, 0) + " / " +
                                                  Formatter::count(particles)
                                            : text("no particles");
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
        badges.paintLegend(moment.echo, currentTheme(), cursor.top() - metrics.length(4.0));
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
        painter.drawText(view, Qt::AlignCenter, text("No echoes yet"));
        return;
    }
    painter.fillRect(view, palette.canvas);
    if (moment.layers.echoes) {
        const QRect box = echoBox(moment, view);
        painter.drawImage(box.topLeft(),
                          echo_.image(shownFan(moment), moment.serial, *moment.ages, moment.geometry, moment.echo,
                                      currentTheme(), box, painter.device()->devicePixelRatioF()));
    }
    painter.setRenderHint(QPainter::Antialiasing);
    if (moment.layers.graticule)
        graticule_.paint(painter, size, moment.geometry, palette, font, headingKnown(*moment.scene));
    TrackPainter tracks(painter, *moment.scene, moment.geometry, moment.layers, palette, font);
    tracks.paintRegions();
    tracks.paintClouds();
    tracks.paintSymbols(moment.selected_track);
    paintMeasurement(painter, moment, palette, metrics);
    if (moment.cursor && moment.geometry.rangeOf(*moment.cursor) <= moment.geometry.sector.range_m)
        SymbolPainter(painter, palette, metrics.scale()).cursorCross(*moment.cursor);
    paintBeam(painter, *moment.scene, *moment.ages, moment.geometry, palette, metrics);
    if (moment.sector) moment.sector->paint(painter, moment.geometry, view, palette, font);
    const QRectF top_right = paintBadges(painter, view, moment, font);
    paintInset(painter, view, top_right.bottom(), moment, font);
}

}  // namespace echotrail
