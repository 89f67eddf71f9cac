#pragma once

#include "core/runtime/scene.hpp"
#include "ui/style/formatter.hpp"

#include <QAbstractTableModel>
#include <QSet>
#include <vector>

namespace echotrail {

/// The tracks as rows: the target first, then confirmed, coasting, tentative and lost ones, each by id. A new scene
/// moves, adds and changes rows one by one, so that a selection and the scroll position stay.
class TrackModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Symbol, Id, State, Range, BearingFromBow, Speed, Course, Age, Quality, ColumnCount };
    enum Role { IdRole = Qt::UserRole, StateRole, TargetRole };

    static constexpr int longest_name = 16;  ///< characters

    using QAbstractTableModel::QAbstractTableModel;

    void setScene(const Scene& scene);
    void clear() { setRows({}); }
    /// The operator's own words for a track, cut to `longest_name`; empty: none. They are this console's only, and kept
    /// until forgetTracks().
    void setName(int id, const QString& name);
    QString name(int id) const { return names_.value(id); }
    const TrackNames& names() const { return names_; }
    /// A muted track raises no alert. Here it is only shown.
    void setMuted(int id, bool on);
    bool isMuted(int id) const { return muted_.contains(id); }
    /// Another run begins, with other tracks of the same numbers.
    void forgetTracks();
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
        double course_rad = 0.0;  ///< from north, or from the bow where north is not known; not finite at rest
        double age_s = 0.0;
        double quality = 0.0;
    };
    void setRows(const std::vector<Row>& rows);
    QString text(const Row& row, int column) const;
    QString stateText(const Row& row) const;
    QVariant foreground(const Row& row, int column) const;

    std::vector<Row> rows_;
    TrackNames names_;
    QSet<int> muted_;
    bool true_courses_ = false;
};

/// The state as a word for the operator, translated.
QString stateWord(TrackState state);

}  // namespace echotrail
