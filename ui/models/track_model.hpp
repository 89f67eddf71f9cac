#pragma once

#include "core/runtime/scene.hpp"

#include <QAbstractTableModel>
#include <vector>

namespace echotrail {

/// The tracks as rows: the target first, then confirmed, coasting, tentative and lost ones, each by id. A new scene
/// moves, adds and changes rows one by one, so that a selection and the scroll position stay.
class TrackModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Symbol, Id, State, Range, BearingFromBow, Speed, Age, Quality, ColumnCount };
    enum Role { IdRole = Qt::UserRole, StateRole, TargetRole };

    using QAbstractTableModel::QAbstractTableModel;

    void setScene(const Scene& scene);
    void clear() { setRows({}); }
    /// Row of a track; −1: none.
    int rowOf(int id) const;
    int idAt(int row) const { return rows_[static_cast<std::size_t>(row)].id; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    struct Row {
        int id = 0;
        TrackState state = TrackState::Tentative;
        bool target = false;
        double range_m = 0.0;
        Bearing from_bow;
        double speed_mps = 0.0;
        double age_s = 0.0;
        double quality = 0.0;
    };
    void setRows(const std::vector<Row>& rows);
    QString text(const Row& row, int column) const;
    QVariant foreground(const Row& row, int column) const;

    std::vector<Row> rows_;
};

/// The state as a word for the operator, translated.
QString stateWord(TrackState state);

}  // namespace echotrail
