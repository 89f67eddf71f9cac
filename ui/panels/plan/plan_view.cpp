#include "ui/panels/plan/plan_view.hpp"

#include "ui/language/language.hpp"
#include "ui/style/formatter.hpp"
#include "ui/style/ui_metrics.hpp"
#include "ui/views/graticule_painter.hpp"
#include "ui/views/halo.hpp"
#include "ui/views/symbol_painter.hpp"

#include <QEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <utility>

namespace echotrail {
namespace {

constexpr double least_extent_m = 10.0;

}  // namespace

/// North and east on the widget.
struct PlanView::Map {
    QPointF origin;  ///< of the local frame, px
    double px_per_m = 1.0;

    QPointF at(double north, double east) const { return origin + QPointF(east, -north) * px_per_m; }
    QPointF at(const Eigen::Vector2f& place) const {
        return at(static_cast<double>(place.x()), static_cast<double>(place.y()));
    }
};

PlanView::PlanView(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    inEveryLanguage(this, [this] { setAccessibleName(tr("Plan")); });
}

QSize PlanView::sizeHint() const {
    const UiMetrics metrics(font());
    return {metrics.pixels(300.0), metrics.pixels(300.0)};
}

QSize PlanView::minimumSizeHint() const {
    const UiMetrics metrics(font());
    return {metrics.pixels(160.0), metrics.pixels(140.0)};
}

void PlanView::setScene(std::shared_ptr<const Scene> scene) {
    scene_ = std::move(scene);
    update();
}

void PlanView::setMarks(const QList<Mark>& marks) {
    marks_ = marks;
    update();
}

void PlanView::setSelectedTrack(int id) {
    selected_track_ = id;
    update();
}

/// In metres, east to the right and north up (as −y).
QRectF PlanView::extent() const {
    QRectF all;
    bool first = true;
    const auto take = [&](double north, double east) {
        const QPointF point(east, -north);
        if (std::exchange(first, false))
            all = QRectF(point, QSizeF(0, 0));
        else
            all = QRectF(QPointF(std::min(all.left(), point.x()), std::min(all.top(), point.y())),
                         QPointF(std::max(all.right(), point.x()), std::max(all.bottom(), point.y())));
    };
    for (const TimedPose& pose : scene_->paths->vehicle) take(pose.pose.north_m, pose.pose.east_m);
    for (const auto& [id, path] : scene_->paths->tracks)
        for (const Paths::Point& point : path)
            take(static_cast<double>(point.place_m.x()), static_cast<double>(point.place_m.y()));
    for (const Mark& mark : marks_) take(mark.place_m.x(), mark.place_m.y());
    const double more_x = std::max(0.0, least_extent_m - all.width()) / 2.0;
    const double more_y = std::max(0.0, least_extent_m - all.height()) / 2.0;
    return all.adjusted(-more_x, -more_y, more_x, more_y);
}

PlanView::Map PlanView::map() const {
    const QRectF metres = extent();
    const double edge = UiMetrics(font()).length(30.0);
    const QRectF box = QRectF(rect()).adjusted(edge, edge, -edge, -edge);
    Map map;
    map.px_per_m = std::max(1e-3, std::min(box.width() / metres.width(), box.height() / metres.height()));
    map.origin = box.center() - metres.center() * map.px_per_m;
    return map;
}

void PlanView::paintGrid(QPainter& painter, const Map& map) const {
    const Palette& palette = currentPalette();
    const UiMetrics metrics(font());
    painter.setFont(metrics.sized(font(), 10.0));
    const double step = ringStep(std::max(width(), height()) / map.px_per_m);
    QColor faint = palette.graticule;
    faint.setAlphaF(0.35F);
    const auto lines = [&](double origin, int length, bool upright) {
        for (int i = static_cast<int>(std::ceil(-origin / (step * map.px_per_m)));; ++i) {
            const double at = origin + i * step * map.px_per_m;
            if (at > length) break;
            painter.setPen(QPen(faint, 1.0));
            painter.drawLine(upright ? QLineF(at, 0, at, height()) : QLineF(0, at, width(), at));
            const QString words = Formatter::number((upright ? 1 : -1) * i * step, step < 1.0 ? 1 : 0);
            const QPointF place = upright ? QPointF(at + metrics.length(3.0), height() - metrics.length(4.0))
                                          : QPointF(metrics.length(4.0), at - metrics.length(3.0));
            textWithHalo(painter, place, words, palette.graticule, palette.halo);
        }
    };
    lines(map.origin.x(), width(), true);
    lines(map.origin.y(), height(), false);
    painter.setFont(metrics.sized(font(), 11.0, true));
    const QString north = tr("N ↑  grid %1").arg(Formatter::withUnit(step, step < 1.0 ? 1 : 0, "m"));
    const double wide = QFontMetricsF(painter.font(), this).horizontalAdvance(north);
    textWithHalo(painter, {width() - wide - metrics.length(8.0), metrics.length(16.0)}, north, palette.mark,
                 palette.halo);
}

void PlanView::paintTracks(QPainter& painter, const Map& map) const {
    const Palette& palette = currentPalette();
    const UiMetrics metrics(font());
    painter.setFont(metrics.sized(font(), 11.0, true));
    for (const auto& [id, path] : scene_->paths->tracks) {
        QPolygonF line;
        for (const Paths::Point& point : path) line << map.at(point.place_m);
        const auto now = std::find_if(scene_->tracks.begin(), scene_->tracks.end(),
                                      [id = id](const Track& track) { return track.id == id; });
        const bool there = now != scene_->tracks.end() && now->state != TrackState::Lost;
        QColor colour = palette.track;
        if (!there) colour.setAlphaF(0.45F);  // of the past
        QPainterPath drawn;
        drawn.addPolygon(line);
        strokeWithHalo(painter, drawn, {colour, metrics.length(id == selected_track_ ? 2.0 : 1.2)}, palette.halo);
        if (!there) continue;
        const QPointF end = map.at(now->estimate.mean.head<2>().cast<float>());
        SymbolPainter(painter, palette, metrics.scale() * 0.8)
            .target(end, {now->state, now->target, id == selected_track_, {}, 0.0});
        textWithHalo(painter, end + QPointF(metrics.length(11.0), -metrics.length(5.0)),
                     Formatter::trackLabel(id, track_names_), colour, palette.halo);
    }
}

void PlanView::paintVehicle(QPainter& painter, const Map& map) const {
    const Palette& palette = currentPalette();
    const UiMetrics metrics(font());
    QPolygonF line;
    for (const TimedPose& pose : scene_->paths->vehicle) line << map.at(pose.pose.north_m, pose.pose.east_m);
    QPainterPath path;
    path.addPolygon(line);
    strokeWithHalo(painter, path, {palette.mark, metrics.length(1.2)}, palette.halo);
    const Pose& now = scene_->latest.pose;
    SymbolPainter symbols(painter, palette, metrics.scale());
    symbols.ownShip(map.at(now.north_m, now.east_m), now.heading.inRadians());
    painter.setFont(metrics.sized(font(), 11.0));
    for (const Mark& mark : marks_) {
        const QPointF foot = map.at(mark.place_m.x(), mark.place_m.y());
        symbols.mark(foot);
        textWithHalo(painter, foot + QPointF(metrics.length(12.0), -metrics.length(6.0)), mark.label(), palette.mark,
                     palette.halo);
    }
}

void PlanView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Palette& palette = currentPalette();
    painter.fillRect(rect(), palette.canvas);
    if (isEmpty()) {
        painter.setPen(palette.graticule);
        painter.drawText(rect(), Qt::AlignCenter, tr("No paths yet"));
        return;
    }
    painter.setRenderHint(QPainter::Antialiasing);
    const Map here = map();
    paintGrid(painter, here);
    paintTracks(painter, here);
    paintVehicle(painter, here);
    if (scene_->navigation_known) return;
    painter.setPen(palette.caution);
    painter.drawText(rect().adjusted(8, 6, -8, -6), Qt::AlignTop | Qt::AlignLeft,
                     tr("No navigation: the vehicle\nis taken to lie still, bow north"));
}

void PlanView::setTrackNames(const TrackNames& names) {
    track_names_ = names;
    update();
}

QByteArray PlanView::csv() const {
    QByteArray text = "who,utc,north_m,east_m,heading_deg\n";
    if (isEmpty()) return text;
    const auto line = [&](const QByteArray& who, Timestamp time, double north, double east, const QByteArray& heading) {
        text += who + ',' + QByteArray::fromStdString(toIso8601(time)) + ',' + QByteArray::number(north, 'f', 3) + ',' +
                QByteArray::number(east, 'f', 3) + ',' + heading + '\n';
    };
    for (const TimedPose& pose : scene_->paths->vehicle) {
        const double heading = std::fmod(pose.pose.heading.inDegrees() + 360.0, 360.0);
        line("vehicle", pose.time, pose.pose.north_m, pose.pose.east_m,
             scene_->navigation_known ? QByteArray::number(heading, 'f', 2) : QByteArray());
    }
    for (const auto& [id, path] : scene_->paths->tracks)
        for (const Paths::Point& point : path)
            line(Formatter::trackId(id).toLatin1(), point.time, static_cast<double>(point.place_m.x()),
                 static_cast<double>(point.place_m.y()), {});
    return text;
}

void PlanView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) update();
    QWidget::changeEvent(event);
}

}  // namespace echotrail
