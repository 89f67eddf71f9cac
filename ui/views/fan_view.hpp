#pragma once

#include "core/runtime/scene.hpp"
#include "ui/views/fan_picture.hpp"

// After those above, see track.hpp
#include "core/data/scan_sector.hpp"

#include <QWidget>
#include <memory>
#include <optional>

namespace echotrail {

class AreaModel;
class MarkModel;

/// The sonar's picture from above, with what the tracker makes of it; needs no OpenGL.
///
/// Hands: a left click (pressed and let go at one place) on something within range designates it: the nearest track,
/// else the nearest region, else the place itself. Ctrl+click only selects a track, to read its card. It is safe
/// because nothing is lost by it: every track lives on, and clearing the designation takes it back. A drag moves the
/// picture and never designates; nor does a click while measuring, beyond the range or where the sonar
/// has not looked. The wheel zooms about the cursor; the middle button or a double click beyond the range fit the
/// picture again. While measuring, a drag or two clicks lay the measure, and its ends can be dragged on; Esc puts it
/// away. While an area is drawn, clicks are its corners; a double click, Enter or a click on the first one closes it,
/// Backspace takes the last one back, Esc gives up. Corners of areas can be dragged at any time.
/// Where a head is polled, handles stand at the edges of its sector: a drag moves an edge, and what it comes to is
/// commanded when it is let go; Esc gives up. The same by keys after editSector(): arrows move the edge by a step, with
/// Shift by ten, Tab takes the other one, Enter commands.
class FanView : public QWidget {
    Q_OBJECT

public:
    explicit FanView(QWidget* parent = nullptr);

    void setScene(std::shared_ptr<const Scene> scene);
    const Scene* scene() const { return scene_.get(); }

    const Layers& layers() const { return layers_; }
    void setLayers(const Layers& layers);
    const EchoSettings& echo() const { return echo_; }
    void setEcho(const EchoSettings& echo);
    Orientation orientation() const { return orientation_; }
    void setOrientation(Orientation orientation);
    /// Following keeps the vehicle where it is on the screen; else the ground stays.
    bool follows() const { return follow_; }
    void setFollow(bool on);
    bool measures() const { return measuring_; }
    void setMeasuring(bool on);
    /// What the operator lays on the sea is kept there; they must outlive the view.
    void setChart(MarkModel& marks, AreaModel& areas);
    /// The ground under the cursor, north and east; none while it is elsewhere.
    std::optional<Eigen::Vector2d> cursorPlace() const;
    /// The cursor's place for a clipboard: decimal degrees where they are known, else metres; empty without a cursor.
    QString cursorText() const;
    /// A mark under the cursor, else on the target or the selected track, else where the vehicle is. Its number, or 0
    /// where none could be set.
    int setMark();
    /// The next clicks are the corners of an area.
    void drawArea(Area::Kind kind);
    bool drawsArea() const { return draft_.has_value(); }
    /// Moves what is under the cursor into the middle.
    void centreOnCursor();
    bool isOffCentre() const { return !pan_.isNull(); }
    /// What the head is told to scan, and whether it says that it does so; none takes the handles away.
    void setSector(const std::optional<CommandedSector>& commanded, bool confirmed);
    /// What the picture is fitted to while a head that follows the target scans only a part of it; none: what is
    /// scanned.
    void setWholeSector(const std::optional<CommandedSector>& whole);
    /// Moves the sector's edges by keys from now on.
    void editSector();
    /// Fits the sector into the widget again.
    void resetView();

    /// The track whose card is open; 0: none.
    void setSelectedTrack(int id);
    int selectedTrack() const { return selected_track_; }
    void setTrackNames(const TrackNames& names);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

Q_SIGNALS:
    void designated(double range_m, echotrail::Bearing from_bow);
    void trackSelected(int id);
    void sectorChosen(const echotrail::CommandedSector& sector);
    /// Layers, echo settings, orientation, following or measuring changed.
    void settingsChanged();
    void cursorMoved();
    /// What a tool has to say to the operator.
    void said(const QString& text, bool ok);

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    bool focusNextPrevChild(bool next) override;

private:
    Sector sectorToShow() const;
    FanGeometry fittedGeometry() const;
    FanGeometry geometry() const;
    FanMoment moment() const;
    void announce();
    bool grabSector(QPointF place);
    bool sectorKey(const QKeyEvent& event);
    void finishSector();
    void showHand();
    void zoomAbout(QPointF place, double factor);
    void refreshMoving();
    void showAreas();
    bool pressChart(QPointF place);
    bool moveChart(QPointF place);
    bool releaseChart(QPointF place);
    bool clickChart(QPointF place);
    bool chartKey(const QKeyEvent& event);
    void pressMeasure(QPointF place);
    void finishDraft();
    bool grabCorner(QPointF place);
    void pointAt(QPointF place, bool select_only);
    /// Nearest track whose symbol is under the hand; 0: none.
    int trackAt(QPointF place) const;

    std::shared_ptr<const Scene> scene_;
    Layers layers_;
    EchoSettings echo_;
    Orientation orientation_ = Orientation::HeadUp;
    bool follow_ = true;
    bool measuring_ = false;
    int selected_track_ = 0;
    TrackNames track_names_;

    std::uint64_t serial_ = 0;  ///< of the scene
    BeamAges ages_;
    FanPicture picture_;
    double zoom_ = 1.0;
    QPointF pan_;                            ///< of the middle of the fitted picture, px
    std::optional<Eigen::Vector2d> anchor_;  ///< not following: where the head was when following ended
    std::optional<QPointF> cursor_;
    std::optional<QPointF> pressed_;
    QPointF dragged_from_;
    bool dragging_ = false;
    SectorHandles sector_;
    std::optional<CommandedSector> whole_sector_;
    std::optional<Measurement> measurement_;
    bool measurement_open_ = false;           ///< its second place still follows the cursor
    std::optional<QPointF> measure_pressed_;  ///< while the hand holds an end of it
    FanImage moving_;                         ///< the fan without its background, while that is shown
    MarkModel* marks_ = nullptr;
    AreaModel* areas_ = nullptr;
    QList<Area> shown_areas_;  ///< with the corner that is being dragged
    std::optional<AreaDraft> draft_;
    struct HeldCorner {
        int area = 0;
        int corner = 0;
    };
    std::optional<HeldCorner> held_corner_;
};

}  // namespace echotrail
