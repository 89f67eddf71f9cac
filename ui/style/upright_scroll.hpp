#pragma once

#include <QEvent>
#include <QScrollArea>
#include <QScrollBar>

namespace echotrail {

/// Scrolls up and down only: as wide as what is in it needs with the bar beside it, so that nothing is cut.
class UprightScroll : public QScrollArea {
public:
    explicit UprightScroll(QWidget* content, QWidget* parent = nullptr) : QScrollArea(parent) {
        setWidget(content);
        setWidgetResizable(true);
        setFrameShape(QFrame::NoFrame);
        setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    }
    QSize minimumSizeHint() const override {
        const int bar = verticalScrollBar()->sizeHint().width();
        return {widget()->minimumSizeHint().width() + bar, QScrollArea::minimumSizeHint().height()};
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (watched == widget() && event->type() == QEvent::LayoutRequest) updateGeometry();  // it may have grown wider
        return QScrollArea::eventFilter(watched, event);
    }
};

}  // namespace echotrail
