#pragma once

#include "ui/bridge/pipeline_bridge.hpp"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace echotrail {

class HeadControls;

/// Where the head is, whether to connect, how the link and the head stand and what to do about it, and the head's
/// settings.
class ConnectionPanel : public QWidget {
    Q_OBJECT

public:
    /// The bridge is not owned and must outlive the panel. `remember`: links are kept in the settings.
    ConnectionPanel(PipelineBridge& bridge, bool remember, QWidget* parent = nullptr);
    HeadControls& controls() { return *controls_; }
    /// Puts the cursor into the address.
    void focusAddress();
    /// Connects to what the fields say, or disconnects.
    void toggle();
    void connectTo(const QString& sonar, const QString& navigation, bool record);
    /// Whether the operator wants the next connection recorded.
    bool records() const;
    /// What is open, and its summary.
    void showOpen();

Q_SIGNALS:
    /// A setting of the head was typed; the receiver checks it and hands the parameters to the bridge.
    void headEdited(const QString& name, const QString& text);
    /// How it stands, for the dock's title.
    void summaryChanged(const QString& summary);

private:
    void addLink();
    void addState();
    QComboBox* addAddress(QLabel*& label);
    void nameAll();
    void fill(QComboBox& box) const;
    void addSimulatedHeads(QComboBox& box) const;
    void showLive(const LiveState& state);
    void showCounts(const LiveState& state);

    PipelineBridge& bridge_;
    bool remember_;
    QVBoxLayout* column_ = nullptr;
    QLabel* sonar_label_ = nullptr;
    QLabel* navigation_label_ = nullptr;
    QComboBox* sonar_ = nullptr;
    QComboBox* navigation_ = nullptr;
    QCheckBox* record_ = nullptr;
    QPushButton* connect_ = nullptr;
    QLabel* state_ = nullptr;
    QLabel* identity_ = nullptr;
    QLabel* advice_ = nullptr;
    QLabel* counts_ = nullptr;
    HeadControls* controls_ = nullptr;
};

/// "scanning": what the head is doing, for a person.
QString headStateTitle(seanet::HeadState state);

}  // namespace echotrail
