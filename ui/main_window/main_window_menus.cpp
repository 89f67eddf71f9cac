#include "ui/main_window/main_window.hpp"
#include "ui/main_window/message_strip.hpp"
#include "ui/main_window/recent_recordings.hpp"
#include "ui/main_window/status_bar.hpp"
#include "ui/panels/layers/layers_panel.hpp"
#include "ui/panels/parameters/parameter_panel.hpp"
#include "ui/panels/tracks/tracks_panel.hpp"
#include "ui/panels/transport/transport_panel.hpp"
#include "ui/style/formatter.hpp"
#include "ui/views/fan_view.hpp"

#include <QAction>
#include <QApplication>
#include <QDateTime>
#include <QDir>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenuBar>
#include <QSettings>
#include <QStandardPaths>
#include <QUndoCommand>

namespace echotrail {
namespace {

constexpr double arrow_seconds = 5.0;

/// Told again of after undo(); redo() is the drop itself.
class DropChange : public QUndoCommand {
public:
    DropChange(const QString& what, std::function<void()> drop, std::function<void()> restore)
        : QUndoCommand(what), drop_(std::move(drop)), restore_(std::move(restore)) {}
    void redo() override { drop_(); }
    void undo() override { restore_(); }

private:
    std::function<void()> drop_, restore_;
};

}  // namespace

void MainWindow::makeMenus() {
    makeFileMenu();
    makeViewMenu();
    makeSonarMenu();
    makeChartMenu();
    makeTrackMenu();
    makeAlertsMenu();
    makeRecordingMenu();
    makeParametersMenu();
    makeWindowMenu();
    makeHelpMenu();
}

QAction* MainWindow::addAction(QMenu& menu, const QString& text, const QKeySequence& key, const QString& tip,
                               std::function<void()> act) {
    auto* action = menu.addAction(text);
    action->setStatusTip(tip);
    action->setShortcut(key);
    connect(action, &QAction::triggered, this, std::move(act));
    return action;
}

void MainWindow::makeFileMenu() {
    QMenu& menu = *menuBar()->addMenu(tr("&File"));
    addAction(menu, tr("&Open recording…"), QKeySequence::Open,
              tr("Plays an .echotrail log, a Seanet Pro .V4LOG or a raw .bin; the file is only read"),
              [this] { askForRecording(); });
    recent_menu_ = menu.addMenu(tr("Open &recent"));
    connect(recent_menu_, &QMenu::aboutToShow, this, &MainWindow::fillRecentMenu);
    addAction(menu, tr("Open the &last one again"), QKeySequence("Ctrl+Shift+O"),
              tr("The recording that was opened most recently"), [this] { openLast(); });
    addAction(menu, tr("&Demonstration"), QKeySequence("Ctrl+D"),
              tr("A simulated approach with the tracker running; nothing is connected or sent"),
              [this] { openDemonstration(); });
    need_recording_.push_back(addAction(menu, tr("&Close recording"), QKeySequence("Ctrl+W"),
                                        tr("Back to the start page"), [this] { bridge_.close(); }));
    menu.addSeparator();
    addAction(menu, tr("Picture of the &window"), QKeySequence("S"), tr("Written as PNG to your folder of pictures"),
              [this] { takeScreenshot(false); });
    addAction(menu, tr("Picture of the &fan"), QKeySequence("W"), tr("Written as PNG to your folder of pictures"),
              [this] { takeScreenshot(true); });
    menu.addSeparator();
    addAction(menu, tr("&Quit"), QKeySequence("Ctrl+Q"), tr("Ends a live run cleanly and keeps the layout"),
              [this] { close(); });
}

void MainWindow::fillRecentMenu() {
    recent_menu_->clear();
    for (const QString& path : recentRecordings())
        addAction(*recent_menu_, QFileInfo(path).fileName(), {}, path, [this, path] { openRecording(path); });
    if (recent_menu_->isEmpty())
        addAction(*recent_menu_, tr("none"), {}, tr("No recording was opened before"), [] {})->setEnabled(false);
}

void MainWindow::makeViewMenu() {
    QMenu& menu = *menuBar()->addMenu(tr("&View"));
    addAction(menu, tr("Day, dusk, &night"), QKeySequence("F5"),
              tr("The next palette; never from night to day at once"), [this] { nextTheme(); });
    makeLanguageMenu(*menu.addMenu(tr("Lan&guage")));
    menu.addSeparator();
    makeLayersMenu(*menu.addMenu(tr("&Layers")));
    makeOrientationMenu(menu);
    menu.addSeparator();
    auto* follow = addAction(menu, tr("F&ollow the vehicle"), QKeySequence("F2"),
                             tr("The vehicle keeps its place on the screen; else the ground does"),
                             [this] { fan_->setFollow(!fan_->follows()); });
    followFan(*follow, [](const FanView& fan) { return fan.follows(); });
    addAction(menu, tr("Fit the &picture"), QKeySequence("0"), tr("The whole sector, in the middle"),
              [this] { fan_->resetView(); });
    menu.addSeparator();
    addAction(menu, tr("&Full screen"), QKeySequence("F11"), tr("The window fills the screen; the same key goes back"),
              [this] { isFullScreen() ? showNormal() : showFullScreen(); });
}

void MainWindow::makeLayersMenu(QMenu& menu) {
    const std::pair<QString, bool Layers::*> layers[] = {
        {tr("Echoes"), &Layers::echoes},
        {tr("Enhanced picture"), &Layers::enhanced},
        {tr("Regions kept"), &Layers::regions_kept},
        {tr("Regions dropped"), &Layers::regions_dropped},
        {tr("Particles"), &Layers::particles},
        {tr("Tracks"), &Layers::tracks},
        {tr("Ellipses"), &Layers::ellipses},
        {tr("History, prediction"), &Layers::history},
        {tr("Region of interest"), &Layers::region_of_interest},
        {tr("Guard zones"), &Layers::guard_zones},
        {tr("Veto areas"), &Layers::vetoes},
        {tr("Marks"), &Layers::marks},
        {tr("Echo trails"), &Layers::trails},
        {tr("Moving only"), &Layers::moving},
        {tr("Rings and bearings"), &Layers::graticule},
        {tr("Target ×4"), &Layers::inset},
    };
    for (const auto& [title, layer] : layers) {
        auto* action = addAction(menu, title, {}, tr("Shows or hides it on the fan"), [this, layer = layer] {
            Layers changed = fan_->layers();
            changed.*layer = !(changed.*layer);
            fan_->setLayers(changed);
        });
        followFan(*action, [layer = layer](const FanView& fan) { return fan.layers().*layer; });
    }
}

void MainWindow::followFan(QAction& action, std::function<bool(const FanView&)> on) {
    action.setCheckable(true);
    const auto show = [this, &action, on = std::move(on)] { action.setChecked(on(*fan_)); };
    connect(fan_, &FanView::settingsChanged, &action, show);
    show();
}

void MainWindow::makeTrackMenu() {
    QMenu& menu = *menuBar()->addMenu(tr("&Track"));
    const auto add = [&](const QString& text, const QKeySequence& key, const QString& tip, std::function<void()> act) {
        need_source_.push_back(addAction(menu, text, key, tip, std::move(act)));
    };
    add(tr("&Designate the selected one"), QKeySequence("Ctrl+Return"),
        tr("Makes the track that is selected in the list the target"), [this] { tracks_->designateSelected(); });
    add(tr("&Clear the designation"), QKeySequence(Qt::Key_Delete), tr("No target; all tracks live on"),
        [this] { bridge_.clearDesignation(); });
    menu.addSeparator();
    add(tr("&Name the selected one"), QKeySequence("Ctrl+R"), tr("Your own name for it, on this console"),
        [this] { tracks_->editName(); });
    add(tr("&Mute the selected one"), QKeySequence("Ctrl+M"), tr("No alerts about it; the same again wants them back"),
        [this] { tracks_->toggleMute(); });
    add(tr("D&rop the selected one"), QKeySequence("Shift+Delete"),
        tr("Nobody is told of it any more, and none begins on its echoes; Ctrl+Z takes it back"),
        [this] { tracks_->dropSelected(); });
}

void MainWindow::dropTrack(int id, double range_m, Bearing from_bow) {
    const QString name = Formatter::trackId(id);
    chart_undo_.push(new DropChange(
        tr("drop of %1").arg(name), [this, id, range_m, from_bow] { bridge_.dropTrack(id, range_m, from_bow); },
        [this, id] { bridge_.restoreTrack(id); }));
    say(tr("Track %1 dropped; Ctrl+Z takes it back, and so does a click on its echo.").arg(name), true);
}

void MainWindow::makeRecordingMenu() {
    QMenu& menu = *menuBar()->addMenu(tr("&Recording"));
    const auto add = [&](const QString& text, const QKeySequence& key, const QString& tip, std::function<void()> act) {
        need_recording_.push_back(addAction(menu, text, key, tip, std::move(act)));
    };
    const auto jump = [&](const QString& text, const QKeySequence& key, std::function<void()> act) {
        add(text, key, tr("Goes there, with the tracks as they were then"), std::move(act));
    };
    add(tr("&Play or pause"), QKeySequence(Qt::Key_Space), tr("Plays on from here; at the end from the start"),
        [this] { bridge_.togglePlay(); });
    menu.addSeparator();
    jump(tr("5 s &back"), QKeySequence(Qt::Key_Left), [this] { bridge_.skipSeconds(-arrow_seconds); });
    jump(tr("5 s &on"), QKeySequence(Qt::Key_Right), [this] { bridge_.skipSeconds(arrow_seconds); });
    jump(tr("One sweep back"), QKeySequence("Shift+Left"), [this] { bridge_.stepSweep(-1); });
    jump(tr("One sweep on"), QKeySequence("Shift+Right"), [this] { bridge_.stepSweep(1); });
    jump(tr("One ping back"), QKeySequence("Ctrl+Left"), [this] { bridge_.stepPings(-1); });
    jump(tr("One ping on"), QKeySequence("Ctrl+Right"), [this] { bridge_.stepPings(1); });
    jump(tr("To the &start"), QKeySequence(Qt::Key_Home), [this] { bridge_.seekPosition(0); });
    jump(tr("To the &end"), QKeySequence(Qt::Key_End), [this] { bridge_.seekPosition(bridge_.status().total); });
    menu.addSeparator();
    add(tr("S&lower"), QKeySequence(","), tr("Fewer seconds of the recording per second"),
        [this] { transport_->changeSpeed(-1); });
    add(tr("&Faster"), QKeySequence("."), tr("More seconds of the recording per second; no ping is left out"),
        [this] { transport_->changeSpeed(1); });
}

void MainWindow::makeParametersMenu() {
    QMenu& menu = *menuBar()->addMenu(tr("&Parameters"));
    ParameterForm& form = parameters_->form();
    addAction(menu, tr("&Find…"), QKeySequence("Ctrl+F"), tr("By any part of its name or of what it does"),
              [this, &form] {
                  parameters_dock_->show();
                  parameters_dock_->raise();
                  form.focusSearch();
              });
    menu.addSeparator();
    addUndo(menu);
    menu.addSeparator();
    addAction(menu, tr("Star the selected &one"), QKeySequence("Ctrl+B"), tr("Makes it a favourite, or no longer"),
              [&form] { form.toggleFavourite(); });
    addAction(menu, tr("&Load set…"), {}, tr("All parameters of a TOML file, in one step that can be undone"),
              [&form] { form.loadFile(); });
    addAction(menu, tr("&Save set…"), {}, tr("All parameters as a TOML file that echotrail reads, too"),
              [&form] { form.saveFile(); });
    menu.addSeparator();
    addAction(menu, tr("Selected one to its &default, or as compared"), {},
              tr("Can be undone like every change of a parameter"), [&form] { form.resetRow(); });
    addAction(menu, tr("&All to their defaults, or as compared"), {},
              tr("Can be undone like every change of a parameter"), [this] { parameters_->model().resetAll(); });
}

void MainWindow::makeWindowMenu() {
    QMenu& menu = *menuBar()->addMenu(tr("&Window"));
    makeRoleMenu(menu);
    menu.addSeparator();
    for (QDockWidget* dock : docks()) {
        dock->toggleViewAction()->setStatusTip(tr("Shows or hides this panel"));
        menu.QWidget::addAction(dock->toggleViewAction());
    }
    addDockKeys(menu);
    menu.addSeparator();
    addAction(menu, tr("&Reset layout"), {}, tr("Every panel back to where it was on the first day"),
              [this] { resetLayout(); });
}

void MainWindow::askForRecording() {
    const QString own = bridge_.recordingsFolder();
    const QString path = QFileDialog::getOpenFileName(
        this, tr("Open a recording"), QDir(own).exists() ? own : QString(),
        tr("Recordings (*.echotrail *.V4LOG *.v4log *.bin);;All files (*)"), nullptr,
        QFileDialog::DontUseNativeDialog);  // the desktop's own would not follow the palette
    if (!path.isEmpty()) openRecording(path);
}

void MainWindow::openLast() {
    const QStringList paths = recentRecordings();
    if (paths.isEmpty())
        say(tr("No recording was opened before, or they are gone. Choose one with Ctrl+O."), false);
    else
        openRecording(paths.front());
}

bool MainWindow::saveScreenshot(const QString& path, bool fan_only) {
    const QPixmap picture = fan_only ? fan_->grab() : grab();
    if (picture.save(path)) return true;
    say(tr("The picture could not be written to %1. Free some space or choose another folder.").arg(path), false);
    return false;
}

void MainWindow::takeScreenshot(bool fan_only) {
    QString folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    if (folder.isEmpty() || !QDir().mkpath(folder)) folder = QDir::homePath();
    const QString moment = QDateTime::currentDateTimeUtc().toString("yyyyMMdd'T'HHmmss.zzz'Z'");
    const QString path = folder + "/echotrail-" + (fan_only ? "fan-" : "") + moment + ".png";
    if (saveScreenshot(path, fan_only)) say(tr("Picture written to %1.").arg(path), true);
}

void MainWindow::setTheme(Theme theme) {
    theme_ = theme;
    if (options_.remember) QSettings().setValue("palette", themeName(theme));
    applyTheme(*qApp, theme);
    status_->showTheme(themeTitle(theme));
    update();
}

void MainWindow::nextTheme() {
    // Day, dusk, night, dusk, day: the eyes never jump from the darkest to the brightest.
    if (theme_ == Theme::Night) getting_brighter_ = true;
    if (theme_ == Theme::Day) getting_brighter_ = false;
    setTheme(theme_ == Theme::Dusk ? (getting_brighter_ ? Theme::Day : Theme::Night) : Theme::Dusk);
}

}  // namespace echotrail
