#include "ui/chart/area_model.hpp"
#include "ui/chart/mark_model.hpp"
#include "ui/style/formatter.hpp"
#include "ui/style/ui_metrics.hpp"
#include "ui/views/fan_view.hpp"
#include "ui/views/track_painter.hpp"

#include <QApplication>
#include <QKeyEvent>

// The hands and keys that measure, mark, and draw areas.

namespace echotrail {
namespace {

constexpr double reach = 7.0;  ///< a corner or an end this near to the hand is meant, px at scale 1

}  // namespace

void FanView::setChart(MarkModel& marks, AreaModel& areas) {
    marks_ = &marks;
    areas_ = &areas;
    connect(&marks, &MarkModel::changed, this, qOverload<>(&FanView::update));
    connect(&areas, &AreaModel::changed, this, &FanView::showAreas);
    showAreas();
}

void FanView::showAreas() {
    held_corner_.reset();
    shown_areas_ = areas_->areas();
    update();
}

void FanView::refreshMoving() {
    moving_ = {};
    if (layers_.moving && scene_ && scene_->remembered) moving_ = withoutBackground(scene_->fan, *scene_->remembered);
}

std::optional<Eigen::Vector2d> FanView::cursorPlace() const {
    if (!cursor_ || !scene_ || scene_->position == 0) return std::nullopt;
    return geometry().toLocal(*cursor_);
}

QString FanView::cursorText() const {
    const auto place = cursorPlace();
    if (!place) return {};
    const auto decimal = [](double value, int decimals) { return QString::number(value, 'f', decimals); };
    if (const auto& plane = scene_->plane) {
        const GeographicPosition there = plane->toGeographic({place->x(), place->y()});
        return decimal(degreesFromRadians(there.latitude_rad), 7) + ", " +
               decimal(degreesFromRadians(there.longitude_rad), 7);
    }
    return "N " + decimal(place->x(), 2) + " m, E " + decimal(place->y(), 2) + " m";
}

int FanView::setMark() {
    if (!marks_ || !scene_ || scene_->position == 0) return 0;
    Eigen::Vector2d place(scene_->latest.pose.north_m, scene_->latest.pose.east_m);
    for (const Track& track : scene_->tracks)
        if (track.target || track.id == selected_track_) {
            place = track.estimate.mean.head<2>();
            if (track.target) break;
        }
    return marks_->add(cursorPlace().value_or(place), scene_->latest.time);
}

void FanView::centreOnCursor() {
    if (!cursor_ || !scene_) return;
    pan_ += QRectF(rect()).center() - *cursor_;
    update();
}

void FanView::drawArea(Area::Kind kind) {
    if (!areas_ || !scene_) return;
    setMeasuring(false);
    draft_ = AreaDraft{kind, {}};
    setFocus(Qt::OtherFocusReason);
    update();
}

bool FanView::grabCorner(QPointF place) {
    if (!areas_ || !scene_) return false;
    const FanGeometry view = geometry();
    double nearest = UiMetrics(font()).length(reach);
    for (int row = 0; row < static_cast<int>(shown_areas_.size()); ++row) {
        const Area& area = shown_areas_[row];
        if (!(area.kind == Area::Kind::Guard ? layers_.guard_zones : layers_.vetoes)) continue;
        for (std::size_t i = 0; i < area.corners_m.size(); ++i) {
            const QPointF corner = view.toScreen(placeOf(area, area.corners_m[i], scene_->latest.pose));
            if (QLineF(place, corner).length() > nearest) continue;
            nearest = QLineF(place, corner).length();
            held_corner_ = HeldCorner{row, static_cast<int>(i)};
        }
    }
    return held_corner_.has_value();
}

void FanView::pressMeasure(QPointF place) {
    const FanGeometry view = geometry();
    const Eigen::Vector2d ground = view.toLocal(place);
    measure_pressed_ = place;
    if (measurement_ && !measurement_open_) {
        const double within = UiMetrics(font()).length(reach);
        const bool at_from = QLineF(view.toScreen(measurement_->from), place).length() <= within;
        const bool at_to = QLineF(view.toScreen(measurement_->to), place).length() <= within;
        if (at_from && !at_to) std::swap(measurement_->from, measurement_->to);
        if (at_from || at_to) return;
    }
    if (measurement_open_) {
        measurement_->to = ground;
        measurement_open_ = false;
    } else {
        measurement_ = Measurement{ground, ground};
        measurement_open_ = true;
    }
}

bool FanView::pressChart(QPointF place) {
    if (draft_ || !scene_ || scene_->position == 0) return false;
    if (measuring_) {
        pressMeasure(place);
        update();
        return true;
    }
    return grabCorner(place);
}

bool FanView::moveChart(QPointF place) {
    const Eigen::Vector2d ground = geometry().toLocal(place);
    if (measurement_ && (measurement_open_ || measure_pressed_)) {
        measurement_->to = ground;
        return true;
    }
    if (!held_corner_) return false;
    Area& area = shown_areas_[held_corner_->area];
    area.corners_m[static_cast<std::size_t>(held_corner_->corner)] =
        cornerAt(area, ground.cast<float>(), scene_->latest.pose);
    return true;
}

bool FanView::releaseChart(QPointF place) {
    if (measure_pressed_) {
        const QPointF way = place - *measure_pressed_;
        if (way.manhattanLength() >= QApplication::startDragDistance()) measurement_open_ = false;
        measure_pressed_.reset();
        return true;
    }
    if (!held_corner_) return false;
    const HeldCorner held = *held_corner_;
    held_corner_.reset();
    const Eigen::Vector2f at = shown_areas_[held.area].corners_m[static_cast<std::size_t>(held.corner)];
    if (at != areas_->areas()[held.area].corners_m[static_cast<std::size_t>(held.corner)])
        areas_->setCorner(held.area, held.corner, at);
    return true;
}

/// Pressed and let go at one place.
bool FanView::clickChart(QPointF place) {
    if (!draft_) return false;
    const FanGeometry view = geometry();
    const bool closes =
        draft_->corners_m.size() >= 3 &&
        QLineF(view.toScreen(draft_->corners_m.front()), place).length() <= UiMetrics(font()).length(reach);
    if (closes)
        finishDraft();
    else if (draft_->corners_m.size() < AreaModel::most_corners)
        draft_->corners_m.push_back(view.toLocal(place));
    update();
    return true;
}

/// A guard zone goes with the vehicle, a veto area stays on the ground: the list changes that.
void FanView::finishDraft() {
    Area area{draft_->kind, {}, draft_->kind == Area::Kind::Guard, {}};
    for (const Eigen::Vector2d& corner : draft_->corners_m)
        area.corners_m.push_back(cornerAt(area, corner.cast<float>(), scene_->latest.pose));
    if (area.corners_m.size() < 3) return Q_EMIT said(tr("An area needs three corners; Esc gives it up."), false);
    draft_.reset();
    if (!areas_->add(area))
        return Q_EMIT said(tr("There are %1 areas already; delete one first.").arg(AreaModel::most_areas), false);
    Q_EMIT said(tr("Drawn: %1. Drag its corners; rename or delete it under Chart.")
                    .arg(QString::fromStdString(areas_->areas().back().name)),
                true);
}

bool FanView::chartKey(const QKeyEvent& event) {
    const bool escape = event.key() == Qt::Key_Escape;
    if (escape && held_corner_) {
        showAreas();
    } else if (escape && measuring_) {
        setMeasuring(false);
    } else if (escape && draft_) {
        draft_.reset();
    } else if (draft_ && event.key() == Qt::Key_Backspace) {
        if (!draft_->corners_m.empty()) draft_->corners_m.pop_back();
    } else if (draft_ && (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter)) {
        finishDraft();
    } else {
        return false;
    }
    update();
    return true;
}

}  // namespace echotrail
