#include "ui/chart/mark_model.hpp"

#include "ui/chart/list_change.hpp"
#include "ui/style/formatter.hpp"

#include <algorithm>
#include <cmath>

namespace echotrail {

int MarkModel::add(const Eigen::Vector2d& place_m, Timestamp time, const QString& text) {
    if (marks_.size() >= most_marks) return 0;
    const int number = ++last_number_;
    change(tr("mark M%1").arg(number), marks_ + QList<Mark>{{number, text.left(longest_text), place_m, time}});
    return number;
}

void MarkModel::rename(int row, const QString& text) {
    const QString wanted = text.simplified().left(longest_text);
    if (row < 0 || row >= marks_.size() || marks_[row].text == wanted) return;
    QList<Mark> after = marks_;
    after[row].text = wanted;
    change(tr("text of M%1").arg(after[row].number), after);
}

void MarkModel::remove(int row) {
    if (row < 0 || row >= marks_.size()) return;
    QList<Mark> after = marks_;
    const int number = after.takeAt(row).number;
    change(tr("delete M%1").arg(number), after);
}

void MarkModel::replace(const QList<Mark>& marks) {
    last_number_ = 0;
    for (const Mark& mark : marks) last_number_ = std::max(last_number_, mark.number);
    show(marks);
}

void MarkModel::setVehicle(const Pose& vehicle, bool heading_known) {
    vehicle_ = vehicle;
    heading_known_ = heading_known;
    if (!marks_.isEmpty()) Q_EMIT dataChanged(index(0, Range), index(rowCount() - 1, BearingTo), {Qt::DisplayRole});
}

void MarkModel::change(const QString& what, QList<Mark> after) {
    undo_.push(new ListChange<Mark>(what, marks_, std::move(after), [this](const auto& marks) { show(marks); }));
}

void MarkModel::show(const QList<Mark>& marks) {
    beginResetModel();
    marks_ = marks;
    endResetModel();
    Q_EMIT changed();
}

int MarkModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(marks_.size());
}

int MarkModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : ColumnCount; }

QString MarkModel::textOf(const Mark& mark, int column) const {
    const double north = mark.place_m.x() - vehicle_.north_m;
    const double east = mark.place_m.y() - vehicle_.east_m;
    const Bearing from_north = Bearing::radians(std::atan2(east, north));
    switch (column) {
        case Number:
            return QStringLiteral("M%1").arg(mark.number);
        case Text:
            return mark.text;
        case Range:
            return Formatter::range(std::hypot(north, east));
        case BearingTo:
            return heading_known_ ? Formatter::trueBearing(from_north)
                                  : Formatter::relativeBearing(Bearing::radians(from_north - vehicle_.heading));
        default:
            return Formatter::utc(mark.time).section('T', 1);
    }
}

QVariant MarkModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const Mark& mark = marks_[index.row()];
    if (role == Qt::DisplayRole || (role == Qt::EditRole && index.column() == Text))
        return textOf(mark, index.column());
    if (role == Qt::TextAlignmentRole && (index.column() == Range || index.column() == BearingTo))
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole)
        return tr("%1: N %2 E %3, set in the picture of %4")
            .arg(mark.label(), Formatter::withUnit(mark.place_m.x(), 1, "m"),
                 Formatter::withUnit(mark.place_m.y(), 1, "m"), Formatter::utc(mark.time));
    return {};
}

QVariant MarkModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    switch (section) {
        case Number:
            return tr("Mark");
        case Text:
            return tr("Text");
        case Range:
            return tr("Range");
        case BearingTo:
            return tr("Brg");
        case Time:
            return tr("UTC");
        default:
            return {};
    }
}

Qt::ItemFlags MarkModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    return index.isValid() && index.column() == Text ? flags | Qt::ItemIsEditable : flags;
}

bool MarkModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || !index.isValid() || index.column() != Text) return false;
    rename(index.row(), value.toString());
    return true;
}

}  // namespace echotrail
