#include "ui/main_window/dock_title.hpp"
#include "ui/main_window/main_window.hpp"
#include "ui/main_window/status_bar.hpp"
#include "ui/panels/connection/connection_panel.hpp"
#include "ui/panels/parameters/parameter_panel.hpp"

#include <QAction>
#include <QDockWidget>
#include <QMenuBar>
#include <utility>

namespace echotrail {

void MainWindow::makeConnectionDock() {
    connection_ = new ConnectionPanel(bridge_, options_.remember, this);
    connection_dock_ = makeDock("connection", tr("Sonar"), connection_, this);
    addDockWidget(Qt::LeftDockWidgetArea, connection_dock_);
    tabifyDockWidget(connection_dock_, layers_dock_);
    connect(connection_, &ConnectionPanel::headEdited, parameters_, &ParameterPanel::enter);
    connect(connection_, &ConnectionPanel::summaryChanged, this,
            [this](const QString& summary) { setSummary(connection_dock_, summary); });
    connect(&bridge_, &PipelineBridge::connectFailed, this,
            [this](const QString& reason) { say(tr("Not connected: %1.").arg(reason), false); });
    connect(&parameters_->model(), &ParameterModel::refused, this, [this](const QString& reason) {
        if (connection_->isAncestorOf(focusWidget())) say(reason, false);
    });
}

void MainWindow::makeSonarMenu() {
    QMenu& menu = *menuBar()->addMenu(tr("&Sonar"));
    addAction(menu, tr("&Connect…"), QKeySequence("Ctrl+L"), [this] { askForHead(); })->setEnabled(bridge_.canGoLive());
    disconnect_ = addAction(menu, tr("&Disconnect"), {}, [this] { bridge_.close(); });
}

void MainWindow::askForHead() {
    connection_dock_->show();
    connection_dock_->raise();
    connection_->focusAddress();
}

void MainWindow::onLive(const LiveState& state) {
    status_->showLive(state, bridge_.params().navigation.longest_navigation_gap_s);
    const std::string& failure = state.run.recorder.error;
    if (!failure.empty() && !std::exchange(recording_failure_told_, true))
        say(tr("Recording has ended: %1. Make room and connect again.").arg(QString::fromStdString(failure)), false);
}

}  // namespace echotrail
