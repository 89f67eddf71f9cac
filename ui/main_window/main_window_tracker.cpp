#include "ui/main_window/dock_title.hpp"
#include "ui/main_window/main_window.hpp"
#include "ui/main_window/stale_banner.hpp"
#include "ui/panels/parameters/parameter_panel.hpp"
#include "ui/panels/recordings/recordings_window.hpp"
#include "ui/style/formatter.hpp"
#include "ui/views/fan_view.hpp"

#include <QAction>
#include <QInputDialog>
#include <QMenu>
#include <QSettings>

namespace echotrail {
namespace {

constexpr double stale_s = 2.0;  // a tracker says something every second
constexpr auto last_tracker = "last_tracker";

}  // namespace

void MainWindow::makeTrackerMenu(QMenu& menu) {
    menu.addSeparator();
    addAction(menu, tr("Connect to &tracker…"), QKeySequence("Ctrl+T"),
              tr("Follows a tracker aboard: what it sees is shown here"), [this] { askForTracker(); })
        ->setEnabled(bridge_.canFollow());
    const auto add = [&](const QString& text, TrackerControl action, const QString& tip) {
        QAction* entry = addAction(menu, text, {}, tip, [this, action] { bridge_.control(action); });
        entry->setEnabled(false);
        control_actions_.emplace_back(entry, action);
    };
    add(tr("&Ask for control"), TrackerControl::Ask, tr("Whoever commands the tracker is asked to give control"));
    add(tr("&Give control"), TrackerControl::Give, tr("To the console that asks, else to nobody"));
    add(tr("&Keep control"), TrackerControl::Keep, tr("The console that asks is told no"));
    add(tr("Take contr&ol"), TrackerControl::Take, tr("From a holder that has not answered for 15 s"));
    recordings_aboard_ = addAction(menu, tr("&Recordings aboard…"), {},
                                   tr("Those of the tracker, to be fetched beside the picture"), [this] { showRecordings(); });
    recordings_aboard_->setObjectName("recordings_aboard");
    recordings_aboard_->setEnabled(false);
}

/// A window of its own, which never stands in the way: the picture goes on beside it.
void MainWindow::showRecordings() {
    if (!recordings_) recordings_ = new RecordingsWindow(bridge_, this);
    recordings_->show();
    recordings_->raise();
}

void MainWindow::connectTracker() {
    stale_ = new StaleBanner(fan_);
    connect(&bridge_, &PipelineBridge::noticed, this, &MainWindow::say);
    connect(&bridge_, &PipelineBridge::paramsAdopted, this, [this] { parameters_->showParams(); });
    connect(&bridge_, &PipelineBridge::opened, this, [this] { showTracker({}); });
    connect(&bridge_, &PipelineBridge::closed, this, [this] { showTracker({}); });
}

void MainWindow::askForTracker() {
    QString address = "tcp://127.0.0.1:7000";
    if (options_.remember) address = QSettings().value(last_tracker, address).toString();
    bool chosen = false;
    address = QInputDialog::getText(this, tr("Connect to a tracker"),
                                    tr("Address: tls://HOST:PORT, or tcp://127.0.0.1:PORT on this machine"),
                                    QLineEdit::Normal, address, &chosen)
                  .trimmed();
    if (chosen) openTracker(address);
}

void MainWindow::openTracker(const QString& address, bool record) {
    bridge_.openTracker(address, record);
    if (bridge_.isTracker() && options_.remember) QSettings().setValue(last_tracker, address);
}

void MainWindow::showTracker(const LiveState& state) {
    const auto& tracker = state.tracker;
    for (const auto& [entry, action] : control_actions_) {
        const bool joined = tracker && tracker->link.up;
        const bool holds = joined && tracker->holds_control;
        const bool asked = joined && tracker->asks_control;
        switch (action) {
            case TrackerControl::Ask:
                entry->setEnabled(joined && !holds && !asked);
                break;
            case TrackerControl::Give:
                entry->setEnabled(holds);
                break;
            case TrackerControl::Keep:
                entry->setEnabled(holds && !tracker->asking.isEmpty());
                break;
            case TrackerControl::Take:
                entry->setEnabled(asked);
                break;
        }
    }
    recordings_aboard_->setEnabled(tracker.has_value());
    const bool stale = tracker && (!tracker->link.up || tracker->link.age_s.value_or(0.0) > stale_s);
    if (!stale) return stale_->tell({});
    if (!tracker->link.age_s) return stale_->tell(tr("NO LINK TO THE TRACKER"));
    const QString age = Formatter::age(*tracker->link.age_s);
    stale_->tell(tracker->link.up ? tr("STALE: nothing came for %1").arg(age)
                                  : tr("LINK LOST: the picture is %1 old").arg(age));
}

}  // namespace echotrail
