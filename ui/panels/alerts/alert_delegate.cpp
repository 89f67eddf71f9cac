#include "ui/panels/alerts/alert_delegate.hpp"

#include "ui/alerts/alert_centre.hpp"
#include "ui/panels/alerts/alert_icon.hpp"
#include "ui/style/palette.hpp"
#include "ui/style/ui_metrics.hpp"

#include <QMouseEvent>
#include <QPainter>

namespace echotrail {
namespace {

AlertPriority priorityOf(const QModelIndex& index) {
    return static_cast<AlertPriority>(index.data(AlertModel::PriorityRole).toInt());
}

struct Inks {
    QColor ground, title, detail, mark;
};

Inks inksOf(const QModelIndex& index, bool selected, bool lit) {
    const Palette& colours = currentPalette();
    const AlertPriority priority = priorityOf(index);
    const bool is_new = index.data(AlertModel::NewRole).toBool();
    const bool alarm = priority <= AlertPriority::Alarm;
    const QColor ground = selected ? colours.selected : colours.panel;
    const QColor mark = alarm ? colours.alarm : colours.warning;
    if (index.data(AlertModel::OverRole).toBool() && !is_new) return {ground, colours.dim, colours.dim, colours.dim};
    if (is_new && alarm && lit && currentTheme() == Theme::Night)
        return {colours.alarm, colours.panel, colours.panel, colours.panel};
    return {ground, is_new ? mark : colours.text, colours.dim, mark};
}

QFont strongIf(QFont font, bool strong) {
    font.setWeight(strong ? QFont::DemiBold : QFont::Normal);
    return font;
}

}  // namespace

QRect AlertDelegate::buttonRect(const QRect& row, const QFont& font) const {
    const UiMetrics metrics(font);
    const QFontMetrics text(font);
    const int width = text.horizontalAdvance(tr("Ack")) + metrics.pixels(14.0);
    const int height = metrics.pixels(24.0);
    return {row.right() - metrics.pixels(8.0) - width, row.center().y() - height / 2, width, height};
}

void AlertDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const UiMetrics metrics(option.font);
    const Palette& colours = currentPalette();
    const bool is_new = index.data(AlertModel::NewRole).toBool();
    const bool lit = centre_.isLit(priorityOf(index));
    const Inks inks = inksOf(index, option.state.testFlag(QStyle::State_Selected), lit);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->fillRect(option.rect, inks.ground);
    painter->fillRect(QRect(option.rect.left(), option.rect.bottom(), option.rect.width(), 1), colours.line);
    if (is_new)
        painter->fillRect(QRect(option.rect.left(), option.rect.top(), metrics.pixels(4.0), option.rect.height() - 1),
                          inks.mark);
    const double side = metrics.length(14.0);
    const int line = option.fontMetrics.height();
    const int top = option.rect.top() + metrics.pixels(3.0);
    paintAlertIcon(*painter, QRectF(option.rect.left() + metrics.length(9.0), top + (line - side) / 2.0, side, side),
                   priorityOf(index), inks.mark, inks.ground, is_new && lit);
    const int left = option.rect.left() + metrics.pixels(30.0);
    const QRect button = buttonRect(option.rect, option.font);
    const int right = is_new ? button.left() - metrics.pixels(8.0) : option.rect.right() - metrics.pixels(8.0);
    const QString time = index.data(AlertModel::TimeRole).toString();
    const int time_width = option.fontMetrics.horizontalAdvance(time) + metrics.pixels(8.0);
    const QFont title = strongIf(option.font, is_new);
    const auto write = [&](int from, int until, int y, const QFont& font, const QColor& ink, const QString& words) {
        painter->setFont(font);
        painter->setPen(ink);
        painter->drawText(QRect(from, y, until - from, line), Qt::AlignLeft | Qt::AlignVCenter,
                          QFontMetrics(font).elidedText(words, Qt::ElideRight, until - from));
    };
    write(left, right - time_width, top, title, inks.title, index.data().toString());
    painter->setFont(option.font);
    painter->setPen(inks.detail);
    painter->drawText(QRect(left, top, right - left, line), Qt::AlignRight | Qt::AlignVCenter, time);
    write(left, right, top + line, option.font, inks.detail, index.data(AlertModel::CauseRole).toString());
    if (is_new) {
        painter->setPen(QPen(inks.title == colours.panel ? colours.panel : colours.strong_line, 1.0));
        painter->setBrush(inks.title == colours.panel ? inks.ground : colours.raised);
        painter->drawRoundedRect(QRectF(button).adjusted(0.5, 0.5, -0.5, -0.5), metrics.length(2.0),
                                 metrics.length(2.0));
        painter->setPen(inks.title == colours.panel ? colours.panel : colours.text);
        painter->drawText(button, Qt::AlignCenter, tr("Ack"));
    }
    painter->restore();
}

QSize AlertDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
    return {option.fontMetrics.averageCharWidth() * 24,
            2 * option.fontMetrics.height() + UiMetrics(option.font).pixels(7.0)};
}

bool AlertDelegate::editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                                const QModelIndex& index) {
    if (event->type() == QEvent::MouseButtonRelease && index.data(AlertModel::NewRole).toBool()) {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        if (mouse->button() == Qt::LeftButton &&
            buttonRect(option.rect, option.font).contains(mouse->position().toPoint())) {
            centre_.acknowledge(index.data(AlertModel::IdRole).toInt());
            return true;
        }
    }
    return QStyledItemDelegate::editorEvent(event, model, option, index);
}

}  // namespace echotrail
