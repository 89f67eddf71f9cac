#pragma once

#include <QStyledItemDelegate>

namespace echotrail {

class AlertCentre;

/// An alert as two lines: its mark, title and time; its cause, and a button while it asks to be acknowledged. At night,
/// where red is the colour of text, a new alarm is an inverse box.
class AlertDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    AlertDelegate(AlertCentre& centre, QObject* parent) : QStyledItemDelegate(parent), centre_(centre) {}

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    /// Where a click acknowledges.
    QRect buttonRect(const QRect& row, const QFont& font) const;

protected:
    bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                     const QModelIndex& index) override;

private:
    AlertCentre& centre_;
};

}  // namespace echotrail
