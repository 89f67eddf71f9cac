#pragma once

#include "ui/alerts/alert_book.hpp"

#include <QAbstractListModel>

namespace echotrail {

/// Alerts as rows, in the order of the book. Rows move, come and go one by one, so that a selection stays.
class AlertModel : public QAbstractListModel {
    Q_OBJECT

public:
    enum Role {
        IdRole = Qt::UserRole,
        PriorityRole,  ///< AlertPriority as int
        CauseRole,
        TimeRole,  ///< "14:03:13", or from when to when
        NewRole,   ///< asks to be acknowledged
        OverRole
    };

    using QAbstractListModel::QAbstractListModel;

    void setAlerts(const std::vector<Alert>& alerts);
    int idAt(int row) const { return alerts_[static_cast<std::size_t>(row)].id; }
    int rowOf(int id) const;  ///< −1: none

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

private:
    std::vector<Alert> alerts_;
};

}  // namespace echotrail
