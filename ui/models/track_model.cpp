#include "ui/models/track_model.hpp"

#include "ui/style/formatter.hpp"
#include "ui/style/palette.hpp"
#include "ui/views/beam_schedule.hpp"
#include "ui/views/track_painter.hpp"

#include <QFont>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace echotrail {
namespace {

int rank(TrackState state) {
    switch (state) {
        case TrackState::Confirmed:
            return 0;
        case TrackState::Coasting:
            return 1;
        case TrackState::Tentative:
            return 2;
        case TrackState::Lost:
            break;
    }
    return 3;
}

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double least_moving_mps = 0.05;

}  // namespace

QString stateWord(TrackState state) {
    switch (state) {
        case TrackState::Confirmed:
            return TrackModel::tr("confirmed");
        case TrackState::Coasting:
            return TrackModel::tr("coasting");
        case TrackState::Tentative:
            return TrackModel::tr("tentative");
        case TrackState::Lost:
            break;
    }
    return TrackModel::tr("lost");
}

void TrackModel::setScene(const Scene& scene) {
    if (headingKnown(scene) != true_courses_) {
        true_courses_ = !true_courses_;
        Q_EMIT headerDataChanged(Qt::Horizontal, Course, Course);
    }
    std::vector<Row> rows;
    for (const Track& track : scene.tracks) {
        Row row{track.id, track.state, track.target};
        row.range_m = rangeOf(track, scene.latest.pose);
        row.from_bow = bearingOf(track, scene.latest.pose);
        // One look tells no speed.
        row.speed_mps = track.looks > 1 ? track.estimate.mean.tail<2>().norm() : unknown;
        row.course_rad = unknown;
        if (row.speed_mps >= least_moving_mps) {
            const double from_north = std::atan2(track.estimate.mean(3), track.estimate.mean(2));
            row.course_rad = from_north - (true_courses_ ? 0.0 : scene.latest.pose.heading.inRadians());
        }
        row.age_s = secondsBetween(track.last_seen, scene.latest.time);
        row.quality = track.existence;
        rows.push_back(row);
    }
    std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
        return std::tuple(!a.target, rank(a.state), a.id) < std::tuple(!b.target, rank(b.state), b.id);
    });
    setRows(rows);
}

void TrackModel::setRows(const std::vector<Row>& rows) {
    const auto has = [](const std::vector<Row>& among, int id) {
        return std::any_of(among.begin(), among.end(), [id](const Row& row) { return row.id == id; });
    };
    for (int at = rowCount() - 1; at >= 0; --at) {
        if (has(rows, idAt(at))) continue;
        beginRemoveRows({}, at, at);
        rows_.erase(rows_.begin() + at);
        endRemoveRows();
    }
    for (int at = 0; at < static_cast<int>(rows.size()); ++at) {
        const Row& row = rows[static_cast<std::size_t>(at)];
        const int now = rowOf(row.id);
        if (now < 0) {
            beginInsertRows({}, at, at);
            rows_.insert(rows_.begin() + at, row);
            endInsertRows();
        } else if (now != at) {
            beginMoveRows({}, now, now, {}, at);  // what is above `at` is in place, so the row comes from below
            std::rotate(rows_.begin() + at, rows_.begin() + now, rows_.begin() + now + 1);
            endMoveRows();
        }
    }
    rows_ = rows;
    if (!rows_.empty()) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

int TrackModel::rowOf(int id) const {
    const auto found = std::find_if(rows_.begin(), rows_.end(), [id](const Row& row) { return row.id == id; });
    return found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

int TrackModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int TrackModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : ColumnCount; }

QString TrackModel::text(const Row& row, int column) const {
    switch (column) {
        case Id:
            return Formatter::trackId(row.id);
        case State:
            return stateText(row);
        case Range:
            return Formatter::rangeNumber(row.range_m);
        case BearingFromBow:
            return Formatter::bearingNumber(row.from_bow);
        case Speed:
            return Formatter::number(row.speed_mps, 2);
        case Course:
            return std::isfinite(row.course_rad) ? Formatter::bearingNumber(Bearing::radians(row.course_rad))
                                                 : Formatter::unknown();
        case Age:
            return Formatter::number(row.age_s, 1);
        case Quality:
            return Formatter::probability(row.quality);
        default:
            return {};
    }
}

QString TrackModel::stateText(const Row& row) const {
    QStringList words{name(row.id), stateWord(row.state)};
    words.removeAll({});
    if (isMuted(row.id)) words << tr("muted");
    return words.join(QStringLiteral(" · "));
}

void TrackModel::setName(int id, const QString& name) {
    const QString kept = name.simplified().left(longest_name);
    if (kept.isEmpty())
        names_.remove(id);
    else
        names_[id] = kept;
    if (const int row = rowOf(id); row >= 0) Q_EMIT dataChanged(index(row, State), index(row, State));
}

void TrackModel::setMuted(int id, bool on) {
    if (on)
        muted_.insert(id);
    else
        muted_.remove(id);
    if (const int row = rowOf(id); row >= 0) Q_EMIT dataChanged(index(row, State), index(row, State));
}

void TrackModel::forgetTracks() {
    names_.clear();
    muted_.clear();
    clear();
}

QVariant TrackModel::foreground(const Row& row, int column) const {
    const Palette& palette = currentPalette();
    if (row.state == TrackState::Lost && column == State) return palette.alarm;
    if (row.state == TrackState::Lost && column != Id) return palette.off;
    if (row.state == TrackState::Tentative && column != Id) return palette.dim;
    return palette.text;
}

QVariant TrackModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const Row& row = rows_[static_cast<std::size_t>(index.row())];
    switch (role) {
        case Qt::DisplayRole:
            return text(row, index.column());
        case Qt::ForegroundRole:
            return foreground(row, index.column());
        case Qt::TextAlignmentRole:
            return QVariant(Qt::AlignVCenter | (index.column() >= Range ? Qt::AlignRight : Qt::AlignLeft));
        case Qt::AccessibleTextRole:
            return Formatter::trackId(row.id) + " " + stateText(row) + (row.target ? tr(", target") : QString());
        case Qt::ToolTipRole:
            return Formatter::trackId(row.id) + " " + stateText(row);
        case IdRole:
            return row.id;
        case StateRole:
            return static_cast<int>(row.state);
        case TargetRole:
            return row.target;
        default:
            return {};
    }
}

QVariant TrackModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    if (role == Qt::TextAlignmentRole)
        return QVariant(Qt::AlignVCenter | (section >= Range ? Qt::AlignRight : Qt::AlignLeft));
    if (role != Qt::DisplayRole) return {};
    switch (section) {
        case Id:
            return tr("ID");
        case State:
            return tr("State");
        case Range:
            return tr("Range m");
        case BearingFromBow:
            return tr("Brg °R");
        case Speed:
            return tr("m/s");
        case Course:
            return true_courses_ ? tr("Crs °T") : tr("Crs °R");
        case Age:
            return tr("Age s");
        case Quality:
            return tr("Qual.");
        default:
            return QString();
    }
}

}  // namespace echotrail
