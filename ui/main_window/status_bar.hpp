#pragma once

#include "core/runtime/replay_runner.hpp"
#include "core/runtime/scene.hpp"

#include <QWidget>

class QHBoxLayout;
class QToolButton;

namespace echotrail {

class StatusChip;

/// The bar at the top: REPLAY in yellow while a recording is shown, what it is, how fast it goes, what was refused in
/// it, how the target stands, the time, and the palette. Numbers change four times a second at most.
class StatusBar : public QWidget {
    Q_OBJECT

public:
    explicit StatusBar(QWidget* parent = nullptr);

    void showNothing();
    void showSource(const SourceInfo& info);
    void showStatus(const ReplayStatus& status);
    void showScene(const Scene& scene);
    void showTheme(const QString& name);

Q_SIGNALS:
    void openClicked();
    void timeLineClicked();
    void tracksClicked();
    void themeClicked();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    StatusChip* addChip(QHBoxLayout& row, const QString& label);
    void showTrack(const Scene& scene);
    void showCounts(const SourceCounts& counts);

    bool replay_ = false;
    StatusChip* file_ = nullptr;
    StatusChip* speed_ = nullptr;
    StatusChip* position_ = nullptr;
    StatusChip* pings_ = nullptr;
    StatusChip* track_ = nullptr;
    StatusChip* utc_ = nullptr;
    QToolButton* theme_ = nullptr;
};

}  // namespace echotrail
