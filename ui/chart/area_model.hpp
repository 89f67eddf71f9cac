#pragma once

#include "core/data/area.hpp"

#include <QAbstractTableModel>
#include <QUndoStack>

namespace echotrail {

/// Guard zones and veto areas. Drawing, moving a corner, renaming and deleting can be undone.
class AreaModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Name, Kind, Frame, ColumnCount };
    static constexpr int most_areas = 64;
    static constexpr int most_corners = 64;
    static constexpr int longest_name = 40;

    explicit AreaModel(QUndoStack& undo, QObject* parent = nullptr) : QAbstractTableModel(parent), undo_(undo) {}

    const QList<Area>& areas() const { return areas_; }
    /// Gives it a name where it has none ("Guard 1"). False where it has too few or too many corners, or there is no
    /// more room.
    bool add(Area area);
    void rename(int row, const QString& name);
    void setCorner(int row, int corner, const Eigen::Vector2f& at);
    /// Fixes it to the vehicle or to the ground; it stays where it is at this moment.
    void setWithVehicle(int row, bool on, const Pose& vehicle);
    void remove(int row);
    /// Those of another source; cannot be undone.
    void replace(const QList<Area>& areas);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;

Q_SIGNALS:
    void changed();

private:
    void change(const QString& what, QList<Area> after);
    void show(const QList<Area>& areas);

    QUndoStack& undo_;
    QList<Area> areas_;
};

}  // namespace echotrail
