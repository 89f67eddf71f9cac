#include "ui/alerts/alert_centre.hpp"
#include "ui/chart/guard_watch.hpp"
#include "ui/main_window/dock_title.hpp"
#include "ui/main_window/main_window.hpp"
#include "ui/main_window/status_bar.hpp"
#include "ui/panels/alerts/alerts_panel.hpp"

#include <QAction>
#include <QDockWidget>
#include <QMenuBar>
#include <QSettings>

namespace echotrail {
namespace {

constexpr auto steady_setting = "steady_alerts";

}  // namespace

void MainWindow::makeAlerts() {
    alerts_ = new AlertCentre(this);
    if (options_.remember) alerts_->setLog(alertLogPath());
    alerts_panel_ = new AlertsPanel(*alerts_, this);
    alerts_dock_ = makeDock("alerts", alerts_panel_, this);
    addDockWidget(Qt::RightDockWidgetArea, alerts_dock_);
    connect(alerts_panel_, &AlertsPanel::summaryChanged, this,
            [this](const QString& summary) { setSummary(alerts_dock_, summary); });
    connect(alerts_, &AlertCentre::changed, this, &MainWindow::showAlerts);
    Q_EMIT alerts_->changed();
    connect(alerts_, &AlertCentre::flashed, this, &MainWindow::showAlerts);
    connect(alerts_, &AlertCentre::noticed, this, &MainWindow::say);
    connect(&bridge_, &PipelineBridge::opened, alerts_, &AlertCentre::showNothing);
    connect(&bridge_, &PipelineBridge::closed, alerts_, &AlertCentre::showNothing);
    connect(&bridge_, &PipelineBridge::liveChanged, alerts_, [this](const LiveState& state) {
        alerts_->showLive(state, bridge_.params().navigation.longest_navigation_gap_s);
    });
    connect(guards_, &GuardWatch::guardZoneEntered, alerts_, &AlertCentre::guardZoneEntered);
    const bool steady = options_.remember && QSettings().value(steady_setting).toBool();
    alerts_->setSteady(options_.steady_alerts || steady);
}

void MainWindow::makeAlertsMenu() {
    QMenu& menu = *menuBar()->addMenu(tr("&Alerts"));
    addAction(menu, tr("&Acknowledge"), QKeySequence("A"), tr("Acknowledges the alert at the top of the list"),
              [this] { alerts_->acknowledgeMostUrgent(); });
    addAction(menu, tr("&Silence for 30 s"), QKeySequence("Shift+A"),
              tr("No sound for 30 s, unless something new is raised"), [this] { alerts_->silence(); });
    menu.addSeparator();
    QAction* steady = addAction(menu, tr("&No flashing"), {},
                                tr("Alerts that ask for you are shown filled instead of flashing"), [this] {
                                    alerts_->setSteady(!alerts_->isSteady());
                                    if (options_.remember) QSettings().setValue(steady_setting, alerts_->isSteady());
                                });
    steady->setCheckable(true);
    steady->setChecked(alerts_->isSteady());
    addAction(menu, tr("&List"), QKeySequence("Ctrl+Shift+A"), tr("Brings the list of alerts to the front"), [this] {
        alerts_dock_->show();
        alerts_dock_->raise();
    });
}

void MainWindow::showAlerts() {
    if (!status_) return;  // while the window is being made
    const AlertSummary summary = alerts_->summary();
    status_->showAlerts(summary, alerts_->isLit(summary.new_alarm ? AlertPriority::Alarm : AlertPriority::Warning));
}

}  // namespace echotrail
