#include "ui/main_window/recent_recordings.hpp"

#include <QFileInfo>
#include <QSettings>

namespace echotrail {
namespace {

constexpr auto key = "recent_recordings";
constexpr qsizetype most = 8;

}  // namespace

QStringList recentRecordings() {
    QStringList existing;
    for (const QString& path : QSettings().value(key).toStringList())
        if (QFileInfo::exists(path)) existing << path;
    return existing;
}

void rememberRecording(const QString& path) {
    const QString full = QFileInfo(path).absoluteFilePath();
    QStringList paths = recentRecordings();
    paths.removeAll(full);
    paths.prepend(full);
    QSettings().setValue(key, paths.mid(0, most));
}

}  // namespace echotrail
