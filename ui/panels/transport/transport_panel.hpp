#pragma once

#include "ui/bridge/pipeline_bridge.hpp"

#include <QElapsedTimer>
#include <QWidget>
#include <vector>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace echotrail {

class TimelineView;
class TransportButton;

/// The tape deck: time line, buttons, speed, loop, and where replay stands.
class TransportPanel : public QWidget {
    Q_OBJECT

public:
    /// The bridge is not owned and must outlive the panel.
    explicit TransportPanel(PipelineBridge& bridge, QWidget* parent = nullptr);

    TimelineView& timeline() { return *timeline_; }
    /// One step down (−1) or up (+1) the list of speeds.
    void changeSpeed(int steps);

Q_SIGNALS:
    /// What was typed into "Go to" is no moment: a line for the window's message strip.
    void message(const QString& text, bool ok);

private:
    QLayout* makeControls();
    QLayout* makeReadouts();
    void nameAll();
    void nameLoop();
    void showStatus(const ReplayStatus& status);
    void showTimes(const ReplayStatus& status);
    void goToTyped();
    void loopHere();
    void setLoop(std::optional<PingSpan> loop);

    PipelineBridge& bridge_;
    TimelineView* timeline_ = nullptr;
    std::vector<TransportButton*> buttons_;
    TransportButton* play_ = nullptr;
    QComboBox* speed_ = nullptr;
    QPushButton* loop_button_ = nullptr;
    QLabel* utc_ = nullptr;
    QLabel* elapsed_ = nullptr;
    QLabel* busy_ = nullptr;
    QPushButton* cancel_ = nullptr;
    QLabel* go_to_label_ = nullptr;
    QLineEdit* go_to_ = nullptr;
    QElapsedTimer travelling_;  ///< since a seek began that is still under way
    std::optional<std::uint64_t> loop_begin_;
    std::optional<PingSpan> loop_;
};

/// The speeds offered, slowest first; the last is ReplayRunner::max_speed.
const std::vector<double>& offeredSpeeds();
/// "0.5×", "max".
QString speedText(double factor);

}  // namespace echotrail
