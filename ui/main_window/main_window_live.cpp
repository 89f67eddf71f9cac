#include "ui/main_window/dock_title.hpp"
#include "ui/main_window/main_window.hpp"
#include "ui/main_window/recent_recordings.hpp"
#include "ui/main_window/start_page.hpp"
#include "ui/main_window/status_bar.hpp"
#include "ui/panels/connection/connection_panel.hpp"
#include "ui/panels/parameters/parameter_panel.hpp"
#include "ui/views/fan_view.hpp"

#include <QAction>
#include <QDockWidget>
#include <QMenuBar>
#include <utility>

namespace echotrail {

void MainWindow::makeConnectionDock() {
    connection_ = new ConnectionPanel(bridge_, options_.remember, this);
    connection_dock_ = makeDock("connection", connection_, this);
    addDockWidget(Qt::LeftDockWidgetArea, connection_dock_);
    tabifyDockWidget(connection_dock_, layers_dock_);
    connect(connection_, &ConnectionPanel::headEdited, parameters_, &ParameterPanel::enter);
    connect(connection_, &ConnectionPanel::summaryChanged, this,
            [this](const QString& summary) { setSummary(connection_dock_, summary); });
    connection_->showOpen();
    connect(&bridge_, &PipelineBridge::connectFailed, this,
            [this](const QString& reason) { say(tr("Not connected: %1.").arg(reason), false); });
    connect(fan_, &FanView::sectorChosen, this, &MainWindow::commandSector);
    connect(&bridge_, &PipelineBridge::paramsChanged, this, &MainWindow::showSector);
    connect(&parameters_->model(), &ParameterModel::refused, this, [this](const QString& reason) {
        if (connection_->isAncestorOf(focusWidget())) say(reason, false);
    });
}

void MainWindow::makeSonarMenu() {
    QMenu& menu = *menuBar()->addMenu(tr("&Sonar"));
    addAction(menu, tr("&Connect…"), QKeySequence("Ctrl+L"),
              tr("To a sonar head by a serial port, TCP or UDP; its address is typed in the panel Sonar"),
              [this] { askForHead(); })
        ->setEnabled(bridge_.canGoLive());
    QMenu& simulated = *menu.addMenu(tr("Connect to a &simulated head"));
    simulated.setToolTipsVisible(true);
    simulated.setEnabled(bridge_.canGoLive() && !bridge_.simulatedHeads().isEmpty());
    for (const SimulatedHeadChoice& head : bridge_.simulatedHeads())
        addAction(simulated, head.title, {}, head.description, [this, address = head.address] {
            connection_->connectTo(address, {}, connection_->records());
        })->setToolTip(head.description);
    edit_sector_ = addAction(menu, tr("Set the s&ector on the fan"), QKeySequence("E"),
                             tr("Move its edges with the arrow keys; Enter commands the head, Esc gives up"),
                             [this] { fan_->editSector(); });
    disconnect_ = addAction(menu, tr("&Disconnect"), {}, tr("Ends the live run; its recording is closed"),
                            [this] { bridge_.close(); });
    makeTrackerMenu(menu);
}

void MainWindow::askForHead() {
    connection_dock_->show();
    connection_dock_->raise();
    connection_->focusAddress();
}

/// As the form has it now: what is on its way to the head is commanded already. A head that follows the target scans a
/// part of it.
void MainWindow::showSector() {
    const PipelineBridge::Params& params = bridge_.params();
    const bool follows = params.follow.follow_target;
    const HeadSettings& told = params.head;
    const CommandedSector whole{told.sector_centre_deg, told.sector_width_deg, told.step_deg};
    fan_->setWholeSector(follows ? std::optional(whole) : std::nullopt);
    if (!bridge_.isLive()) return fan_->setSector(std::nullopt, false);
    const seanet::HeadStatus& head = bridge_.liveState().head;
    const auto same = [&](const HeadSettings& other) {
        const ScanSector wanted = scanSector(told), scanned = scanSector(other);
        return (scanned == wanted || (follows && contains(wanted, scanned))) && other.step_deg == told.step_deg;
    };
    const bool confirmed = same(head.commanded) && head.confirmed && head.difference.empty();
    fan_->setSector(whole, confirmed);
}

void MainWindow::commandSector(const CommandedSector& sector) {
    PipelineBridge::Params params = bridge_.params();
    params.head.sector_centre_deg = sector.centre_deg;
    params.head.sector_width_deg = sector.width_deg;
    parameters_->model().change(parameterValues(params), tr("sector"));
}

/// Where the run that has just ended can be found again.
void MainWindow::tellRecorded() {
    const QString path = std::exchange(recorded_to_, QString());
    if (path.isEmpty()) return;
    if (options_.remember) rememberRecording(path);
    start_->setRecent(options_.remember ? recentRecordings() : QStringList{path});
    say(tr("The run is recorded in %1; Ctrl+Shift+O opens it.").arg(path), true);
}

void MainWindow::onLive(const LiveState& state) {
    showTracker(state);
    showSector();
    status_->showLive(state, bridge_.params().navigation.longest_navigation_gap_s);
    if (!bridge_.isTracker()) recorded_to_ = QString::fromStdString(state.run.recorder.path);
    const std::string& failure = state.run.recorder.error;
    if (!failure.empty() && !std::exchange(recording_failure_told_, true))
        say(tr("Recording has ended: %1. Make room and connect again.").arg(QString::fromStdString(failure)), false);
}

}  // namespace echotrail
