#include "ui/alerts/alert_model.hpp"

#include "ui/alerts/alert_rules.hpp"
#include "ui/style/formatter.hpp"

#include <algorithm>

namespace echotrail {
namespace {

QString clock(Timestamp time) { return Formatter::utc(time).mid(11, 8); }

/// "14:02:10", or "14:02:10–14:02:41 (31.0 s)" of what is over.
QString timeText(const Alert& alert) {
    if (!alert.ended || alert.passing) return clock(alert.raised);
    return clock(alert.raised) + QChar(0x2013) + clock(*alert.ended) + " (" +
           Formatter::age(secondsBetween(alert.raised, *alert.ended)) + ")";
}

QString stateWord(const Alert& alert) {
    if (alert.isNew()) return AlertModel::tr("not acknowledged");
    return alert.ended ? AlertModel::tr("over") : AlertModel::tr("lasting");
}

}  // namespace

void AlertModel::setAlerts(const std::vector<Alert>& alerts) {
    const auto has = [&](int id) {
        return std::any_of(alerts.begin(), alerts.end(), [id](const Alert& alert) { return alert.id == id; });
    };
    for (int at = rowCount() - 1; at >= 0; --at) {
        if (has(idAt(at))) continue;
        beginRemoveRows({}, at, at);
        alerts_.erase(alerts_.begin() + at);
        endRemoveRows();
    }
    for (int at = 0; at < static_cast<int>(alerts.size()); ++at) {
        const Alert& alert = alerts[static_cast<std::size_t>(at)];
        const int now = rowOf(alert.id);
        if (now < 0) {
            beginInsertRows({}, at, at);
            alerts_.insert(alerts_.begin() + at, alert);
            endInsertRows();
        } else if (now != at) {
            beginMoveRows({}, now, now, {}, at);  // what is above `at` is in place, so the row comes from below
            std::rotate(alerts_.begin() + at, alerts_.begin() + now, alerts_.begin() + now + 1);
            endMoveRows();
        }
    }
    alerts_ = alerts;
    if (!alerts_.empty()) Q_EMIT dataChanged(index(0), index(rowCount() - 1));
}

int AlertModel::rowOf(int id) const {
    const auto found =
        std::find_if(alerts_.begin(), alerts_.end(), [id](const Alert& alert) { return alert.id == id; });
    return found == alerts_.end() ? -1 : static_cast<int>(found - alerts_.begin());
}

int AlertModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(alerts_.size());
}

QVariant AlertModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const Alert& alert = alerts_[static_cast<std::size_t>(index.row())];
    switch (role) {
        case Qt::DisplayRole:
            return alert.situation.title;
        case Qt::ToolTipRole:
            return priorityWord(alert.priority) + ", " + stateWord(alert) + "\n" + alert.situation.title + "\n" +
                   alert.situation.cause + "\n" + timeText(alert) + " UTC";
        case Qt::AccessibleTextRole:
            return priorityWord(alert.priority) + ": " + alert.situation.title + ", " + stateWord(alert) + ", " +
                   alert.situation.cause;
        case IdRole:
            return alert.id;
        case PriorityRole:
            return static_cast<int>(alert.priority);
        case CauseRole:
            return alert.situation.cause;
        case TimeRole:
            return timeText(alert);
        case NewRole:
            return alert.isNew();
        case OverRole:
            return alert.ended.has_value();
        default:
            return {};
    }
}

}  // namespace echotrail
