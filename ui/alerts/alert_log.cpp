#include "ui/alerts/alert_log.hpp"

#include "ui/style/formatter.hpp"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

namespace echotrail {
namespace {

/// In the file the words are the same in every language, so that a program can read it.
QString word(AlertChange::What what) {
    switch (what) {
        case AlertChange::What::Raised:
            return "raised";
        case AlertChange::What::Escalated:
            return "escalated";
        case AlertChange::What::Acknowledged:
            return "acknowledged";
        case AlertChange::What::Ended:
            break;
    }
    return "ended";
}

QString word(AlertPriority priority) {
    switch (priority) {
        case AlertPriority::Emergency:
            return "emergency";
        case AlertPriority::Alarm:
            return "alarm";
        case AlertPriority::Warning:
            return "warning";
        case AlertPriority::Caution:
            break;
    }
    return "caution";
}

/// Names come from far trackers too: a line stays a line.
QString oneLine(QString text) { return text.replace('\n', ' ').replace('\r', ' '); }

}  // namespace

bool AlertLog::write(const std::vector<AlertChange>& changes) const {
    if (changes.empty()) return true;
    if (!QDir().mkpath(QFileInfo(path_).path())) return false;
    if (QFileInfo(path_).size() >= most_bytes) {
        QFile::remove(path_ + ".1");
        QFile::rename(path_, path_ + ".1");
    }
    QFile file(path_);
    if (!file.open(QIODevice::Append | QIODevice::Text)) return false;
    for (const AlertChange& change : changes) {
        const Situation& situation = change.alert.situation;
        const QString line = Formatter::utc(change.time) + ' ' + word(change.what) + ' ' + word(change.alert.priority) +
                             ' ' + situation.key + ": " + situation.title + (situation.cause.isEmpty() ? "" : ". ") +
                             situation.cause;
        if (file.write((oneLine(line) + '\n').toUtf8()) < 0) return false;
    }
    return file.flush();
}

QString alertLogPath() {
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) + "/echotrail/alerts.log";
}

}  // namespace echotrail
