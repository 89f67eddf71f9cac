#pragma once

#include <QWidget>

namespace echotrail {

/// Lies over a view whose data is old, because the link it came by is quiet or lost: a hatched frame, and a plate that
/// says so with the age. It takes no click: the old picture can still be measured and read.
class StaleBanner : public QWidget {
    Q_OBJECT

public:
    explicit StaleBanner(QWidget* view);
    /// An empty text puts it away.
    void tell(const QString& text);
    QString text() const { return isHidden() ? QString() : text_; }

protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QString text_;
};

}  // namespace echotrail
