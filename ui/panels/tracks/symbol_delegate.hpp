#pragma once

#include <QStyledItemDelegate>

namespace echotrail {

/// Paints a track's symbol, as on the fan and on the fan's dark ground, into its row.
class SymbolDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace echotrail
