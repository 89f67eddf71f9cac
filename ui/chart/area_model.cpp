#include "ui/chart/area_model.hpp"

#include "ui/chart/list_change.hpp"

#include <algorithm>

namespace echotrail {
namespace {

QString kindTitle(Area::Kind kind) {
    return kind == Area::Kind::Guard ? AreaModel::tr("Guard") : AreaModel::tr("Veto");
}

/// The first name of its kind that no other area has.
std::string freeName(const QList<Area>& areas, Area::Kind kind) {
    for (int number = 1;; ++number) {
        const std::string name = (kindTitle(kind) + QStringLiteral(" %1").arg(number)).toStdString();
        const bool taken = std::any_of(areas.begin(), areas.end(), [&](const Area& area) { return area.name == name; });
        if (!taken) return name;
    }
}

}  // namespace

bool AreaModel::add(Area area) {
    const auto corners = static_cast<int>(area.corners_m.size());
    if (corners < 3 || corners > most_corners || areas_.size() >= most_areas) return false;
    if (area.name.empty()) area.name = freeName(areas_, area.kind);
    change(tr("draw %1").arg(QString::fromStdString(area.name)), areas_ + QList<Area>{area});
    return true;
}

void AreaModel::rename(int row, const QString& name) {
    const std::string wanted = name.simplified().left(longest_name).toStdString();
    if (row < 0 || row >= areas_.size() || wanted.empty() || areas_[row].name == wanted) return;
    QList<Area> after = areas_;
    after[row].name = wanted;
    change(tr("rename %1").arg(QString::fromStdString(areas_[row].name)), after);
}

void AreaModel::setCorner(int row, int corner, const Eigen::Vector2f& at) {
    if (row < 0 || row >= areas_.size() || corner < 0 || corner >= static_cast<int>(areas_[row].corners_m.size()))
        return;
    QList<Area> after = areas_;
    after[row].corners_m[static_cast<std::size_t>(corner)] = at;
    change(tr("corner of %1").arg(QString::fromStdString(areas_[row].name)), after);
}

void AreaModel::setWithVehicle(int row, bool on, const Pose& vehicle) {
    if (row < 0 || row >= areas_.size() || areas_[row].with_vehicle == on) return;
    const Area& before = areas_[row];
    QList<Area> after = areas_;
    after[row].with_vehicle = on;
    for (Eigen::Vector2f& corner : after[row].corners_m)
        corner = cornerAt(after[row], placeOf(before, corner, vehicle), vehicle);
    change(tr("frame of %1").arg(QString::fromStdString(before.name)), after);
}

void AreaModel::remove(int row) {
    if (row < 0 || row >= areas_.size()) return;
    QList<Area> after = areas_;
    const Area gone = after.takeAt(row);
    change(tr("delete %1").arg(QString::fromStdString(gone.name)), after);
}

void AreaModel::replace(const QList<Area>& areas) { show(areas.mid(0, most_areas)); }

void AreaModel::change(const QString& what, QList<Area> after) {
    undo_.push(new ListChange<Area>(what, areas_, std::move(after), [this](const auto& areas) { show(areas); }));
}

void AreaModel::show(const QList<Area>& areas) {
    beginResetModel();
    areas_ = areas;
    endResetModel();
    Q_EMIT changed();
}

int AreaModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(areas_.size());
}

int AreaModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : ColumnCount; }

QVariant AreaModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const Area& area = areas_[index.row()];
    if (role == Qt::EditRole && index.column() != Name) return {};
    if (role != Qt::DisplayRole && role != Qt::EditRole) return {};
    switch (index.column()) {
        case Name:
            return QString::fromStdString(area.name);
        case Kind:
            return kindTitle(area.kind);
        default:
            return area.with_vehicle ? tr("with the vehicle") : tr("on the ground");
    }
}

QVariant AreaModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    switch (section) {
        case Name:
            return tr("Area");
        case Kind:
            return tr("Kind");
        case Frame:
            return tr("Fixed");
        default:
            return {};
    }
}

Qt::ItemFlags AreaModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    return index.isValid() && index.column() == Name ? flags | Qt::ItemIsEditable : flags;
}

bool AreaModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || !index.isValid() || index.column() != Name) return false;
    rename(index.row(), value.toString());
    return true;
}

}  // namespace echotrail
