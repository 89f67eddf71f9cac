#include "ui/chart/area_model.hpp"
#include "ui/chart/chart_store.hpp"
#include "ui/chart/guard_watch.hpp"
#include "ui/chart/mark_model.hpp"
#include "ui/main_window/dock_title.hpp"
#include "ui/main_window/main_window.hpp"
#include "ui/panels/chart/chart_panel.hpp"
#include "ui/panels/parameters/parameter_panel.hpp"
#include "ui/style/formatter.hpp"
#include "ui/views/fan_view.hpp"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QClipboard>
#include <QMenuBar>
#include <QSettings>

// What the operator lays on the sea: marks, measures, areas; and how the fan lies on the screen.

namespace echotrail {

void MainWindow::makeChart() {
    marks_ = new MarkModel(chart_undo_, this);
    areas_ = new AreaModel(chart_undo_, this);
    guards_ = new GuardWatch(*areas_, this);
    fan_->setChart(*marks_, *areas_);
    connect(fan_, &FanView::said, this, &MainWindow::say);
    connect(marks_, &MarkModel::changed, this, &MainWindow::keepChart);
    connect(areas_, &AreaModel::changed, this, &MainWindow::keepChart);
    openChart();
}

void MainWindow::makeChartDock() {
    chart_ = new ChartPanel(*marks_, *areas_, this);
    chart_dock_ = makeDock("chart", chart_, this);
    addDockWidget(Qt::LeftDockWidgetArea, chart_dock_);
    tabifyDockWidget(layers_dock_, chart_dock_);
    layers_dock_->raise();
    connect(chart_, &ChartPanel::markRequested, this, &MainWindow::setMark);
    connect(chart_, &ChartPanel::areaRequested, this, &MainWindow::drawArea);
}

void MainWindow::makeChartMenu() {
    QMenu& menu = *menuBar()->addMenu(tr("&Chart"));
    const auto add = [&](const QString& text, const QKeySequence& key, const QString& tip, std::function<void()> act) {
        QAction* action = addAction(menu, text, key, tip, std::move(act));
        need_source_.push_back(action);
        return action;
    };
    QAction* measure = add(tr("Mea&sure"), QKeySequence("F4"),
                           tr("Range and bearing from one place to another: drag, or click both"), [this] {
                               fan_->setMeasuring(!fan_->measures());
                               if (fan_->measures())
                                   say(tr("Click two places, or drag from one to the other; Esc puts the measure away."),
                                       true);
                           });
    followFan(*measure, [](const FanView& fan) { return fan.measures(); });
    add(tr("&Mark"), QKeySequence("M"), tr("Mark the moment and the place under the cursor, else the target"),
        [this] { setMark(); });
    menu.addSeparator();
    add(tr("&Guard zone…"), QKeySequence("G"), tr("Draw a zone that confirmed tracks are told of in"),
        [this] { drawArea(Area::Kind::Guard); });
    add(tr("&Veto area…"), QKeySequence("V"),
        tr("Draw an area in which guard zones stay silent; the tracker goes on in it"),
        [this] { drawArea(Area::Kind::Veto); });
    menu.addSeparator();
    add(tr("&Copy the cursor's place"), QKeySequence("Ctrl+Shift+C"),
        tr("Decimal degrees where they are known, else metres north and east"), [this] {
            const QString text = fan_->cursorText();
            if (text.isEmpty()) return say(tr("Put the cursor on the fan first."), false);
            QApplication::clipboard()->setText(text);
            say(tr("Copied: %1").arg(text), true);
        });
}

void MainWindow::makeOrientationMenu(QMenu& menu) {
    auto* orientation = new QActionGroup(&menu);
    const auto orient = [&](const QString& title, Orientation which) {
        auto* action = addAction(menu, title, {}, tr("Turn the fan; where an input is missing the fan says which"),
                                 [this, which] { fan_->setOrientation(which); });
        action->setActionGroup(orientation);
        followFan(*action, [which](const FanView& fan) { return fan.orientation() == which; });
    };
    orient(tr("&Head up"), Orientation::HeadUp);
    orient(tr("North &up"), Orientation::NorthUp);
    orient(tr("&Course up"), Orientation::CourseUp);
    addAction(menu, tr("Ne&xt orientation"), QKeySequence("N"), tr("Head up, north up, course up in turn"), [this] {
        const Orientation now = fan_->orientation();
        fan_->setOrientation(now == Orientation::HeadUp    ? Orientation::NorthUp
                             : now == Orientation::NorthUp ? Orientation::CourseUp
                                                           : Orientation::HeadUp);
    });
    menu.addSeparator();
    addAction(menu, tr("Off-centre &to the cursor"), QKeySequence("O"),
              tr("Move what is under the cursor into the middle; 0 takes it back"), [this] { fan_->centreOnCursor(); });
}

/// One undo for whatever was done last: a parameter or something drawn.
void MainWindow::addUndo(QMenu& menu) {
    if (undo_.stacks().isEmpty()) {
        for (QUndoStack* stack : {&parameters_->model().undoStack(), &chart_undo_}) {
            undo_.addStack(stack);
            connect(stack, &QUndoStack::indexChanged, this, [stack] { stack->setActive(); });
        }
        parameters_->model().undoStack().setActive();
    }
    auto* undo = addAction(menu, tr("&Undo"), QKeySequence("Ctrl+Z"),
                           tr("Take back the last change of a parameter, a mark or an area"), [this] { undo_.undo(); });
    auto* redo = addAction(menu, tr("&Redo"), QKeySequence("Ctrl+Shift+Z"), tr("Do again what was taken back"),
                           [this] { undo_.redo(); });
    undo->setEnabled(undo_.canUndo());
    redo->setEnabled(undo_.canRedo());
    connect(&undo_, &QUndoGroup::canUndoChanged, undo, &QAction::setEnabled);
    connect(&undo_, &QUndoGroup::canRedoChanged, redo, &QAction::setEnabled);
}

void MainWindow::setMark() {
    const int number = fan_->setMark();
    if (number == 0) return say(tr("No mark was set: nothing is open, or there are too many."), false);
    say(tr("Mark M%1 set; give it a text under Chart, or take it back with Ctrl+Z.").arg(number), true);
    if (!chart_dock_->visibleRegion().isEmpty()) chart_->editMark(number);
}

void MainWindow::drawArea(Area::Kind kind) {
    fan_->drawArea(kind);
    if (fan_->drawsArea()) say(tr("Click the corners on the fan; Enter closes the area, Esc gives it up."), true);
}

/// Names whose local frame the ground is in; a live run begins a new one every time.
QString MainWindow::chartSource() const {
    return bridge_.isOpen() && !bridge_.isLive() ? QString::fromStdString(bridge_.info().name) : QString();
}

void MainWindow::openChart() {
    opening_chart_ = true;
    Chart chart;
    if (options_.remember) {
        QSettings settings;
        chart = loadChart(settings, chartSource());
    }
    marks_->replace(chart.marks);
    areas_->replace(chart.areas);
    chart_undo_.clear();
    guards_->clear();
    opening_chart_ = false;
}

void MainWindow::keepChart() {
    if (opening_chart_ || !options_.remember) return;
    QSettings settings;
    saveChart(settings, chartSource(), {marks_->marks(), areas_->areas()});
}

}  // namespace echotrail
