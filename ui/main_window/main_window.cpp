#include "ui/main_window/main_window.hpp"

#include "ui/alerts/alert_centre.hpp"
#include "ui/chart/guard_watch.hpp"
#include "ui/main_window/dock_title.hpp"
#include "ui/main_window/message_strip.hpp"
#include "ui/main_window/recent_recordings.hpp"
#include "ui/main_window/settings_file.hpp"
#include "ui/main_window/shortcuts_overlay.hpp"
#include "ui/main_window/start_page.hpp"
#include "ui/main_window/status_bar.hpp"
#include "ui/panels/beam/beam_panel.hpp"
#include "ui/panels/chart/chart_panel.hpp"
#include "ui/panels/layers/layers_panel.hpp"
#include "ui/panels/parameters/parameter_panel.hpp"
#include "ui/panels/plan/plan_view.hpp"
#include "ui/panels/tracks/tracks_panel.hpp"
#include "ui/panels/transport/timeline_view.hpp"
#include "ui/panels/transport/transport_panel.hpp"
#include "ui/style/formatter.hpp"
#include "ui/style/upright_scroll.hpp"
#include "ui/views/fan_view.hpp"

#include <QApplication>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QLabel>
#include <QMimeData>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>
#include <utility>

namespace echotrail {
namespace {

constexpr QSize first_size(1600, 1000);   // px, until it is known how the operator likes it
constexpr int readout_interval_ms = 250;  // numbers change four times a second at most
constexpr int slow_opening_ms = 300;      // a quick one says nothing, so that the picture does not jump

}  // namespace

MainWindow::MainWindow(const Options& options, QWidget* parent) : QMainWindow(parent), options_(options) {
    const SettingsTrouble trouble = options_.remember ? checkSettingsFile() : SettingsTrouble();
    applyLanguage(*qApp, firstLanguage());
    if (options_.remember) theme_ = themeFromName(QSettings().value("palette").toString());
    applyTheme(*qApp, theme_);  // first: all lengths come from its font
    setWindowTitle(tr("Echotrail"));
    resize(first_size);
    setAcceptDrops(true);
    bridge_.setLiveAccess(options_.live);
    setDockNestingEnabled(true);
    makeCentre();
    makeDocks();
    makeStatusBars();
    shortcuts_ = new ShortcutsOverlay(this);
    makeHelp();
    makeRoles();
    nameDocks();
    connectTracker();
    makeMenus();
    connectBridge();
    qApp->installEventFilter(this);
    if (options_.remember) {
        restoreGeometry(QSettings().value("geometry").toByteArray());
        start_->setRecent(recentRecordings());
    }
    restoreRole();
    setTheme(theme_);
    showStart(true);
    if (!trouble.text().isEmpty()) say(trouble.text(), false);
}

void MainWindow::makeCentre() {
    auto* middle = new QWidget(this);
    messages_ = new MessageStrip(middle);
    centre_ = new QStackedWidget(middle);
    start_ = new StartPage(centre_);
    fan_ = new FanView(centre_);
    makeChart();
    centre_->addWidget(start_);
    centre_->addWidget(fan_);
    auto* column = new QVBoxLayout(middle);
    column->setContentsMargins({});
    column->setSpacing(0);
    column->addWidget(messages_);
    column->addWidget(centre_, 1);
    setCentralWidget(middle);
    connect(start_, &StartPage::demonstrationChosen, this, &MainWindow::openDemonstration);
    start_->setCanConnect(bridge_.canGoLive());
    connect(start_, &StartPage::connectChosen, this, &MainWindow::askForHead);
    connect(start_, &StartPage::openChosen, this, &MainWindow::askForRecording);
    connect(start_, &StartPage::recentChosen, this, &MainWindow::openRecording);
    connect(messages_, &MessageStrip::cancelled, this, [this] {
        bridge_.cancelOpening();
        opening_path_.clear();
    });
    connect(fan_, &FanView::settingsChanged, this, [this] { bridge_.setEnhanced(fan_->layers().enhanced); });
    connect(fan_, &FanView::designated, this, [this](double range_m, Bearing bearing) {
        bridge_.designate(range_m, bearing.inRadians());
        say(tr("Designated the echo at %1 %2; Delete takes it back.")
                .arg(Formatter::range(range_m), Formatter::relativeBearing(bearing)),
            true);
    });
}

void MainWindow::makeDocks() {
    setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);  // the card is tall, the time line is not
    layers_ = new LayersPanel(*fan_, this);
    tracks_ = new TracksPanel(this);
    parameters_ = new ParameterPanel(bridge_, this);
    if (options_.remember) parameters_->rememberFavourites();
    transport_ = new TransportPanel(bridge_, this);
    // A low window must not be made higher by its layers.
    layers_dock_ = makeDock("layers", new UprightScroll(layers_, this), this);
    tracks_dock_ = makeDock("tracks", tracks_, this);
    parameters_dock_ = makeDock("parameters", parameters_, this);
    time_line_dock_ = makeDock("time_line", transport_, this);
    addDockWidget(Qt::LeftDockWidgetArea, layers_dock_);
    addDockWidget(Qt::RightDockWidgetArea, tracks_dock_);
    addDockWidget(Qt::RightDockWidgetArea, parameters_dock_);
    tabifyDockWidget(tracks_dock_, parameters_dock_);
    tracks_dock_->raise();
    addDockWidget(Qt::BottomDockWidgetArea, time_line_dock_);
    makeConnectionDock();
    makeAlerts();
    makeChartDock();
    makeBeamAndPlan();
    connect(tracks_, &TracksPanel::trackSelected, fan_, &FanView::setSelectedTrack);
    connect(fan_, &FanView::trackSelected, tracks_, &TracksPanel::selectTrack);
    connect(tracks_, &TracksPanel::designateRequested, this,
            [this](double range_m, Bearing from_bow) { bridge_.designate(range_m, from_bow.inRadians()); });
    connect(tracks_, &TracksPanel::dropRequested, this, &MainWindow::dropTrack);
    connect(tracks_, &TracksPanel::muteRequested, this, [this](int id, bool on) { alerts_->setMuted(id, on); });
    connect(tracks_, &TracksPanel::namesChanged, this, [this](const TrackNames& names) {
        fan_->setTrackNames(names);
        plan_->setTrackNames(names);
        alerts_->setTrackNames(names);
        status_->setTrackNames(names);
        if (bridge_.scene()) onScene(bridge_.scene());
    });
    for (const auto happening : {&PipelineBridge::opened, &PipelineBridge::closed})
        connect(&bridge_, happening, tracks_, &TracksPanel::startAnew);
    connect(tracks_, &TracksPanel::clearRequested, this, [this] { bridge_.clearDesignation(); });
    connect(parameters_, &ParameterPanel::message, this, &MainWindow::say);
    connect(transport_, &TransportPanel::message, this, &MainWindow::say);
    connect(parameters_, &ParameterPanel::summaryChanged, this,
            [this](const QString& summary) { setSummary(parameters_dock_, summary); });
    parameters_->showParams();
}

void MainWindow::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    // Only now the window has its size; before, least heights decided.
    if (!std::exchange(laid_out_, true)) shareOut();
}

void MainWindow::makeStatusBars() {
    auto* bar = new QToolBar(this);
    bar->setObjectName("status");
    bar->setMovable(false);
    bar->setFloatable(false);
    bar->setContextMenuPolicy(Qt::PreventContextMenu);
    status_ = new StatusBar(bar);
    status_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar->addWidget(status_);
    addToolBar(Qt::TopToolBarArea, bar);
    setContextMenuPolicy(Qt::NoContextMenu);
    connect(status_, &StatusBar::openClicked, this, &MainWindow::askForRecording);
    connect(status_, &StatusBar::timeLineClicked, time_line_dock_, &QWidget::show);
    connect(status_, &StatusBar::connectionClicked, this, [this] {
        connection_dock_->show();
        connection_dock_->raise();
    });
    connect(status_, &StatusBar::alertsClicked, this, [this] {
        alerts_dock_->show();
        alerts_dock_->raise();
    });
    connect(status_, &StatusBar::tracksClicked, tracks_dock_, &QWidget::show);
    connect(status_, &StatusBar::themeClicked, this, &MainWindow::nextTheme);

    foot_ = new QLabel(tr("No source open"), this);
    keys_ = new QLabel(this);
    foot_->setObjectName("dim");
    keys_->setObjectName("dim");
    statusBar()->setSizeGripEnabled(false);
    statusBar()->setContentsMargins(fontMetrics().height() / 2, 0, fontMetrics().height() / 2, 0);
    statusBar()->addWidget(foot_, 1);
    statusBar()->addPermanentWidget(keys_);
}

void MainWindow::connectBridge() {
    connect(&bridge_, &PipelineBridge::opening, this, [this](const QString& name) {
        QTimer::singleShot(slow_opening_ms, this, [this, name] {
            if (bridge_.isOpening() && bridge_.openingName() == name) messages_->sayBusy(tr("Opening %1…").arg(name));
        });
    });
    connect(&bridge_, &PipelineBridge::opened, this, &MainWindow::onOpened);
    connect(&bridge_, &PipelineBridge::openFailed, this, [this](const QString& name, const QString& reason) {
        opening_path_.clear();
        say(tr("%1 was not opened: %2. Choose another file with Ctrl+O, or start the demonstration with Ctrl+D.")
                .arg(name, reason),
            false);
    });
    connect(&bridge_, &PipelineBridge::closed, this, [this] {
        status_->showNothing();
        foot_->setText(tr("No source open"));
        foot_->setToolTip({});
        setWindowTitle(tr("Echotrail"));
        fan_->setScene(nullptr);
        beam_->setScene(nullptr);
        plan_->setScene(nullptr);
        openChart();
        onStatus({});
        showStart(true);
        tellRecorded();
    });
    connect(&bridge_, &PipelineBridge::liveChanged, this, &MainWindow::onLive);
    connect(&bridge_, &PipelineBridge::sceneChanged, this, &MainWindow::onScene);
    connect(&bridge_, &PipelineBridge::statusChanged, this, &MainWindow::onStatus);
    onStatus({});
}

void MainWindow::openRecording(const QString& path) {
    opening_path_ = path;
    bridge_.openRecording(path);
}

void MainWindow::openDemonstration() {
    opening_path_.clear();
    bridge_.openDemonstration();
}

void MainWindow::onOpened() {
    messages_->clear();
    tellRecorded();  // of a live run that this has ended
    const SourceInfo& info = bridge_.info();
    if (!opening_path_.isEmpty() && options_.remember) {
        rememberRecording(opening_path_);
        start_->setRecent(recentRecordings());
    }
    opening_path_.clear();
    fan_->setScene(nullptr);  // what was open before
    recording_failure_told_ = false;
    openChart();
    (bridge_.isLive() ? connection_dock_ : layers_dock_)->raise();
    setSummary(time_line_dock_, QString::fromStdString(info.name));
    showStart(false);
    fan_->setFocus(Qt::OtherFocusReason);
    nameSource();
    if (bridge_.isAsRecorded())
        say(tr("Parameters and seed are those of the recorded run; what you set counts from then on instead."), true);
    if (options_.play_on_open) bridge_.play();
}

/// In the title, the status bar and the foot.
void MainWindow::nameSource() {
    const SourceInfo& info = bridge_.info();
    const QString name = QString::fromStdString(info.name);
    setWindowTitle(name + tr(" — Echotrail"));
    if (!bridge_.isLive()) status_->showSource(info);
    QStringList notes;
    for (const std::string& note : info.notes) notes << QString::fromStdString(note);
    const QString doing = bridge_.isTracker() ? tr("Following %1")
                          : bridge_.isLive()  ? tr("Polling %1")
                                              : tr("Opened %1");
    foot_->setText(doing.arg(name) + "   " + QString::fromStdString(info.head) +
                   (notes.isEmpty() ? QString() : "   " + tr("notes on it under FILE")));
    foot_->setToolTip(notes.join("\n"));
}

void MainWindow::onScene(const std::shared_ptr<const Scene>& scene) {
    fan_->setScene(scene);
    guards_->setScene(*scene);
    beam_->setScene(scene);
    const bool rests = bridge_.status().state != ReplayState::Playing;
    if (!rests && !options_.unhurried && readouts_.isValid() && readouts_.elapsed() < readout_interval_ms) return;
    readouts_.start();
    status_->showScene(*scene);
    tracks_->setParams(bridge_.params().tracker);
    tracks_->setScene(*scene);
    layers_->setScene(*scene);
    alerts_->showScene(*scene, bridge_.isLive());
    chart_->setScene(*scene);
    plan_->setScene(scene);
}

void MainWindow::onStatus(const ReplayStatus& status) {
    status_->showStatus(status);
    const bool usable = bridge_.isOpen() && status.state != ReplayState::Failed;
    for (QAction* action : need_source_) action->setEnabled(usable);
    for (QAction* action : need_recording_) action->setEnabled(usable && !bridge_.isLive());
    disconnect_->setEnabled(bridge_.isLive());
    edit_sector_->setEnabled(bridge_.isLive());
    showSector();
    if (status.state == ReplayState::Failed && !status.error.empty())
        say(tr("%1. Open the recording again with Ctrl+O.").arg(QString::fromStdString(status.error)), false);
    // The last readouts of a play must not lag behind the picture they belong to.
    if (status.state != ReplayState::Playing && bridge_.scene()) onScene(bridge_.scene());
}

void MainWindow::setParams(const PipelineBridge::Params& params) {
    bridge_.setParams(params);
    parameters_->showParams();
}

void MainWindow::say(const QString& text, bool ok) {
    messages_->say(ok ? MessageStrip::Kind::Notice : MessageStrip::Kind::Problem, text);
}

void MainWindow::showStart(bool on) {
    centre_->setCurrentWidget(on ? static_cast<QWidget*>(start_) : fan_);
    if (on) start_->focusFirst();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    keepLayout();
    QMainWindow::closeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    const auto urls = event->mimeData()->urls();
    if (urls.size() == 1 && urls.front().isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) { openRecording(event->mimeData()->urls().front().toLocalFile()); }

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
    followHand(*event);
    // Space belongs to play everywhere, so Enter presses the button that has the focus.
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        auto* button = qobject_cast<QAbstractButton*>(watched);
        if (button && (key == Qt::Key_Return || key == Qt::Key_Enter)) {
            button->click();
            return true;
        }
    }
    return QMainWindow::eventFilter(watched, event);
}

}  // namespace echotrail
