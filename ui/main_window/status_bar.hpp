#pragma once

#include "core/runtime/replay_runner.hpp"
#include "core/runtime/scene.hpp"
#include "ui/bridge/live_source.hpp"
#include "ui/style/formatter.hpp"

#include <QWidget>
#include <optional>

class QHBoxLayout;
class QToolButton;

namespace echotrail {

class StatusChip;
struct AlertSummary;

/// The bar at the top: REPLAY in yellow while a recording is shown, what it is, how fast it goes, what was refused in
/// it; of a head that is polled the link, the head, the heading and the recording, each with its age; then how the
/// target stands, the time, and the palette. Numbers change four times a second at most.
class StatusBar : public QWidget {
    Q_OBJECT

public:
    explicit StatusBar(QWidget* parent = nullptr);

    QSize sizeHint() const override;
    /// In the language in force.
    void nameChips();
    void showNothing();
    void showSource(const SourceInfo& info);
    void showStatus(const ReplayStatus& status);
    /// `longest_heading_gap_s`: an older heading is no use.
    void showLive(const LiveState& state, double longest_heading_gap_s);
    void showScene(const Scene& scene);
    /// What tracks are called from the next scene on.
    void setTrackNames(const TrackNames& names) { names_ = names; }
    /// `lit`: what asks for the operator is shown filled at this moment of flashing.
    void showAlerts(const AlertSummary& alerts, bool lit);
    void showTheme(const QString& name);

Q_SIGNALS:
    void openClicked();
    void timeLineClicked();
    void tracksClicked();
    void themeClicked();
    void connectionClicked();
    void alertsClicked();

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    StatusChip* addChip(QHBoxLayout& row);
    void fitDetails();
    void showTrack(const Scene& scene);
    void showCounts(const SourceCounts& counts);
    enum class Mode { Nothing, Replay, Live };
    void setMode(Mode mode);
    void showLink(const LiveState& state);
    void showTracker(const std::optional<TrackerState>& tracker);
    void showSonar(const LiveState& state);
    void showHeading(const LiveState& state, double longest_gap_s);
    void showRecording(const RecorderStatus& recorder, const std::optional<RecordingCopy>& copy);
    double pingRate(const LiveState& state);
    double lossOf(const TrackerState& tracker);

    Mode mode_ = Mode::Nothing;
    TrackNames names_;
    StatusChip* file_ = nullptr;
    StatusChip* speed_ = nullptr;
    StatusChip* position_ = nullptr;
    StatusChip* tracker_ = nullptr;
    StatusChip* control_ = nullptr;
    StatusChip* link_ = nullptr;
    StatusChip* sonar_ = nullptr;
    StatusChip* heading_ = nullptr;
    StatusChip* recording_ = nullptr;
    std::optional<Timestamp> rate_since_;
    std::uint64_t rate_pings_ = 0;  ///< there were then
    double rate_ = 0.0;
    quint64 loss_counted_ = 0, loss_gaps_ = 0;  ///< messages and gaps, and gaps, there were when loss was last told
    double loss_ = 0.0;
    StatusChip* pings_ = nullptr;
    StatusChip* track_ = nullptr;
    StatusChip* alerts_ = nullptr;
    StatusChip* utc_ = nullptr;
    QToolButton* theme_ = nullptr;
};

}  // namespace echotrail
