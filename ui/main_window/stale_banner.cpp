#include "ui/main_window/stale_banner.hpp"

#include "ui/style/palette.hpp"

#include <QEvent>
#include <QPainter>

namespace echotrail {

StaleBanner::StaleBanner(QWidget* view) : QWidget(view) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    view->installEventFilter(this);
    hide();
}

void StaleBanner::tell(const QString& text) {
    if (text.isEmpty()) return hide();
    const bool changed = text != text_;
    text_ = text;
    setAccessibleName(text);
    if (isHidden()) {
        setGeometry(parentWidget()->rect());
        show();
        raise();
    } else if (changed) {
        update();
    }
}

bool StaleBanner::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) setGeometry(parentWidget()->rect());
    return QWidget::eventFilter(watched, event);
}

void StaleBanner::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Palette& colours = currentPalette();
    const int line = fontMetrics().height();
    QColor veil = colours.panel;
    veil.setAlphaF(0.45F);
    painter.fillRect(rect(), veil);
    const int frame = line / 2;
    painter.save();
    painter.setClipRegion(QRegion(rect()).subtracted(rect().adjusted(frame, frame, -frame, -frame)));
    painter.fillRect(rect(), QBrush(colours.warning, Qt::BDiagPattern));
    painter.restore();

    QFont strong = font();
    strong.setWeight(QFont::Bold);
    painter.setFont(strong);
    const QRect words = QFontMetrics(strong).boundingRect(text_);
    QRect plate(0, 0, words.width() + 2 * line, 2 * line);
    plate.moveCenter({width() / 2, 0});
    plate.moveTop(2 * line);
    painter.fillRect(plate, colours.warning);
    painter.setPen(colours.panel);
    painter.drawText(plate, Qt::AlignCenter, text_);
}

}  // namespace echotrail
