#pragma once

#include "ui/bridge/pipeline_bridge.hpp"

#include <QDialog>
#include <QTimer>

class QLabel;
class QProgressBar;
class QPushButton;
class QTreeWidget;

namespace echotrail {

/// The recordings that lie aboard a tracker: a list, and one after the other fetched whole. It may stay open; nothing
/// waits for it.
class RecordingsWindow : public QDialog {
    Q_OBJECT
public:
    explicit RecordingsWindow(PipelineBridge& bridge, QWidget* parent = nullptr);

    QTreeWidget& list() { return *list_; }
    QString progress() const;
    QPushButton& fetchButton() { return *fetch_; }
    QPushButton& cancelButton() { return *cancel_; }

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void nameAll();
    void showState(const LiveState& state);
    void showList(const QList<RecordingAboard>& recordings);
    void showFetch(const std::optional<RecordingCopy>& fetched);
    QString chosen() const;

    PipelineBridge& bridge_;
    QTreeWidget* list_ = nullptr;
    QLabel *note_ = nullptr, *told_ = nullptr;
    QProgressBar* bar_ = nullptr;
    QPushButton *fetch_ = nullptr, *cancel_ = nullptr;
    QList<RecordingAboard> shown_;
    QTimer look_;
};

}  // namespace echotrail
