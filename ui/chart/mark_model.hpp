#pragma once

#include "core/base/time.hpp"
#include "core/data/pose.hpp"
#include "ui/chart/mark.hpp"

#include <QAbstractTableModel>
#include <QUndoStack>

namespace echotrail {

/// The operator's marks, newest last, with where they lie from the vehicle as it is now. Setting, renaming and
/// deleting can be undone.
class MarkModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Number, Text, Range, BearingTo, Time, ColumnCount };
    static constexpr int most_marks = 500;
    static constexpr int longest_text = 40;

    explicit MarkModel(QUndoStack& undo, QObject* parent = nullptr) : QAbstractTableModel(parent), undo_(undo) {}

    const QList<Mark>& marks() const { return marks_; }
    /// The new mark's number; 0 where there is no more room.
    int add(const Eigen::Vector2d& place_m, Timestamp time, const QString& text = {});
    void rename(int row, const QString& text);
    void remove(int row);
    /// Those of another source; cannot be undone.
    void replace(const QList<Mark>& marks);
    void setVehicle(const Pose& vehicle, bool heading_known);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;

Q_SIGNALS:
    void changed();

private:
    void change(const QString& what, QList<Mark> after);
    void show(const QList<Mark>& marks);
    QString textOf(const Mark& mark, int column) const;

    QUndoStack& undo_;
    QList<Mark> marks_;
    int last_number_ = 0;
    Pose vehicle_;
    bool heading_known_ = false;
};

}  // namespace echotrail
