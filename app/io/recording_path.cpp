#include "app/io/recording_path.hpp"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <QTimeZone>

namespace echotrail {
namespace {

Result<QString> made(const QString& folder) {
    if (!QDir().mkpath(folder)) return Error{"the folder " + folder.toStdString() + " cannot be made"};
    return folder;
}

QString stemOf(const QDateTime& time) { return time.toString("yyyyMMdd-HHmmss"); }

/// Letters, digits and what does no harm in a file's name.
QString nameFrom(const std::string& tracker) {
    constexpr std::size_t longest = 40;
    QString name;
    for (const char c : tracker.substr(0, longest))
        name += std::isalnum(static_cast<unsigned char>(c)) || c == '_' ? QChar(c) : QChar('_');
    return name.isEmpty() ? QString("tracker") : name;
}

}  // namespace

std::string recordingsFolder() {
    return (QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) + "/echotrail/recordings")
        .toStdString();
}

Result<std::string> newRecordingPath() {
    const auto folder = made(QString::fromStdString(recordingsFolder()));
    if (!folder) return Error{folder.error()};
    const QString stem = *folder + "/" + stemOf(QDateTime::currentDateTimeUtc());
    QString path = stem + ".echotrail";
    for (int i = 2; QFile::exists(path); ++i) path = QString("%1_%2.echotrail").arg(stem).arg(i);
    return path.toStdString();
}

Result<std::string> keptRecordingPath(const std::string& folder, const std::string& tracker, Timestamp started,
                                      int attempt) {
    const auto where = made(QString::fromStdString(folder));
    if (!where) return Error{where.error()};
    const auto milliseconds = std::chrono::duration_cast<std::chrono::milliseconds>(started.time_since_epoch());
    const auto begun = QDateTime::fromMSecsSinceEpoch(milliseconds.count(), QTimeZone::utc());
    const QString again = attempt > 1 ? "_" + QString::number(attempt) : QString();
    return (*where + "/" + nameFrom(tracker) + "-" + stemOf(begun) + again + ".echotrail").toStdString();
}

}  // namespace echotrail
