#pragma once

#include "core/runtime/timeline.hpp"

#include <QPixmap>
#include <QWidget>
#include <optional>

namespace echotrail {

/// The recording at a glance: sweeps, where a track was confirmed, silences, and where replay stands. Click or drag to
/// go there, unless the run still lasts: then one sees when nothing came here, and what of that has been fetched since.
/// What does not move is painted once into a pixmap.
class TimelineView : public QWidget {
    Q_OBJECT

public:
    explicit TimelineView(QWidget* parent = nullptr);

    void setTimeline(const Timeline& timeline);
    /// `goal` differs from `position` while a seek is under way.
    void setPosition(std::uint64_t position, std::uint64_t goal);
    void setLoop(std::optional<PingSpan> loop);
    /// Of a run that lasts: one can look, but not go anywhere.
    void setLive(bool live);
    /// Of that run: nothing has come for so long.
    void setSilence(double seconds);

    /// The number of pings taken in at the moment under this x; and back. Frames: widget pixels.
    std::uint64_t positionAt(double x) const;
    double xOf(std::uint64_t position) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

Q_SIGNALS:
    void seekRequested(quint64 position);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    QRectF lane(int number) const;
    QRectF spanRect(const PingSpan& span, int number) const;
    double xOfTime(Timestamp time) const;
    double lengthSeconds() const;
    bool ready() const { return timeline_.pings() > 1; }

    void paintLanes();
    void paintSweeps(QPainter& painter) const;
    void paintTracked(QPainter& painter) const;
    void paintGaps(QPainter& painter) const;
    void paintRecalled(QPainter& painter) const;
    QString tipAt(std::uint64_t position) const;
    void paintAxis(QPainter& painter) const;
    void paintLoop(QPainter& painter) const;
    void paintHead(QPainter& painter, std::uint64_t position, bool solid) const;

    Timeline timeline_;
    std::uint64_t position_ = 0;
    std::uint64_t goal_ = 0;
    std::optional<PingSpan> loop_;
    std::optional<double> pointer_x_;
    bool live_ = false;
    double silence_s_ = 0.0;
    QPixmap lanes_;
};

/// A step for an axis of `length_s` seconds with about `ticks` marks: 1, 2, 5, 10, 15, 30 s, 1, 2, 5 min, …
double timeAxisStep(double length_s, double ticks);

}  // namespace echotrail
