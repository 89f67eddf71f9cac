#include "ui/main_window/main_window.hpp"
#include "ui/main_window/shortcuts_overlay.hpp"
#include "ui/main_window/status_bar.hpp"
#include "ui/manual/manual_view.hpp"
#include "ui/panels/layers/layers_panel.hpp"
#include "ui/style/upright_scroll.hpp"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QLocale>
#include <QMenuBar>
#include <QSettings>
#include <QToolBar>

namespace echotrail {
namespace {

constexpr auto language_setting = "language";

}  // namespace

Language MainWindow::firstLanguage() const {
    if (!options_.language.isEmpty()) return languageFromName(options_.language);
    if (!options_.remember) return Language::English;
    const bool chinese = QLocale::system().language() == QLocale::Chinese;
    const QString computers = languageName(chinese ? Language::Chinese : Language::English);
    return languageFromName(QSettings().value(language_setting, computers).toString());
}

void MainWindow::setLanguage(Language language) {
    if (options_.remember) QSettings().setValue(language_setting, languageName(language));
    applyLanguage(*qApp, language);
}

void MainWindow::makeLanguageMenu(QMenu& menu) {
    auto* group = new QActionGroup(&menu);
    for (const Language language : {Language::English, Language::Chinese}) {
        QAction* action = addAction(menu, languageTitle(language), {}, tr("Language of all texts, changed at once"),
                                    [this, language] { setLanguage(language); });
        action->setCheckable(true);
        action->setChecked(language == currentLanguage());
        action->setActionGroup(group);
    }
}

void MainWindow::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange && keys_) retranslate();
    QMainWindow::changeEvent(event);
}

/// Menus are made anew; the rest is named anew.
void MainWindow::retranslate() {
    const QList<QAction*> titles = menuBar()->actions();
    for (QAction* title : titles) delete title->menu();
    need_source_.clear();
    need_recording_.clear();
    control_actions_.clear();
    nameRoles();
    makeMenus();
    nameDocks();
    manual_->refresh();
    status_->nameChips();
    status_->showTheme(themeTitle(theme_));
    shortcuts_->update();
    delete layers_dock_->widget();  // the layers mirror the fan, and keep nothing
    layers_ = new LayersPanel(*fan_, this);
    layers_dock_->setWidget(new UprightScroll(layers_, this));
    if (bridge_.scene()) layers_->setScene(*bridge_.scene());
    onStatus(bridge_.status());
    if (bridge_.isOpen()) nameSource();
    if (bridge_.isLive()) onLive(bridge_.liveState());
    showAlerts();
}

void MainWindow::nameDocks() {
    connection_dock_->setWindowTitle(tr("Sonar"));
    layers_dock_->setWindowTitle(tr("Layers"));
    tracks_dock_->setWindowTitle(tr("Tracks"));
    parameters_dock_->setWindowTitle(tr("Parameters"));
    chart_dock_->setWindowTitle(tr("Chart"));
    beam_dock_->setWindowTitle(tr("Beam"));
    plan_dock_->setWindowTitle(tr("Plan"));
    alerts_dock_->setWindowTitle(tr("Alerts"));
    time_line_dock_->setWindowTitle(tr("Time line"));
    manual_dock_->setWindowTitle(tr("Manual"));
    tour_dock_->setWindowTitle(tr("Tour"));
    keys_->setText(tr("Space play   ← → 5 s   Shift one sweep   Ctrl one ping   , . speed   ? shortcuts"));
    if (!bridge_.isOpen()) foot_->setText(tr("No source open"));
    findChild<QToolBar*>("status")->setWindowTitle(tr("Status"));
}

}  // namespace echotrail
