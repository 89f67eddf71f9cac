#include "ui/style/ui_metrics.hpp"
#include "ui/views/fan_view.hpp"

#include <QKeyEvent>

// The hands and keys that move the edges of the sector.

namespace echotrail {
namespace {

constexpr int quick_steps = 10;

}  // namespace

void FanView::setWholeSector(const std::optional<CommandedSector>& whole) {
    if (whole == whole_sector_) return;
    whole_sector_ = whole;
    update();
}

void FanView::setSector(const std::optional<CommandedSector>& commanded, bool confirmed) {
    if (sector_.show(commanded, confirmed)) update();
}

void FanView::editSector() {
    if (!sector_.areThere()) return;
    setFocus(Qt::OtherFocusReason);
    sector_.take(SectorEdge::Right);
    update();
}

bool FanView::grabSector(QPointF place) {
    if (!scene_ || scene_->position == 0) return false;
    const FanGeometry view = geometry();
    const auto edge = sector_.at(place, view, rect(), UiMetrics(font()).scale());
    if (edge) sector_.take(*edge, view.bearingOf(place));
    showHand();
    update();
    return edge.has_value();
}

void FanView::finishSector() {
    const auto chosen = sector_.finish();
    showHand();
    update();
    if (chosen) Q_EMIT sectorChosen(*chosen);
}

bool FanView::sectorKey(const QKeyEvent& event) {
    const int steps = event.modifiers().testFlag(Qt::ShiftModifier) ? quick_steps : 1;
    switch (event.key()) {
        case Qt::Key_Left:
            sector_.step(-steps);
            break;
        case Qt::Key_Right:
            sector_.step(steps);
            break;
        case Qt::Key_Escape:
            sector_.cancel();
            break;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            finishSector();
            return true;
        default:
            return false;
    }
    showHand();
    update();
    return true;
}

/// Tab takes the other edge while keys move one.
bool FanView::focusNextPrevChild(bool next) {
    if (!sector_.isHeld() || sector_.isDragged()) return QWidget::focusNextPrevChild(next);
    sector_.take(sector_.heldEdge() == SectorEdge::Left ? SectorEdge::Right : SectorEdge::Left);
    update();
    return true;
}

void FanView::focusOutEvent(QFocusEvent* event) {
    // Keys that no longer come here cannot end the edit.
    if (!sector_.isDragged()) sector_.cancel();
    QWidget::focusOutEvent(event);
    update();
}

void FanView::showHand() {
    const bool over = cursor_ && scene_ && sector_.at(*cursor_, geometry(), rect(), UiMetrics(font()).scale());
    setCursor(sector_.isDragged() ? Qt::ClosedHandCursor : over ? Qt::OpenHandCursor : Qt::BlankCursor);
}

}  // namespace echotrail
