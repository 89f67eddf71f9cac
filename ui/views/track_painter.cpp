#include "ui/views/track_painter.hpp"

#include "ui/views/beam_schedule.hpp"
#include "ui/views/fan_text.hpp"
#include "ui/views/halo.hpp"
#include "ui/views/symbol_painter.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace echotrail {
namespace {

constexpr int ellipse_corners = 48;
constexpr int opacity_batches = 8;
constexpr std::size_t most_points = 2000;
constexpr double vector_seconds = 5.0;   ///< the speed vector reaches where the track will be then
constexpr double most_vector_px = 60.0;  ///< at scale 1
constexpr double least_moving_mps = 0.05;

QPainterPath closedPath(const FanGeometry& geometry, const auto& outline) {
    QPolygonF polygon;
    polygon.reserve(static_cast<qsizetype>(outline.size()) + 1);
    for (const auto& corner : outline) polygon << geometry.toScreen(corner);
    QPainterPath path;
    path.addPolygon(polygon);
    path.closeSubpath();
    return path;
}

std::optional<double> motionAngle(const Track& track, const FanGeometry& geometry) {
    const Eigen::Vector2d velocity = track.estimate.mean.tail<2>();
    if (velocity.norm() < least_moving_mps) return std::nullopt;
    return Bearing::radians(std::atan2(velocity.y(), velocity.x())) - geometry.up;
}

}  // namespace

double rangeOf(const Track& track, const Pose& pose) {
    return std::hypot(track.estimate.mean.x() - pose.north_m, track.estimate.mean.y() - pose.east_m);
}

Bearing bearingOf(const Track& track, const Pose& pose) {
    const Bearing from_north =
        Bearing::radians(std::atan2(track.estimate.mean.y() - pose.east_m, track.estimate.mean.x() - pose.north_m));
    return Bearing::radians(from_north - pose.heading);
}

std::vector<Eigen::Vector2d> ellipseOutline(const Eigen::Vector2d& centre, const Eigen::Matrix2d& covariance,
                                            double times) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(covariance);
    const Eigen::Vector2d lengths = times * axes.eigenvalues().cwiseMax(0.0).cwiseSqrt();
    std::vector<Eigen::Vector2d> outline(ellipse_corners);
    for (int i = 0; i < ellipse_corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / ellipse_corners;
        outline[static_cast<std::size_t>(i)] =
            centre +
            axes.eigenvectors() * Eigen::Vector2d(lengths.x() * std::cos(angle), lengths.y() * std::sin(angle));
    }
    return outline;
}

void TrackPainter::paintRegions() {
    QColor weak = palette_.region;
    weak.setAlphaF(0.75F);
    const LineStyle kept{palette_.region, px(1.0)};
    const LineStyle dropped{weak, px(1.0), {px(2.0), px(2.0)}};
    const auto paint = [this](bool wanted, bool are_dropped, const LineStyle& style) {
        for (const Region& region : scene_.regions)
            if (wanted && isDropped(region) == are_dropped && region.outline_m.size() >= 2)
                strokeWithHalo(painter_, closedPath(geometry_, region.outline_m), style, palette_.halo);
    };
    paint(layers_.regions_dropped, true, dropped);
    paint(layers_.regions_kept, false, kept);
}

void TrackPainter::paintRegionOfInterest(const Track& track) {
    const PolarBox& box = track.region_of_interest;
    if (box.far_m <= box.near_m || box.half_width_rad <= 0.0) return;
    std::vector<Eigen::Vector2d> outline;
    const auto arc = [&](double range, double from, double to) {
        const int corners = std::clamp(static_cast<int>(std::abs(to - from) * 30.0), 4, 90);
        for (int i = 0; i <= corners; ++i) {
            const double angle = box.centre.inRadians() + from + (to - from) * i / corners;
            outline.emplace_back(box.north_m + range * std::cos(angle), box.east_m + range * std::sin(angle));
        }
    };
    const double half = std::min(box.half_width_rad, std::numbers::pi);
    arc(box.near_m, -half, half);
    arc(box.far_m, half, -half);
    strokeWithHalo(painter_, closedPath(geometry_, outline), {palette_.track, px(1.0), {px(6.0), px(4.0)}},
                   palette_.halo);
}

void TrackPainter::paintHistory(const Track& track) {
    if (track.history.size() < 2) return;
    QPolygonF places;
    for (const TrackLook& look : track.history) places << geometry_.toScreen(look.position_m);
    QPainterPath path;
    path.addPolygon(places);
    strokeWithHalo(painter_, path, {palette_.track, px(1.2)}, palette_.halo);
    QList<QPointF> seen;
    for (std::size_t i = 0; i < track.history.size(); ++i)
        if (track.history[i].seen) seen << places[static_cast<qsizetype>(i)];
    fillDots(painter_, seen, px(2.0), palette_.track);
}

void TrackPainter::paintPrediction(const Track& track) {
    if (track.state == TrackState::Lost || track.state == TrackState::Tentative) return;
    const auto wait = secondsToNextLook(scene_, bearingOf(track, scene_.latest.pose));
    if (!wait) return;
    const double ahead = secondsBetween(track.estimate.time, scene_.latest.time) + *wait;
    const Eigen::Vector2d place = track.estimate.mean.head<2>();
    const QPointF from = geometry_.toScreen(place);
    const QPointF to = geometry_.toScreen(Eigen::Vector2d(place + ahead * track.estimate.mean.tail<2>()));
    if (QLineF(from, to).length() < px(SymbolPainter::steady_radius)) return;  // hidden by the symbol
    QPainterPath path(from);
    path.lineTo(to);
    strokeWithHalo(painter_, path, {palette_.track, px(1.5), {px(5.0), px(4.0)}}, palette_.halo);
    SymbolPainter(painter_, palette_, metrics_.scale()).nextLookCross(to);
}

void TrackPainter::paintParticles(const Track& track) {
    const ParticleCloud& cloud = track.particles;
    const std::size_t count = std::min(cloud.position_m.size(), cloud.weight.size());
    if (count == 0) return;
    const float heaviest = *std::max_element(cloud.weight.begin(), cloud.weight.end());
    if (heaviest <= 0.0F) return;
    std::array<QList<QPointF>, opacity_batches> batches;
    const QPointF middle = geometry_.toScreen(Eigen::Vector2d(track.estimate.mean.head<2>()));
    const QPointF per_north = geometry_.toScreen(1.0, 0.0) - geometry_.toScreen(0.0, 0.0);
    const QPointF per_east = geometry_.toScreen(0.0, 1.0) - geometry_.toScreen(0.0, 0.0);
    const double crowded = px(9.0);
    const std::size_t stride = (count + most_points - 1) / most_points;
    for (std::size_t i = 0; i < count; i += stride) {
        const Eigen::Vector2d from_mean = cloud.position_m[i].cast<double>() - track.estimate.mean.head<2>();
        const QPointF offset = from_mean.x() * per_north + from_mean.y() * per_east;
        // The echo must be seen under its explanation: where the cloud is dense three of four points are left out.
        if (i % 4 != 0 && QPointF::dotProduct(offset, offset) < crowded * crowded) continue;
        const auto batch = static_cast<std::size_t>(cloud.weight[i] / heaviest * (opacity_batches - 0.01F));
        batches[batch].push_back(middle + offset);
    }
    painter_.setRenderHint(QPainter::Antialiasing, false);
    for (std::size_t batch = 0; batch < batches.size(); ++batch) {
        if (batches[batch].isEmpty()) continue;
        QColor colour = palette_.track;
        colour.setAlphaF(0.15F + 0.65F * static_cast<float>(batch + 1) / opacity_batches);
        painter_.setPen(QPen(colour, px(1.0)));
        painter_.drawPoints(batches[batch].data(), static_cast<int>(batches[batch].size()));
    }
    painter_.setRenderHint(QPainter::Antialiasing);
}

void TrackPainter::paintEllipses(const Track& track) {
    const Eigen::Vector2d place = track.estimate.mean.head<2>();
    const Eigen::Matrix2d spread = track.estimate.covariance.topLeftCorner<2, 2>();
    if (!spread.allFinite()) return;
    const QColor& colour = track.state == TrackState::Lost ? palette_.danger : palette_.track;
    strokeWithHalo(painter_, closedPath(geometry_, ellipseOutline(place, spread, deviations_95)),
                   {colour, px(1.3), {px(5.0), px(3.0)}}, palette_.halo);
    strokeWithHalo(painter_, closedPath(geometry_, ellipseOutline(place, spread, 1.0)), {colour, px(1.3)},
                   palette_.halo);
}

void TrackPainter::paintClouds(int only) {
    const auto each = [&](bool wanted, auto paint) {
        if (!wanted) return;
        for (const Track& track : scene_.tracks)
            if (only == 0 || track.id == only) paint(track);
    };
    each(layers_.region_of_interest, [&](const Track& track) {
        // One box per picture says where the tracker looks; those of every track would hide the echoes.
        // Where one is lost, the box is most of the sea.
        if ((track.target || only != 0) && track.state != TrackState::Lost) paintRegionOfInterest(track);
    });
    each(layers_.history, [&](const Track& track) { paintHistory(track); });
    each(layers_.history, [&](const Track& track) { paintPrediction(track); });
    each(layers_.particles, [&](const Track& track) {
        if (track.state != TrackState::Lost) paintParticles(track);
    });
    each(layers_.ellipses, [&](const Track& track) {
        if (track.state != TrackState::Tentative && track.state != TrackState::Lost) paintEllipses(track);
    });
}

QStringList TrackPainter::labelOf(const Track& track) const {
    QStringList lines{Formatter::trackLabel(track.id, names_)};
    const double age = secondsBetween(track.last_seen, scene_.latest.time);
    if (track.state == TrackState::Lost) lines[0] += FanText::tr(" lost %1").arg(Formatter::age(age));
    if (track.state == TrackState::Coasting && !track.target) lines[0] += " " + Formatter::age(age);
    if (track.target && track.state != TrackState::Lost) {
        const Pose& pose = scene_.latest.pose;
        lines << Formatter::range(rangeOf(track, pose)) + " " + Formatter::relativeBearing(bearingOf(track, pose));
        lines << FanText::tr("seen %1 ago").arg(Formatter::age(age));
    }
    return lines;
}

void TrackPainter::paintLabel(const Track& track, QPointF centre, QList<QRectF>& taken) {
    const QStringList lines = labelOf(track);
    const QFontMetricsF strong(bold_, painter_.device());
    const QFontMetricsF normal(plain_, painter_.device());
    double width = keptWidth(painter_, bold_, lines[0]);
    for (const QString& line : lines.mid(1)) width = std::max(width, keptWidth(painter_, plain_, line));
    const double height = strong.height() + normal.height() * static_cast<double>(lines.size() - 1);
    const double away = px(16.0);
    // Right above first; elsewhere where another label lies already.
    const std::array<QPointF, 4> corners{QPointF(centre.x() + away, centre.y() - away - strong.height() / 2.0),
                                         QPointF(centre.x() + away, centre.y() + away * 0.5),
                                         QPointF(centre.x() - away - width, centre.y() - away - strong.height() / 2.0),
                                         QPointF(centre.x() - away - width, centre.y() + away * 0.5)};
    const bool large = lines.size() > 1;
    QRectF box(corners[large ? 1 : 0], QSizeF(width, height));
    for (const QPointF& corner : corners) {
        const bool free =
            std::none_of(taken.begin(), taken.end(), [&](const QRectF& other) { return other.intersects(box); });
        if (free) break;
        box.moveTopLeft(corner);
    }
    taken << box;
    const bool lost = track.state == TrackState::Lost;
    painter_.setFont(bold_);
    textWithHalo(painter_, {box.x(), box.y() + strong.ascent()}, lines[0], lost ? palette_.danger : palette_.track,
                 palette_.halo);
    painter_.setFont(plain_);
    double y = box.y() + strong.height() + normal.ascent();
    for (const QString& line : lines.mid(1)) {
        textWithHalo(painter_, {box.x(), y}, line, palette_.mark, palette_.halo);
        y += normal.height();
    }
}

void TrackPainter::paintSymbols(int selected) {
    if (!layers_.tracks) return;
    SymbolPainter symbols(painter_, palette_, metrics_.scale());
    QList<QRectF> taken;
    for (const bool target : {true, false}) {  // the target's label has the first choice of place
        for (const Track& track : scene_.tracks) {
            if (track.target != target) continue;
            const QPointF centre = geometry_.toScreen(Eigen::Vector2d(track.estimate.mean.head<2>()));
            const double speed = track.estimate.mean.tail<2>().norm();
            TargetSymbol symbol{track.state, track.target, track.id == selected, motionAngle(track, geometry_), 0.0};
            symbol.vector_px = std::min(speed * vector_seconds * geometry_.px_per_m, px(most_vector_px));
            symbols.target(centre, symbol);
            paintLabel(track, centre, taken);
        }
    }
}

}  // namespace echotrail
