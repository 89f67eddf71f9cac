#include "app/io/recording_path.hpp"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QStandardPaths>

namespace echotrail {

std::string recordingsFolder() {
    const QString data = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation);
    return data.toStdString() + "/echotrail/recordings";
}

Result<std::string> newRecordingPath() {
    const QString folder = QString::fromStdString(recordingsFolder());
    if (!QDir().mkpath(folder)) return Error{"the folder " + folder.toStdString() + " cannot be made"};
    const QString stem = folder + "/" + QDateTime::currentDateTimeUtc().toString("yyyyMMdd-HHmmss");
    QString path = stem + ".echotrail";
    for (int i = 2; QFile::exists(path); ++i) path = QString("%1_%2.echotrail").arg(stem).arg(i);
    return path.toStdString();
}

}  // namespace echotrail
