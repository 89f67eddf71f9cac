#include "ui/main_window/status_chip.hpp"

#include "ui/panels/alerts/alert_icon.hpp"
#include "ui/style/formatter.hpp"
#include "ui/style/palette.hpp"

#include <QPainter>
#include <algorithm>

namespace echotrail {
namespace {

QFont bold(QFont font) {
    font.setWeight(QFont::DemiBold);
    return font;
}

}  // namespace

StatusChip::StatusChip(QWidget* parent) : QAbstractButton(parent) {
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    show(Health::Absent, {});
}

void StatusChip::show(Health health, const QString& value, const QString& detail) {
    const QString shown = value.isEmpty() ? Formatter::unknown() : value;
    if (health == health_ && shown == value_ && detail == detail_) return;
    health_ = health;
    value_ = shown;
    detail_ = detail;
    if (health == Health::Degraded) shown_detail_ = detail;
    setAccessibleName(label_ + " " + value_ + " " + detail_);
    updateGeometry();
    update();
}

void StatusChip::setLabel(const QString& label) {
    label_ = label;
    setAccessibleName(label_ + " " + value_ + " " + detail_);
    updateGeometry();
    update();
}

void StatusChip::setOnBright(bool on) {
    on_bright_ = on;
    update();
}

int StatusChip::widthOf(const QString& detail) const {
    return detail.isEmpty() ? 0 : fontMetrics().averageCharWidth() + fontMetrics().horizontalAdvance(detail);
}

/// As many of its parts as there is room for: half a number says something else.
QString StatusChip::detailWithin(int room) const {
    QString shorter = detail_;
    while (widthOf(shorter) > room) {
        qsizetype end = 0;
        for (const QString& between : {QStringLiteral("  "), QStringLiteral(", "), QStringLiteral(" · ")})
            end = std::max(end, shorter.lastIndexOf(between));
        shorter.truncate(end);
    }
    return shorter;
}

int StatusChip::giveRoom(int room) {
    const bool whole = health_ == Health::Degraded;  // it says what is wrong: the least width has room for it
    const QString shown = whole ? detail_ : detailWithin(std::max(0, room));
    if (shown != shown_detail_) {
        shown_detail_ = shown;
        updateGeometry();
        update();
    }
    return whole ? 0 : widthOf(shown_detail_);
}

QSize StatusChip::sizeHint() const {
    const QSize least = minimumSizeHint();
    return health_ == Health::Degraded ? least : least + QSize(widthOf(shown_detail_), 0);
}

QSize StatusChip::minimumSizeHint() const {
    const QFontMetrics strong(bold(font()));
    int width = 4 * fontMetrics().averageCharWidth() + fontMetrics().horizontalAdvance(label_) +
                strong.horizontalAdvance(value_);
    if (health_ != Health::Plain) width += fontMetrics().height();
    if (health_ == Health::Degraded) width += widthOf(detail_);
    return {width, fontMetrics().height() * 2};
}

void StatusChip::paintMark(QPainter& painter, const QRectF& box) const {
    const Palette& colours = currentPalette();
    painter.setPen(Qt::NoPen);
    switch (health_) {
        case Health::Plain:
            break;
        case Health::Good:
            painter.setBrush(colours.ok);
            painter.drawEllipse(box);
            break;
        case Health::Degraded:
            painter.setBrush(colours.warning);
            painter.drawRect(box);
            painter.setPen(QPen(colours.panel, box.width() / 6));
            painter.drawLine(QPointF(box.center().x(), box.top() + box.height() * 0.2),
                             QPointF(box.center().x(), box.top() + box.height() * 0.6));
            painter.drawPoint(QPointF(box.center().x(), box.top() + box.height() * 0.8));
            break;
        case Health::Alarm:
            paintAlertIcon(painter, box.adjusted(-1, -1, 1, 1), AlertPriority::Alarm, colours.panel, colours.alarm,
                           true);
            break;
        case Health::Absent:
            painter.setBrush(Qt::NoBrush);
            painter.setPen(QPen(colours.dim, box.width() / 7));
            painter.drawEllipse(box.adjusted(1, 1, -1, -1));
            break;
    }
}

QColor StatusChip::valueColour() const {
    const Palette& colours = currentPalette();
    if (health_ == Health::Alarm) return colours.panel;
    return health_ == Health::Degraded && !on_bright_ ? colours.warning : colours.text;
}

void StatusChip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Palette& colours = currentPalette();
    if (health_ == Health::Alarm) painter.fillRect(rect(), colours.alarm);
    const double space = fontMetrics().averageCharWidth();
    double x = 1.5 * space;
    if (health_ != Health::Plain) {
        const double side = 0.6 * fontMetrics().height();
        paintMark(painter, QRectF(x, (height() - side) / 2.0, side, side));
        x += fontMetrics().height();
    }
    const auto write = [&](const QString& text, const QFont& font, const QColor& colour) {
        painter.setFont(font);
        painter.setPen(colour);
        painter.drawText(QRectF(x, 0, width() - x - space, height()), Qt::AlignLeft | Qt::AlignVCenter, text);
        x += QFontMetrics(font).horizontalAdvance(text) + space;
    };
    const QColor words = health_ == Health::Alarm ? colours.panel : on_bright_ ? colours.text : colours.dim;
    write(label_, font(), words);
    write(value_, bold(font()), valueColour());
    write(shown_detail_, font(), words);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colours.line, 1.0));
    painter.drawLine(QPointF(width() - 0.5, 0), QPointF(width() - 0.5, height()));
    if (health_ == Health::Degraded) {
        painter.setPen(QPen(colours.warning, 1.0));
        painter.drawRect(QRectF(rect()).adjusted(1.5, 1.5, -2.5, -1.5));
    } else if (hasFocus() || underMouse()) {
        painter.setPen(QPen(colours.accent, 1.0));
        painter.drawRect(QRectF(rect()).adjusted(1.5, 1.5, -2.5, -1.5));
    }
}

}  // namespace echotrail
