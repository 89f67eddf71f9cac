#include "ui/views/fan_view.hpp"

#include "ui/chart/area_model.hpp"
#include "ui/chart/mark_model.hpp"
#include "ui/language/language.hpp"
#include "ui/style/ui_metrics.hpp"
#include "ui/views/orientation.hpp"
#include "ui/views/symbol_painter.hpp"
#include "ui/views/track_painter.hpp"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <cmath>

namespace echotrail {
namespace {

constexpr double most_zoom = 40.0;
constexpr double zoom_per_notch = 1.2;
constexpr double wheel_notch = 120.0;
constexpr double region_reach = 6.0;  ///< a click this near to a region's outline box means the region, px at scale 1

/// Room about the sector for the age ring, labels and the lower badges, at scale 1.
QMarginsF sectorMargins(const UiMetrics& metrics) { return QMarginsF(44.0, 58.0, 44.0, 22.0) * metrics.scale(); }

}  // namespace

FanView::FanView(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::BlankCursor);  // the fan has a cursor of its own that shows on every echo level
    inEveryLanguage(this, [this] { setAccessibleName(tr("Fan")); });
}

QSize FanView::sizeHint() const {
    const UiMetrics metrics(font());
    return {metrics.pixels(960.0), metrics.pixels(720.0)};
}

QSize FanView::minimumSizeHint() const {
    const UiMetrics metrics(font());
    return {metrics.pixels(240.0), metrics.pixels(200.0)};
}

void FanView::setScene(std::shared_ptr<const Scene> scene) {
    scene_ = std::move(scene);
    ++serial_;
    ages_ = scene_ ? beamAges(*scene_, sectorOf(*scene_)) : BeamAges{};
    refreshMoving();
    if (!scene_) {  // what the hand holds was on ground that is gone
        draft_.reset();
        held_corner_.reset();
        measurement_.reset();
        measurement_open_ = false;
        measure_pressed_.reset();
        if (areas_) shown_areas_ = areas_->areas();
    }
    update();
}

void FanView::announce() {
    update();
    Q_EMIT settingsChanged();
}

void FanView::setLayers(const Layers& layers) {
    if (layers == layers_) return;
    layers_ = layers;
    refreshMoving();
    announce();
}

void FanView::setEcho(const EchoSettings& echo) {
    if (echo == echo_) return;
    echo_ = echo;
    announce();
}

void FanView::setOrientation(Orientation orientation) {
    if (orientation == orientation_) return;
    orientation_ = orientation;
    announce();
}

void FanView::setFollow(bool on) {
    if (on == follow_) return;
    follow_ = on;
    const FanGeometry fit = fittedGeometry();
    if (on)
        anchor_.reset();
    else
        anchor_ = Eigen::Vector2d(fit.north_m, fit.east_m);
    announce();
}

void FanView::setMeasuring(bool on) {
    if (on == measuring_) return;
    measuring_ = on;
    measurement_.reset();
    measurement_open_ = false;
    measure_pressed_.reset();
    announce();
}

void FanView::resetView() {
    zoom_ = 1.0;
    pan_ = {};
    if (anchor_ && scene_) anchor_ = Eigen::Vector2d(scene_->latest.pose.north_m, scene_->latest.pose.east_m);
    update();
}

void FanView::setSelectedTrack(int id) {
    if (id == selected_track_) return;
    selected_track_ = id;
    update();
}

Sector FanView::sectorToShow() const {
    Sector shown = sectorToFit(*scene_);
    if (!whole_sector_ || radiansFromDegrees(whole_sector_->width_deg) <= shown.width_rad) return shown;
    shown.left = whole_sector_->edge(SectorEdge::Left);
    shown.width_rad = radiansFromDegrees(whole_sector_->width_deg);
    return shown;
}

FanGeometry FanView::fittedGeometry() const {
    if (!scene_) return {};
    FanGeometry fit = fitted(scene_->latest.pose, upOf(*scene_, orientation_), sectorToShow(), rect(),
                             sectorMargins(UiMetrics(font())));
    fit.sector = sectorOf(*scene_);
    return fit;
}

FanGeometry FanView::geometry() const {
    FanGeometry view = fittedGeometry();
    const QPointF middle = QRectF(rect()).center();
    view.head_px = middle + (view.head_px - middle) * zoom_ + pan_;
    view.px_per_m *= zoom_;
    if (anchor_) view.head_px += view.head_px - view.toScreen(*anchor_);
    return view;
}

FanMoment FanView::moment() const {
    FanMoment moment;
    moment.scene = scene_.get();
    moment.serial = serial_;
    moment.ages = &ages_;
    moment.geometry = geometry();
    moment.layers = layers_;
    moment.echo = echo_;
    moment.orientation = orientation_;
    moment.follow = follow_;
    moment.zoom = zoom_;
    moment.selected_track = selected_track_;
    moment.cursor = cursor_;
    moment.measuring = measuring_;
    moment.measurement = measurement_;
    moment.sector = &sector_;
    moment.off_centre = isOffCentre();
    if (layers_.moving && scene_) moment.moving = &moving_;
    if (marks_) moment.marks = &marks_->marks();
    moment.areas = &shown_areas_;
    moment.draft = draft_;
    moment.track_names = track_names_;
    return moment;
}

void FanView::setTrackNames(const TrackNames& names) {
    track_names_ = names;
    update();
}

void FanView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    picture_.paint(painter, size(), moment(), font());
}

void FanView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange ||
        event->type() == QEvent::StyleChange)
        update();
    QWidget::changeEvent(event);
}

void FanView::zoomAbout(QPointF place, double factor) {
    const double zoom = std::clamp(zoom_ * factor, 1.0, most_zoom);
    const QPointF before = geometry().head_px;
    const double ratio = zoom / zoom_;
    zoom_ = zoom;
    if (zoom_ == 1.0) {
        pan_ = {};
    } else {
        pan_ += place + (before - place) * ratio - geometry().head_px;
    }
    update();
}

void FanView::wheelEvent(QWheelEvent* event) {
    zoomAbout(event->position(), std::pow(zoom_per_notch, event->angleDelta().y() / wheel_notch));
    event->accept();
}

void FanView::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::MiddleButton) return resetView();
    if (event->button() != Qt::LeftButton) return QWidget::mousePressEvent(event);
    if (grabSector(event->position()) || pressChart(event->position())) return;
    pressed_ = event->position();
    dragged_from_ = pan_;
    dragging_ = false;
}

void FanView::mouseMoveEvent(QMouseEvent* event) {
    cursor_ = event->position();
    if (sector_.isDragged()) sector_.drag(geometry().bearingOf(event->position()));
    showHand();
    if (pressed_) {
        const QPointF way = event->position() - *pressed_;
        if (way.manhattanLength() >= QApplication::startDragDistance()) dragging_ = true;
        if (dragging_) pan_ = dragged_from_ + way;
    }
    moveChart(event->position());
    update();
    Q_EMIT cursorMoved();
}

void FanView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && sector_.isDragged()) return finishSector();
    if (event->button() == Qt::LeftButton && releaseChart(event->position())) return;
    if (event->button() != Qt::LeftButton || !pressed_) return QWidget::mouseReleaseEvent(event);
    pressed_.reset();
    if (dragging_ || !scene_ || scene_->position == 0) return;
    if (!clickChart(event->position())) pointAt(event->position(), event->modifiers().testFlag(Qt::ControlModifier));
}

void FanView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (draft_ && event->button() == Qt::LeftButton) return finishDraft();
    const FanGeometry view = geometry();
    if (event->button() == Qt::LeftButton && view.rangeOf(event->position()) > view.sector.range_m) resetView();
}

void FanView::keyPressEvent(QKeyEvent* event) {
    if (sector_.isHeld() && sectorKey(*event)) return;
    if (chartKey(*event)) return;
    QWidget::keyPressEvent(event);
}

void FanView::leaveEvent(QEvent*) {
    cursor_.reset();
    update();
    Q_EMIT cursorMoved();
}

int FanView::trackAt(QPointF place) const {
    const FanGeometry view = geometry();
    double nearest = UiMetrics(font()).length(SymbolPainter::steady_radius + 5.0);
    int found = 0;
    for (const Track& track : scene_->tracks) {
        const double away = QLineF(place, view.toScreen(Eigen::Vector2d(track.estimate.mean.head<2>()))).length();
        if (away > nearest) continue;
        nearest = away;
        found = track.id;
    }
    return found;
}

void FanView::pointAt(QPointF place, bool select_only) {
    const FanGeometry view = geometry();
    const int track = trackAt(place);
    if (track != 0 || select_only) {
        setSelectedTrack(track);
        Q_EMIT trackSelected(track);
    }
    if (select_only || view.rangeOf(place) > view.sector.range_m) return;
    for (const Track& candidate : scene_->tracks)
        if (candidate.id == track) {
            Q_EMIT designated(rangeOf(candidate, scene_->latest.pose), bearingOf(candidate, scene_->latest.pose));
            return;
        }
    if (!view.sector.contains(view.bearingOf(place))) return;
    const double reach = UiMetrics(font()).length(region_reach);
    for (const Region& region : scene_->regions) {
        QPolygonF outline;
        for (const Eigen::Vector2f& corner : region.outline_m) outline << view.toScreen(corner);
        if (!outline.boundingRect().adjusted(-reach, -reach, reach, reach).contains(place)) continue;
        place = view.toScreen(region.position_m);
        break;
    }
    Q_EMIT designated(view.rangeOf(place), view.bearingOf(place));
}

}  // namespace echotrail
