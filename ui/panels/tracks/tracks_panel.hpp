#pragma once

#include "core/runtime/scene.hpp"
#include "ui/models/track_model.hpp"

#include <QWidget>

class QPushButton;
class QTableView;

namespace echotrail {

class TargetCard;

/// The list of tracks and the card of the one that is selected: a chosen row, else the operator's target,
/// else the surest track.
class TracksPanel : public QWidget {
    Q_OBJECT

public:
    explicit TracksPanel(QWidget* parent = nullptr);
    void setScene(const Scene& scene);
    /// Opens a track's card; 0: that of the target or, without one, of the surest track.
    void selectTrack(int id);

    const TrackModel& model() const { return model_; }

Q_SIGNALS:
    void trackSelected(int id);
    /// The selected track is to be the target.
    void designateRequested(double range_m, echotrail::Bearing from_bow);
    void clearRequested();

protected:
    void changeEvent(QEvent* event) override;

private:
    const Track* shownTrack(const Scene& scene) const;
    void sizeTable();

    TrackModel model_;
    QTableView* table_ = nullptr;
    TargetCard* card_ = nullptr;
    QPushButton* designate_ = nullptr;
    QPushButton* clear_ = nullptr;
    int selected_ = 0;
    bool following_selection_ = false;  ///< the row is being selected by the program
    double shown_range_m_ = 0.0;
    Bearing shown_bearing_;
};

}  // namespace echotrail
