#pragma once

#include "core/runtime/scene.hpp"
#include "ui/chart/mark.hpp"
#include "ui/style/formatter.hpp"
#include "ui/style/palette.hpp"

#include <QWidget>
#include <memory>

namespace echotrail {

/// The paths of vehicle and tracks from above, north up, scaled to hold them all, with the marks.
class PlanView : public QWidget {
    Q_OBJECT

public:
    explicit PlanView(QWidget* parent = nullptr);

    void setScene(std::shared_ptr<const Scene> scene);
    void setMarks(const QList<Mark>& marks);
    void setSelectedTrack(int id);
    void setTrackNames(const TrackNames& names);
    /// One line per point in time order of its path: "who,utc,north_m,east_m,heading_deg" with `.` decimals; the
    /// heading of the vehicle only.
    QByteArray csv() const;
    bool isEmpty() const { return !scene_ || !scene_->paths || scene_->paths->vehicle.empty(); }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    struct Map;
    Map map() const;
    QRectF extent() const;
    void paintGrid(QPainter& painter, const Map& map) const;
    void paintTracks(QPainter& painter, const Map& map) const;
    void paintVehicle(QPainter& painter, const Map& map) const;

    std::shared_ptr<const Scene> scene_;
    QList<Mark> marks_;
    int selected_track_ = 0;
    TrackNames track_names_;
};

}  // namespace echotrail
