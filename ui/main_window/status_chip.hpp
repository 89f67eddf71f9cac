#pragma once

#include <QAbstractButton>

namespace echotrail {

/// One thing that can be well or not, in the bar at the top: a mark whose shape says how it stands, a label, the value
/// and its detail. A click opens what it speaks of.
class StatusChip : public QAbstractButton {
    Q_OBJECT

public:
    enum class Health { Plain, Good, Degraded, Alarm, Absent };

    explicit StatusChip(QWidget* parent = nullptr);
    void setLabel(const QString& label);
    /// An empty value shows as unknown.
    void show(Health health, const QString& value, const QString& detail = {});
    /// Text painted dark on a bright bar.
    void setOnBright(bool on);
    QString value() const { return value_; }
    /// So much room there is beyond what the chip needs at least, px: it shows as many whole parts of the detail as
    /// fit. Gives what it takes of it.
    int giveRoom(int room);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    int widthOf(const QString& detail) const;
    QString detailWithin(int room) const;
    QColor valueColour() const;
    void paintMark(QPainter& painter, const QRectF& box) const;

    QString label_;
    QString value_;
    QString detail_, shown_detail_;
    Health health_ = Health::Absent;
    bool on_bright_ = false;
};

}  // namespace echotrail
