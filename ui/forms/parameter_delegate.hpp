#pragma once

#include <QStyledItemDelegate>

namespace echotrail {

/// Paints a parameter as name over limits, default, field, unit and state; the editor exists only on the row in hand.
/// A value is committed by Enter, by leaving the field, by a step or by a choice: never while it is being typed.
class ParameterDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;
    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override;
    bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                     const QModelIndex& index) override;

Q_SIGNALS:
    void favouriteToggled(const QModelIndex& index);

private:
    void paintStage(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;
    void paintName(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;
    void paintField(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;
    void paintStar(QPainter& painter, const QRectF& box, bool on) const;
    void paintFlag(QPainter& painter, const QRectF& box, bool on) const;
};

}  // namespace echotrail
