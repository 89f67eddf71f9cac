#include "ui/chart/mark_model.hpp"
#include "ui/main_window/dock_title.hpp"
#include "ui/main_window/main_window.hpp"
#include "ui/panels/beam/beam_panel.hpp"
#include "ui/panels/plan/plan_view.hpp"
#include "ui/panels/tracks/tracks_panel.hpp"
#include "ui/views/fan_view.hpp"

#include <QAction>
#include <QFileDialog>
#include <QMenu>
#include <QSaveFile>

// The docks beside the fan that show the same scene in another way: one beam, and the paths from above.

namespace echotrail {

void MainWindow::makeBeamAndPlan() {
    beam_ = new BeamPanel(this);
    plan_ = new PlanView(this);
    beam_dock_ = makeDock("beam", beam_, this);
    plan_dock_ = makeDock("plan", plan_, this);
    addDockWidget(Qt::BottomDockWidgetArea, beam_dock_);
    tabifyDockWidget(time_line_dock_, beam_dock_);
    time_line_dock_->raise();
    addDockWidget(Qt::RightDockWidgetArea, plan_dock_);
    tabifyDockWidget(parameters_dock_, plan_dock_);
    tracks_dock_->raise();
    connect(beam_, &BeamPanel::summaryChanged, this,
            [this](const QString& summary) { setSummary(beam_dock_, summary); });
    connect(fan_, &FanView::cursorMoved, this, [this] { beam_->setCursor(fan_->cursorPlace()); });
    connect(marks_, &MarkModel::changed, this, [this] { plan_->setMarks(marks_->marks()); });
    plan_->setMarks(marks_->marks());
    const auto select = [this](int id) {
        beam_->setSelectedTrack(id);
        plan_->setSelectedTrack(id);
    };
    connect(tracks_, &TracksPanel::trackSelected, this, select);
    connect(fan_, &FanView::trackSelected, this, select);
}

QList<QDockWidget*> MainWindow::docks() const {
    return {connection_dock_, layers_dock_, chart_dock_,     tracks_dock_, parameters_dock_,
            plan_dock_,       alerts_dock_, time_line_dock_, beam_dock_,   manual_dock_};
}

void MainWindow::addDockKeys(QMenu& menu) {
    menu.addSeparator();
    const auto bring = [&](const QString& text, const QKeySequence& key, QDockWidget* dock, QDockWidget* other,
                           const QString& tip) {
        // The same key goes back to what shares the place.
        addAction(menu, text, key, tip, [dock, other] {
            const bool in_front = dock->isVisible() && !dock->visibleRegion().isEmpty();
            QDockWidget* next = in_front ? other : dock;
            next->show();
            next->raise();
        });
    };
    bring(tr("&Beam to the front"), QKeySequence("B"), beam_dock_, time_line_dock_,
          tr("Level over range of the beam under the cursor, with the detection threshold"));
    bring(tr("&Plan to the front"), QKeySequence("P"), plan_dock_, tracks_dock_,
          tr("Paths of the vehicle and the tracks from above, north up"));
    need_source_.push_back(addAction(menu, tr("&Export the plan…"), QKeySequence("Ctrl+E"),
                                     tr("Write the paths as CSV, or the plan as a PNG picture"),
                                     [this] { exportPlan(); }));
}

void MainWindow::exportPlan() {
    const QString path =
        QFileDialog::getSaveFileName(this, tr("Export the plan"), "paths.csv", tr("Paths (*.csv);;Picture (*.png)"),
                                     nullptr, QFileDialog::DontUseNativeDialog);
    if (path.isEmpty()) return;
    QSaveFile file(path);
    bool written = file.open(QIODevice::WriteOnly);
    if (path.endsWith(".png", Qt::CaseInsensitive))
        written = written && plan_->grab().save(&file, "PNG");
    else
        written = written && file.write(plan_->csv()) >= 0;
    written = written && file.commit();
    say(written ? tr("Plan written to %1.").arg(path)
                : tr("The plan could not be written to %1: %2. Choose another folder.").arg(path, file.errorString()),
        written);
}

}  // namespace echotrail
