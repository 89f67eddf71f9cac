#pragma once

#include "core/data/area.hpp"
#include "ui/bridge/pipeline_bridge.hpp"
#include "ui/language/language.hpp"
#include "ui/manual/reference_pages.hpp"
#include "ui/style/palette.hpp"

#include <QElapsedTimer>
#include <QMainWindow>
#include <QUndoGroup>
#include <QUndoStack>
#include <array>

class QAction;
class QLabel;
class QStackedWidget;
class QTabBar;

namespace echotrail {

class AlertCentre;
class AlertsPanel;
class AreaModel;
class BeamPanel;
class ChartPanel;
class ConnectionPanel;
struct CommandedSector;
class FanView;
class GuardWatch;
class LayersPanel;
class ManualView;
class MarkModel;
class MessageStrip;
class ParameterPanel;
class PlanView;
class ShortcutsOverlay;
class RecordingsWindow;
class StaleBanner;
class StartPage;
class StatusBar;
class TourPanel;
class TracksPanel;
class TransportPanel;

/// What the docks are arranged for.
enum class Role { Operate, Review, Tune };
inline constexpr int role_count = 3;
/// "operate", "review", "tune": as in the settings.
QString roleName(Role role);

/// The console's window: the fan in the middle, docks about it, and the keys.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    struct Options {
        bool remember = true;  ///< keep layout, palette and recent recordings in the settings
        bool play_on_open = true;
        QString language;            ///< "en", "zh"; empty: as last time, or the computer's
        bool steady_alerts = false;  ///< nothing flashes
        bool unhurried = false;      ///< every readout follows every scene, however fast they come
        LiveAccess live;
        std::vector<LibraryNotice> libraries;  ///< for the manual's page of versions and licences
    };

    explicit MainWindow(const Options& options, QWidget* parent = nullptr);

    PipelineBridge& bridge() { return bridge_; }
    FanView& fan() { return *fan_; }
    ParameterPanel& parameters() { return *parameters_; }
    TransportPanel& transport() { return *transport_; }
    MessageStrip& messages() { return *messages_; }
    StaleBanner& stale() { return *stale_; }
    ConnectionPanel& connection() { return *connection_; }
    AlertCentre& alerts() { return *alerts_; }
    MarkModel& marks() { return *marks_; }
    AreaModel& areas() { return *areas_; }
    /// Tells of confirmed tracks in guard zones.
    GuardWatch& guards() { return *guards_; }

    void openRecording(const QString& path);
    void openDemonstration();
    /// Follows a tracker at tcp://HOST:PORT.
    void openTracker(const QString& address, bool record = true);
    void setTheme(Theme theme);
    /// Of everything that is on the screen or comes to it.
    void setLanguage(Language language);
    /// The docks as they were left in this role, or as they are meant for it.
    void setRole(Role role);
    Role role() const { return role_; }
    /// Opens the manual at a page, and at words on it.
    void showManual(const QString& page, const QString& words = {});
    ManualView& manual() { return *manual_; }
    /// At the first start: the demonstration with a tour; afterwards nothing.
    void greet();
    /// Parameters given from outside; the form shows them.
    void setParams(const PipelineBridge::Params& params);
    /// Writes a picture of the window, or of the fan only. False, and a line in the strip, where that failed.
    bool saveScreenshot(const QString& path, bool fan_only = false);

protected:
    void changeEvent(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void makeDocks();
    void shareOut();
    void makeHelp();
    void helpHere();
    void showTour();
    void followHand(const QEvent& event);
    void makeRoles();
    void nameRoles();
    void makeRoleMenu(QMenu& menu);
    void restoreRole();
    void restoreLayout();
    void keepLayout();
    void arrangeDocks();
    void dropTrack(int id, double range_m, Bearing from_bow);
    void makeStatusBars();
    void makeCentre();
    void connectBridge();
    Language firstLanguage() const;
    void retranslate();
    void nameDocks();
    void makeLanguageMenu(QMenu& menu);
    void makeMenus();
    void makeFileMenu();
    void makeViewMenu();
    void makeLayersMenu(QMenu& menu);
    /// Keeps a check mark in step with the fan, whoever changed it.
    void followFan(QAction& action, std::function<bool(const FanView&)> on);
    void makeSonarMenu();
    void connectTracker();
    void makeTrackerMenu(QMenu& menu);
    void askForTracker();
    void showTracker(const LiveState& state);
    void showRecordings();
    void makeAlerts();
    void makeAlertsMenu();
    void showAlerts();
    void makeTrackMenu();
    void makeChart();
    void makeChartDock();
    void makeChartMenu();
    void makeBeamAndPlan();
    void addDockKeys(QMenu& menu);
    QList<QDockWidget*> docks() const;
    void exportPlan();
    void makeOrientationMenu(QMenu& menu);
    void addUndo(QMenu& menu);
    void setMark();
    void drawArea(Area::Kind kind);
    QString chartSource() const;
    void openChart();
    void keepChart();
    void makeRecordingMenu();
    void makeParametersMenu();
    void makeWindowMenu();
    void makeHelpMenu();
    /// `tip`: what it does, in the foot of the window while the menu is open.
    QAction* addAction(QMenu& menu, const QString& text, const QKeySequence& key, const QString& tip,
                       std::function<void()> act);
    void fillRecentMenu();

    void askForRecording();
    void openLast();
    void takeScreenshot(bool fan_only);
    void nextTheme();
    void resetLayout();
    void showStart(bool on);
    void makeConnectionDock();
    void askForHead();
    void showSector();
    void commandSector(const CommandedSector& sector);
    void onOpened();
    void nameSource();
    void onLive(const LiveState& state);
    void tellRecorded();
    void onScene(const std::shared_ptr<const Scene>& scene);
    void onStatus(const ReplayStatus& status);
    void say(const QString& text, bool ok);

    Options options_;
    PipelineBridge bridge_;
    QString opening_path_;
    Theme theme_ = Theme::Dusk;
    bool getting_brighter_ = false;
    QElapsedTimer readouts_;
    std::vector<QAction*> need_source_;     ///< grey while nothing is open
    std::vector<QAction*> need_recording_;  ///< grey without a recording
    QAction* disconnect_ = nullptr;
    std::vector<std::pair<QAction*, TrackerControl>> control_actions_;
    StaleBanner* stale_ = nullptr;
    QAction* recordings_aboard_ = nullptr;
    RecordingsWindow* recordings_ = nullptr;  ///< once it has been asked for
    AlertCentre* alerts_ = nullptr;
    AlertsPanel* alerts_panel_ = nullptr;
    QDockWidget* alerts_dock_ = nullptr;
    QAction* edit_sector_ = nullptr;
    bool recording_failure_told_ = false;
    QString recorded_to_;  ///< the live run's log; empty where nothing is recorded
    static constexpr int layout_version = 4;  ///< of what is saved: another one is not restored
    Role role_ = Role::Operate;
    QTabBar* role_tabs_ = nullptr;
    std::array<QByteArray, role_count> layouts_;  ///< of the roles that were left in this session
    bool pointed_ = true;                         ///< the mouse was moved after the focus was set by keys
    ManualView* manual_ = nullptr;
    TourPanel* tour_ = nullptr;
    QDockWidget* manual_dock_ = nullptr;
    QDockWidget* tour_dock_ = nullptr;
    bool laid_out_ = false;  ///< as it was left last time, or by shareOut()
    QMenu* recent_menu_ = nullptr;
    QStackedWidget* centre_ = nullptr;
    StartPage* start_ = nullptr;
    FanView* fan_ = nullptr;
    MessageStrip* messages_ = nullptr;
    StatusBar* status_ = nullptr;
    ShortcutsOverlay* shortcuts_ = nullptr;
    ConnectionPanel* connection_ = nullptr;
    QUndoStack chart_undo_;
    QUndoGroup undo_;
    MarkModel* marks_ = nullptr;
    AreaModel* areas_ = nullptr;
    GuardWatch* guards_ = nullptr;
    ChartPanel* chart_ = nullptr;
    bool opening_chart_ = false;  ///< it is being shown, not drawn
    QDockWidget* chart_dock_ = nullptr;
    BeamPanel* beam_ = nullptr;
    PlanView* plan_ = nullptr;
    QDockWidget* beam_dock_ = nullptr;
    QDockWidget* plan_dock_ = nullptr;
    LayersPanel* layers_ = nullptr;
    TracksPanel* tracks_ = nullptr;
    ParameterPanel* parameters_ = nullptr;
    TransportPanel* transport_ = nullptr;
    QDockWidget* connection_dock_ = nullptr;
    QDockWidget* layers_dock_ = nullptr;
    QDockWidget* tracks_dock_ = nullptr;
    QDockWidget* parameters_dock_ = nullptr;
    QDockWidget* time_line_dock_ = nullptr;
    QLabel* foot_ = nullptr;
    QLabel* keys_ = nullptr;
};

}  // namespace echotrail
