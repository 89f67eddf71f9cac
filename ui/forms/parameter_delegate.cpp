#include "ui/forms/parameter_delegate.hpp"

#include "ui/forms/parameter_model.hpp"
#include "ui/forms/parameter_spin_box.hpp"
#include "ui/style/palette.hpp"

#include <QAbstractItemView>
#include <QComboBox>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <cmath>
#include <numbers>

namespace echotrail {
namespace {

using Kind = ParameterModel::ParameterKind;

Kind kindOf(const QModelIndex& index) { return static_cast<Kind>(index.data(ParameterModel::Kind).toInt()); }

QFont withWeight(QFont font, bool strong) {
    font.setWeight(strong ? QFont::DemiBold : QFont::Normal);
    return font;
}

QFont smaller(QFont font) {
    if (font.pixelSize() > 0)
        font.setPixelSize(qRound(font.pixelSize() * 0.85));
    else
        font.setPointSizeF(font.pointSizeF() * 0.85);
    return font;
}

QRect fieldRect(const QRect& cell, int line) {
    const int height = line * 3 / 2;
    return {cell.left() + line / 4, cell.center().y() - height / 2, cell.width() - line / 2, height};
}

bool isRefused(const QModelIndex& index) { return !index.data(ParameterModel::Refusal).toString().isEmpty(); }

bool isSent(const QModelIndex& index) {
    return index.data(ParameterModel::ProgressRole).toInt() == static_cast<int>(ParameterModel::Progress::Sent);
}

/// The colour of a value: refused, sent but not known to be in force, or as it is.
QColor valueColour(const QModelIndex& index) {
    if (isRefused(index)) return currentPalette().warning;
    return isSent(index) ? currentPalette().staged : currentPalette().text;
}

}  // namespace

void ParameterDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const Palette& colours = currentPalette();
    const bool stage = !index.data(ParameterModel::IsParameter).toBool();
    const bool selected = option.state.testFlag(QStyle::State_Selected);
    painter->fillRect(option.rect, stage ? colours.raised : selected ? colours.selected : colours.panel);
    painter->fillRect(QRect(option.rect.left(), option.rect.bottom(), option.rect.width(), 1), colours.line);
    if (stage) {
        paintStage(*painter, option, index);
    } else if (index.column() == ParameterModel::Name) {
        paintName(*painter, option, index);
    } else if (index.column() == ParameterModel::Value) {
        paintField(*painter, option, index);
    } else if (index.column() == ParameterModel::Star) {
        const double side = 0.9 * option.fontMetrics.height();
        QRectF box(0, 0, side, side);
        box.moveCenter(QRectF(option.rect).center());
        paintStar(*painter, box, index.data(ParameterModel::Favourite).toBool());
    } else {
        const bool state = index.column() == ParameterModel::State;
        painter->setPen(state ? valueColour(index) : colours.dim);
        painter->setFont(withWeight(option.font, state && (isRefused(index) || isSent(index))));
        const int space = option.fontMetrics.averageCharWidth() / 2;
        const QRect words = option.rect.adjusted(space, 0, -space, 0);
        painter->drawText(
            words, index.data(Qt::TextAlignmentRole).value<Qt::Alignment>(),
            QFontMetrics(painter->font()).elidedText(index.data().toString(), Qt::ElideRight, words.width()));
    }
    painter->restore();
}

void ParameterDelegate::paintStage(QPainter& painter, const QStyleOptionViewItem& option,
                                   const QModelIndex& index) const {
    if (index.column() != ParameterModel::Name) return;
    const Palette& colours = currentPalette();
    const double line = option.fontMetrics.height();
    const bool open = option.state.testFlag(QStyle::State_Open);
    const QPointF middle(option.rect.left() + 0.6 * line, option.rect.center().y());
    const double half = 0.22 * line;
    QPolygonF arrow;
    if (open)
        arrow << middle + QPointF(-half, -half / 2) << middle + QPointF(half, -half / 2) << middle + QPointF(0, half);
    else
        arrow << middle + QPointF(-half / 2, -half) << middle + QPointF(half, 0) << middle + QPointF(-half / 2, half);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.dim);
    painter.drawPolygon(arrow);
    QRectF words = QRectF(option.rect).adjusted(1.2 * line, 0, 0, 0);
    const QFont strong = withWeight(option.font, true);
    painter.setFont(strong);
    painter.setPen(colours.text);
    const QString name = index.data(Qt::DisplayRole).toString();
    painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter, name);
    const int changed = index.data(ParameterModel::Changed).toInt();
    if (changed == 0) return;
    words.setLeft(words.left() + QFontMetrics(strong).horizontalAdvance(name) + 0.6 * line);
    painter.setFont(option.font);
    painter.setPen(colours.dim);
    painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter, tr("%n changed", nullptr, changed));
}

void ParameterDelegate::paintName(QPainter& painter, const QStyleOptionViewItem& option,
                                  const QModelIndex& index) const {
    const Palette& colours = currentPalette();
    const int line = option.fontMetrics.height();
    const bool refused = isRefused(index);
    const bool changed = index.data(ParameterModel::Changed).toBool();
    if (refused || changed)
        painter.fillRect(QRect(option.rect.left(), option.rect.top(), line / 5, option.rect.height() - 1),
                         refused         ? colours.warning
                         : isSent(index) ? colours.staged
                                         : colours.accent);
    const QRect words = option.rect.adjusted(line, 0, -line / 4, 0);
    const QFont strong = withWeight(option.font, changed || refused);
    painter.setFont(strong);
    painter.setPen(colours.text);
    painter.drawText(QRect(words.left(), words.top() + line / 8, words.width(), line), Qt::AlignLeft | Qt::AlignVCenter,
                     QFontMetrics(strong).elidedText(index.data().toString(), Qt::ElideRight, words.width()));
    const QFont small = smaller(option.font);
    painter.setFont(small);
    painter.setPen(colours.dim);
    painter.drawText(
        QRect(words.left(), words.top() + line, words.width(), line), Qt::AlignLeft | Qt::AlignVCenter,
        QFontMetrics(small).elidedText(index.data(ParameterModel::Limits).toString(), Qt::ElideRight, words.width()));
}

void ParameterDelegate::paintStar(QPainter& painter, const QRectF& box, bool on) const {
    const Palette& colours = currentPalette();
    QPolygonF star;
    for (int i = 0; i < 10; ++i) {
        const double angle = std::numbers::pi * (i / 5.0 - 0.5);
        const double reach = box.width() / 2.0 * (i % 2 == 0 ? 1.0 : 0.42);
        star << box.center() + QPointF(reach * std::cos(angle), reach * std::sin(angle));
    }
    painter.setPen(QPen(on ? colours.accent : colours.dim, 1.0));
    painter.setBrush(on ? QBrush(colours.accent) : QBrush(Qt::NoBrush));
    painter.drawPolygon(star);
}

void ParameterDelegate::paintFlag(QPainter& painter, const QRectF& box, bool on) const {
    const Palette& colours = currentPalette();
    painter.setPen(QPen(colours.strong_line, 1.0));
    painter.setBrush(colours.field);
    painter.drawRect(box);
    if (!on) return;
    painter.setPen(QPen(colours.text, box.width() / 7, Qt::SolidLine, Qt::SquareCap));
    painter.drawPolyline(
        QPolygonF({box.topLeft() + QPointF(0.2, 0.5) * box.width(), box.topLeft() + QPointF(0.42, 0.72) * box.width(),
                   box.topLeft() + QPointF(0.8, 0.28) * box.width()}));
}

void ParameterDelegate::paintField(QPainter& painter, const QStyleOptionViewItem& option,
                                   const QModelIndex& index) const {
    const Palette& colours = currentPalette();
    const int line = option.fontMetrics.height();
    const QRect field = fieldRect(option.rect, line);
    const QString shown = index.data(Qt::DisplayRole).toString();
    painter.setFont(withWeight(option.font, index.data(ParameterModel::Changed).toBool()));
    if (kindOf(index) == Kind::Flag) {
        const double side = 0.9 * line;
        const QRectF box(field.right() - side, field.center().y() - side / 2, side, side);
        paintFlag(painter, box, index.data(Qt::CheckStateRole).toInt() == Qt::Checked);
        painter.setPen(valueColour(index));
        painter.drawText(field.adjusted(0, 0, static_cast<int>(-1.4 * side), 0), Qt::AlignRight | Qt::AlignVCenter,
                         shown);
        return;
    }
    painter.setPen(QPen(colours.strong_line, 1.0));
    painter.setBrush(colours.field);
    painter.drawRect(QRectF(field).adjusted(0.5, 0.5, -0.5, -0.5));
    painter.setPen(valueColour(index));
    const QRect words = field.adjusted(line / 3, 0, -line / 3, 0);
    painter.drawText(words, Qt::AlignRight | Qt::AlignVCenter,
                     QFontMetrics(painter.font()).elidedText(shown, Qt::ElideRight, words.width()));
}

QSize ParameterDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const int line = option.fontMetrics.height();
    return {line * 4, index.data(ParameterModel::IsParameter).toBool() ? line * 9 / 4 : line * 7 / 4};
}

QWidget* ParameterDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex& index) const {
    auto* self = const_cast<ParameterDelegate*>(this);  // Qt declares this const, and commitData is a signal
    if (kindOf(index) == Kind::Choice) {
        auto* box = new QComboBox(parent);
        box->setFocusPolicy(Qt::StrongFocus);
        box->addItems(index.data(ParameterModel::Choices).toStringList());
        connect(box, &QComboBox::activated, self, [self, box] { Q_EMIT self->commitData(box); });
        return box;
    }
    auto* field =
        new ParameterSpinBox(index.data(ParameterModel::Minimum).toDouble(),
                             index.data(ParameterModel::Maximum).toDouble(), kindOf(index) == Kind::Whole, parent);
    connect(field, &ParameterSpinBox::stepped, self, [self, field] { Q_EMIT self->commitData(field); });
    return field;
}

void ParameterDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
    const QString value = index.data(Qt::EditRole).toString();
    if (auto* box = qobject_cast<QComboBox*>(editor))
        box->setCurrentText(value);
    else if (auto* field = qobject_cast<ParameterSpinBox*>(editor))
        field->setTypedText(value);
}

void ParameterDelegate::setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const {
    if (const auto* box = qobject_cast<QComboBox*>(editor))
        model->setData(index, box->currentText(), Qt::EditRole);
    else if (const auto* field = qobject_cast<ParameterSpinBox*>(editor))
        model->setData(index, field->typedText(), Qt::EditRole);
}

void ParameterDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                             const QModelIndex&) const {
    editor->setGeometry(fieldRect(option.rect, option.fontMetrics.height()));
}

bool ParameterDelegate::editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                                    const QModelIndex& index) {
    const bool clicked =
        event->type() == QEvent::MouseButtonRelease && static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton;
    if (index.column() == ParameterModel::Star && clicked) {
        Q_EMIT favouriteToggled(index);
        return true;
    }
    if (kindOf(index) != Kind::Flag || index.column() != ParameterModel::Value)
        return QStyledItemDelegate::editorEvent(event, model, option, index);
    const bool typed = event->type() == QEvent::KeyPress && (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space ||
                                                             static_cast<QKeyEvent*>(event)->key() == Qt::Key_Return);
    if (!clicked && !typed) return false;
    const bool on = index.data(Qt::CheckStateRole).toInt() == Qt::Checked;
    return model->setData(index, on ? Qt::Unchecked : Qt::Checked, Qt::CheckStateRole);
}

}  // namespace echotrail
