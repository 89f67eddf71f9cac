#pragma once

#include "core/runtime/scene.hpp"
#include "core/tracking/tracker.hpp"
#include "ui/models/track_model.hpp"
#include "ui/models/track_samples.hpp"

#include <QWidget>

class QLineEdit;
class QPushButton;
class QScrollArea;
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
    /// By which the tracker judges: the card explains with them.
    void setParams(const Tracker::Params& params) { params_ = params; }
    /// Another run begins: names and mutes are of the one before.
    void startAnew();
    /// Opens a track's card; 0: that of the target or, without one, of the surest track.
    void selectTrack(int id);
    /// The same as the buttons, for the selected track.
    void designateSelected();
    void toggleMute();
    void dropSelected();
    void editName();

    const TrackModel& model() const { return model_; }

Q_SIGNALS:
    void trackSelected(int id);
    /// The selected track is to be the target.
    void designateRequested(double range_m, echotrail::Bearing from_bow);
    void clearRequested();
    void namesChanged(const echotrail::TrackNames& names);
    /// Whether alerts about this track are wanted.
    void muteRequested(int id, bool muted);
    /// Nobody is to be told of the selected track, which is at this place, any more.
    void dropRequested(int id, double range_m, echotrail::Bearing from_bow);

protected:
    void changeEvent(QEvent* event) override;

private:
    const Track* shownTrack(const Scene& scene) const;
    void sizeTable();
    void fitButtons();
    QLayout* makeButtons();
    void nameAll();
    void showButtons(const Scene& scene, const Track* track);

    TrackModel model_;
    QTableView* table_ = nullptr;
    QScrollArea* scroll_ = nullptr;
    TargetCard* card_ = nullptr;
    QPushButton* designate_ = nullptr;
    QPushButton* clear_ = nullptr;
    QPushButton* mute_ = nullptr;
    QPushButton* drop_ = nullptr;
    QLineEdit* name_ = nullptr;
    TrackSamples samples_;
    Tracker::Params params_;
    int shown_ = 0;  ///< the track of the card; 0: none
    int selected_ = 0;
    bool following_selection_ = false;  ///< the row is being selected by the program
    double shown_range_m_ = 0.0;
    Bearing shown_bearing_;
};

}  // namespace echotrail
