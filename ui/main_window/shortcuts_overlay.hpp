#pragma once

#include <QWidget>

namespace echotrail {

/// The keys of the console on one sheet over the window; `?` or Esc puts it away.
class ShortcutsOverlay : public QWidget {
    Q_OBJECT

public:
    explicit ShortcutsOverlay(QWidget* window);
    void toggle();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace echotrail
