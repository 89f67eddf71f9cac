#pragma once

#include "core/runtime/scene.hpp"
#include "ui/style/palette.hpp"

#include <QWidget>
#include <memory>
#include <optional>

namespace echotrail {

/// The echo line nearest to a direction from north, of those that a scene keeps; null where none is within 2° of it.
std::shared_ptr<const BeamLine> lineTowards(const Scene& scene, Bearing from_north);

/// The A-scan: level over range of one beam, the live one behind it, and the threshold that detection compares with.
/// The beam is the one under the fan's cursor, else the one on the target or the selected track, else the live one.
class BeamPanel : public QWidget {
    Q_OBJECT

public:
    explicit BeamPanel(QWidget* parent = nullptr);

    void setScene(std::shared_ptr<const Scene> scene);
    /// The ground under the fan's cursor; none while it is elsewhere.
    void setCursor(const std::optional<Eigen::Vector2d>& place);
    void setSelectedTrack(int id);
    /// Which beam is shown and what is highest in it: "beam 009.0°R, 1.7 s old   peak 45 dB at 21.1 m, …".
    QString reading() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

Q_SIGNALS:
    void summaryChanged(const QString& summary);

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    struct Axes;
    void choose();
    std::optional<Eigen::Vector2d> trackPlace() const;
    void paintGrid(QPainter& painter, const Axes& axes) const;
    void paintLine(QPainter& painter, const Axes& axes, const std::vector<std::uint8_t>& levels, double cell_m,
                   const QPen& pen) const;
    void paintPlace(QPainter& painter, const Axes& axes) const;
    void paintReading(QPainter& painter) const;

    std::shared_ptr<const Scene> scene_;
    std::optional<Eigen::Vector2d> cursor_;
    int selected_track_ = 0;
    std::shared_ptr<const BeamLine> line_;
    std::optional<double> marked_range_m_;  ///< of the cursor or the track, on the line
    QString source_;                        ///< what the line is of, for a person
    QString summary_;
};

}  // namespace echotrail
