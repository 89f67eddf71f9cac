#pragma once

#include "core/runtime/scene.hpp"
#include "ui/views/fan_settings.hpp"

#include <QWidget>
#include <memory>
#include <optional>

namespace echotrail {

/// The sonar's picture from above, with what the tracker makes of it; needs no OpenGL.
///
/// Hands: a left click (pressed and let go at one place) on something within range designates it: the nearest track,
/// else the nearest region, else the place itself. Ctrl+click only selects a track, to read its card. It is safe
/// because nothing is lost by it: every track lives on, and clearing the designation takes it back. A drag moves the
/// picture and never designates; nor does a click while measuring or beyond the range. The wheel zooms about the
/// cursor; the middle button, the key 0 or a double click beyond the range fit the picture again. F2 turns
/// following on and off, F4 measures, Esc puts the measure away.
class FanView : public QWidget {
    Q_OBJECT

public:
    explicit FanView(QWidget* parent = nullptr);
    ~FanView() override;

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
    /// Fits the sector into the widget again.
    void resetView();

    /// The track whose card is open; 0: none.
    void setSelectedTrack(int id);
    int selectedTrack() const { return selected_track_; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

Q_SIGNALS:
    void designated(double range_m, echotrail::Bearing from_bow);
    void trackSelected(int id);
    /// Layers, echo settings, orientation, following or measuring changed.
    void settingsChanged();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    struct Painters;

    std::shared_ptr<const Scene> scene_;
    Layers layers_;
    EchoSettings echo_;
    Orientation orientation_ = Orientation::HeadUp;
    bool follow_ = true;
    bool measuring_ = false;
    int selected_track_ = 0;
    std::unique_ptr<Painters> painters_;
};

}  // namespace echotrail
