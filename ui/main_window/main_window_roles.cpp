#include "ui/main_window/main_window.hpp"

#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>
#include <QTabBar>
#include <QTimer>

// Three arrangements of the docks: to watch at sea, to look through recordings, to tune. Each is remembered as it was
// left; what is open and runs is the same in all.

namespace echotrail {
namespace {

constexpr auto role_setting = "role";
constexpr int keep_interval_ms = 10'000;  // a crash forgets no more of the layout than this

QString layoutSetting(Role role) { return QStringLiteral("layout_") + roleName(role); }

}  // namespace

QString roleName(Role role) {
    switch (role) {
        case Role::Review:
            return "review";
        case Role::Tune:
            return "tune";
        case Role::Operate:
            break;
    }
    return "operate";
}

void MainWindow::makeRoles() {
    role_tabs_ = new QTabBar(menuBar());
    role_tabs_->setDrawBase(false);
    role_tabs_->setFocusPolicy(Qt::NoFocus);  // Ctrl+1 to 3 and the menu Window do the same
    for (int i = 0; i < role_count; ++i) role_tabs_->addTab({});
    menuBar()->setCornerWidget(role_tabs_);
    connect(role_tabs_, &QTabBar::currentChanged, this, [this](int i) { setRole(static_cast<Role>(i)); });
    nameRoles();
    auto* keeper = new QTimer(this);
    keeper->setInterval(keep_interval_ms);
    connect(keeper, &QTimer::timeout, this, &MainWindow::keepLayout);
    if (options_.remember) keeper->start();
}

void MainWindow::nameRoles() {
    const std::pair<QString, QString> names[role_count] = {
        {tr("Operate"), tr("Docks for the watch (Ctrl+1)")},
        {tr("Review"), tr("Docks for looking through recordings (Ctrl+2)")},
        {tr("Tune"), tr("Docks for setting parameters (Ctrl+3)")}};
    for (int i = 0; i < role_count; ++i) {
        role_tabs_->setTabText(i, names[i].first);
        role_tabs_->setTabToolTip(i, names[i].second);
    }
    role_tabs_->setAccessibleName(tr("Role"));
    menuBar()->setCornerWidget(role_tabs_);  // which lays it out for its new names
    role_tabs_->show();
}

void MainWindow::makeRoleMenu(QMenu& menu) {
    auto* group = new QActionGroup(&menu);
    for (int i = 0; i < role_count; ++i) {
        QAction* action = addAction(menu, role_tabs_->tabText(i), QKeySequence(QStringLiteral("Ctrl+%1").arg(i + 1)),
                                    role_tabs_->tabToolTip(i), [this, i] { setRole(static_cast<Role>(i)); });
        action->setCheckable(true);
        action->setChecked(i == static_cast<int>(role_));
        action->setActionGroup(group);
        connect(role_tabs_, &QTabBar::currentChanged, action, [action, i](int now) { action->setChecked(now == i); });
    }
}

void MainWindow::setRole(Role role) {
    if (role == role_) return;
    keepLayout();
    layouts_[static_cast<std::size_t>(role_)] = saveState(layout_version);
    role_ = role;
    role_tabs_->setCurrentIndex(static_cast<int>(role));
    if (options_.remember) QSettings().setValue(role_setting, roleName(role));
    restoreLayout();
}

/// As this role was left, in this session or an earlier one; else as it is meant to be.
void MainWindow::restoreLayout() {
    const bool tour = !tour_dock_->isHidden();
    QByteArray layout = layouts_[static_cast<std::size_t>(role_)];
    if (layout.isEmpty() && options_.remember) layout = QSettings().value(layoutSetting(role_)).toByteArray();
    const bool restored = restoreState(layout, layout_version);
    if (!restored) arrangeDocks();
    laid_out_ = restored || isVisible();
    tour_dock_->setVisible(tour);  // it goes along, and is not remembered
    if (tour) resizeDocks({tour_dock_}, {18 * fontMetrics().height()}, Qt::Vertical);
}

void MainWindow::restoreRole() {
    const QString name = options_.remember ? QSettings().value(role_setting).toString() : QString();
    for (const Role role : {Role::Operate, Role::Review, Role::Tune})
        if (roleName(role) == name) role_ = role;
    role_tabs_->setCurrentIndex(static_cast<int>(role_));
    restoreLayout();
}

void MainWindow::keepLayout() {
    if (!options_.remember) return;
    QSettings settings;
    const QByteArray layout = saveState(layout_version), geometry = saveGeometry();
    if (settings.value(layoutSetting(role_)) != layout) settings.setValue(layoutSetting(role_), layout);
    if (settings.value("geometry") != geometry) settings.setValue("geometry", geometry);
}

void MainWindow::resetLayout() {
    arrangeDocks();
    tour_dock_->hide();
}

void MainWindow::arrangeDocks() {
    for (QDockWidget* dock : docks()) {
        dock->setFloating(false);
        removeDockWidget(dock);  // so that no tab or split of before is left
    }
    const auto tabs = [this](Qt::DockWidgetArea area, const QList<QDockWidget*>& together) {
        for (QDockWidget* dock : together) {
            if (dock == together.front())
                addDockWidget(area, dock);
            else
                tabifyDockWidget(together.front(), dock);
            dock->show();
        }
        together.front()->raise();
    };
    manual_dock_->hide();
    tabs(Qt::LeftDockWidgetArea, {role_ == Role::Review ? chart_dock_ : layers_dock_,
                                  role_ == Role::Review ? layers_dock_ : chart_dock_, connection_dock_});
    if (role_ == Role::Tune) {
        tabs(Qt::RightDockWidgetArea, {parameters_dock_});
        tabs(Qt::RightDockWidgetArea, {tracks_dock_, plan_dock_, alerts_dock_, manual_dock_});
        tabs(Qt::BottomDockWidgetArea, {time_line_dock_, beam_dock_});
    } else {
        tabs(Qt::RightDockWidgetArea, {tracks_dock_, parameters_dock_, plan_dock_, manual_dock_});
        tabs(Qt::RightDockWidgetArea, {alerts_dock_});
        tabs(Qt::BottomDockWidgetArea, {time_line_dock_, beam_dock_});
    }
    manual_dock_->hide();
    addDockWidget(Qt::LeftDockWidgetArea, tour_dock_);
    shareOut();
}

void MainWindow::shareOut() {
    // Of a window 1600 wide: 252 left, 378 right, 474 for parameters that are tuned; the card of a track is tall.
    const int line = fontMetrics().height();
    const bool tune = role_ == Role::Tune;
    resizeDocks({layers_dock_, tracks_dock_}, {14 * line, (tune ? 29 : 23) * line}, Qt::Horizontal);
    if (tune)
        resizeDocks({parameters_dock_, tracks_dock_}, {32 * line, 24 * line}, Qt::Vertical);
    else
        resizeDocks({tracks_dock_, alerts_dock_}, {42 * line, 10 * line}, Qt::Vertical);
    resizeDocks({time_line_dock_}, {(role_ == Role::Review ? 13 : 8) * line}, Qt::Vertical);
}

}  // namespace echotrail
