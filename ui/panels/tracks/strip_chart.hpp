#pragma once

#include "core/base/time.hpp"

#include <QWidget>
#include <optional>
#include <vector>

namespace echotrail {

/// One lane of a strip chart.
struct Strip {
    struct Point {
        Timestamp time{};
        double value = 0.0;
        bool marked = true;  ///< a dot on it; without, it is only a prediction
    };
    QString name;   ///< and unit
    QString value;  ///< of now
    std::vector<Point> points;
    std::optional<double> limit;  ///< a dashed line; values above it are warnings
    double least_span = 1.0;      ///< of the axis, so that noise does not fill the lane
    bool from_zero = false;       ///< the axis begins there
    bool bars = false;            ///< instead of a line
};

/// Lanes under each other on one time axis that ends now, each with its name and value to the left.
/// No library for plots: the one that Debian has for Qt 6 brings Qt 5's headers along, and a lane is thirty lines.
class StripChart : public QWidget {
    Q_OBJECT

public:
    explicit StripChart(QWidget* parent = nullptr);
    /// Lanes of one track; points may be in any number, none drawn before `now` less `span_s`.
    void setStrips(std::vector<Strip> strips, Timestamp now, double span_s);
    const std::vector<Strip>& strips() const { return strips_; }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {fontMetrics().averageCharWidth() * 30, sizeHint().height()}; }

    /// Where a value is drawn in a lane, for who wants to know.
    QPointF placeOf(std::size_t lane, const Strip::Point& point) const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Axis {
        double low = 0.0, high = 1.0;
    };
    QRectF lane(std::size_t number) const;
    static Axis axisOf(const Strip& strip);
    void paintLane(QPainter& painter, std::size_t number) const;
    void paintValues(QPainter& painter, std::size_t number) const;
    void paintTimes(QPainter& painter) const;

    std::vector<Strip> strips_;
    Timestamp now_{};
    double span_s_ = 60.0;
};

/// A span for the time axis that holds so many seconds: 60, 120, 300, 600…
double chartSpan(double seconds);

}  // namespace echotrail
