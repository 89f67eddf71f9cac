#include "ui/views/fan_badges.hpp"

#include "core/data/ping.hpp"
#include "ui/style/formatter.hpp"
#include "ui/views/fan_text.hpp"
#include "ui/views/orientation.hpp"
#include "ui/views/track_painter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace echotrail {
namespace {

constexpr double oldest_picture_s = 2.0;  ///< single lines go missing in the best of times
constexpr qsizetype longest_label = 16;   ///< the badges of both corners must find room side by side

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

BadgeLine measureLine(const FanMoment& moment, const Palette& p) {
    BadgeLine line{{FanText::tr("Measure "), p.graticule}};
    if (!moment.measurement) return line << BadgeText{FanText::tr("drag, or click two places"), p.mark};
    return line << BadgeText{measuredText(*moment.measurement, moment.geometry, headingKnown(*moment.scene)), p.mark,
                             true};
}

BadgeLine draftLine(const AreaDraft& draft, const Palette& p) {
    const QString what = draft.kind == Area::Kind::Guard ? FanText::tr("Guard zone ") : FanText::tr("Veto area ");
    const QString how = draft.corners_m.size() < 3 ? FanText::tr("click its corners, Esc gives up")
                                                   : FanText::tr("Enter closes it, Backspace takes a corner back");
    return {{what, draft.kind == Area::Kind::Guard ? p.guard : p.graticule, true}, {how, p.mark}};
}

BadgeLine sectorLine(const SectorHandles& sector, const Palette& p) {
    const QString state = sector.isHeld() ? FanText::tr("Enter or let go commands, Esc gives up")
                                          : FanText::tr("commanded, not confirmed");
    return {{FanText::tr("Sector "), p.graticule},
            {Formatter::number(sector.sector().width_deg, 1) + "°", p.caution, true},
            {"  " + state, p.mark}};
}

/// Where the cursor is, in every way that is known.
QList<BadgeLine> placeLines(const FanMoment& moment, QPointF cursor, const Palette& p) {
    const FanGeometry& geometry = moment.geometry;
    const Bearing bearing = geometry.bearingOf(cursor);
    const bool heading = headingKnown(*moment.scene);
    BadgeLine polar{
        {FanText::tr("Cursor "), p.graticule},
        {Formatter::range(geometry.rangeOf(cursor)) + "  " + Formatter::relativeBearing(bearing), p.mark, true}};
    if (heading)
        polar << BadgeText{"  " + Formatter::trueBearing(bearing + geometry.heading.inRadians()), p.mark, true};
    QList<BadgeLine> lines{polar};
    const Eigen::Vector2d place = geometry.toLocal(cursor);
    if (heading)
        lines << BadgeLine{{"N ", p.graticule},
                           {Formatter::signedNumber(place.x() - geometry.north_m, 1) + " m", p.mark},
                           {"  E ", p.graticule},
                           {Formatter::signedNumber(place.y() - geometry.east_m, 1) + " m", p.mark}};
    if (const auto& plane = moment.scene->plane) {
        const GeographicPosition there = plane->toGeographic({place.x(), place.y()});
        lines << BadgeLine{
            {Formatter::latitude(there.latitude_rad) + "  " + Formatter::longitude(there.longitude_rad), p.mark}};
    }
    const UnderCursor echo = echoAt(moment, place);
    lines << BadgeLine{{moment.moving ? FanText::tr("stands out ") : FanText::tr("level "), p.graticule},
                       {Formatter::withUnit(echo.level_db, 0, "dB"), p.mark},
                       {FanText::tr("  beam age "), p.graticule},
                       {Formatter::age(echo.age_s), p.mark}};
    return lines;
}

QString layerBadge(const FanMoment& moment) {
    if (!moment.layers.echoes) return FanText::tr("ECHO OFF");
    if (moment.moving) return FanText::tr("MOVING ONLY");
    return moment.layers.enhanced && !moment.scene->enhanced.empty() ? FanText::tr("ENHANCED") : FanText::tr("RAW");
}

}  // namespace

QList<BadgeLine> cursorLines(const FanMoment& moment, const Palette& p) {
    QList<BadgeLine> lines;
    if (moment.draft) lines << draftLine(*moment.draft, p);
    if (moment.measuring && moment.scene) lines << measureLine(moment, p);
    if (moment.sector && moment.sector->areThere() && !moment.sector->isConfirmed())
        lines << sectorLine(*moment.sector, p);
    if (!moment.cursor || !moment.scene)
        return lines << BadgeLine{{FanText::tr("Cursor "), p.graticule}, {Formatter::unknown(), p.graticule}};
    return lines << placeLines(moment, *moment.cursor, p);
}

QList<BadgeLine> viewLines(const FanMoment& moment, const Palette& p) {
    const Scene& scene = *moment.scene;
    const QString missing = missingInput(scene, moment.orientation);
    QString how = orientationBadge(moment.orientation);
    if (!moment.follow) how += "  " + FanText::tr("GROUND FIXED");
    if (moment.off_centre) how += "  " + FanText::tr("OFF CENTRE");
    BadgeLine first{{Formatter::withUnit(moment.geometry.sector.range_m, 0, "m"), p.mark, true},
                    {"  " + how + "  " + layerBadge(moment), p.mark}};
    if (std::abs(moment.zoom - 1.0) > 0.01) first << BadgeText{"  ×" + Formatter::number(moment.zoom, 1), p.mark, true};
    QList<BadgeLine> lines{first};
    if (!missing.isEmpty())
        lines << BadgeLine{{missing, p.caution, true}, {"  " + FanText::tr("shown head up"), p.mark}};
    if ((moment.moving || moment.layers.trails) && !scene.remembered)
        lines << BadgeLine{{FanText::tr("Learns what lies still"), p.caution, true},
                           {"  " + FanText::tr("wait two sweeps"), p.mark}};
    const auto dropped = std::count_if(scene.regions.begin(), scene.regions.end(), isDropped);
    if (dropped > 0)
        lines << BadgeLine{{FanText::tr("FILTERS ACTIVE"), p.caution, true},
                           {"  " + FanText::tr("regions dropped: %1").arg(dropped), p.mark}};
    if (scene.picture_age_s > oldest_picture_s)
        lines << BadgeLine{
            {FanText::tr("PICTURE IS OLD"), p.caution, true},
            {"  " + FanText::tr("%1: the link is too slow for it").arg(Formatter::age(scene.picture_age_s)), p.mark}};
    if (scene.latest.navigation_gap)
        lines << BadgeLine{{FanText::tr("NAVIGATION GAP"), p.caution, true},
                           {"  " + FanText::tr("tracks coast"), p.mark}};
    return lines;
}

QList<BadgeLine> sweepLines(const FanMoment& moment, const Palette& p) {
    const Scene& scene = *moment.scene;
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    QList<BadgeLine> lines{
        {{FanText::tr("Sweep "), p.graticule},
         {Formatter::age(scene.sweep_s > 0.0 ? scene.sweep_s : unknown), p.mark, true},
         {FanText::tr("  oldest beam "), p.graticule},
         {Formatter::age(moment.ages->age_s.empty() ? unknown : moment.ages->oldest_s), p.mark, true}}};
    const auto target = std::find_if(scene.tracks.begin(), scene.tracks.end(), [](const Track& t) { return t.target; });
    if (target == scene.tracks.end()) return lines;
    const auto wait = secondsToNextLook(scene, bearingOf(*target, scene.latest.pose));
    QString label = Formatter::trackLabel(target->id, moment.track_names);
    if (label.size() > longest_label) label = label.left(longest_label - 1) + "…";
    lines << BadgeLine{{FanText::tr("Next look at %1 in ").arg(label), p.graticule},
                       {Formatter::age(wait.value_or(unknown)), p.track, true}};
    return lines;
}

}  // namespace echotrail
