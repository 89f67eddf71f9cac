#pragma once

#include <QStringList>

namespace echotrail {

/// The recordings opened last, newest first, kept in the settings. Files that are gone are left out.
QStringList recentRecordings();
void rememberRecording(const QString& path);

}  // namespace echotrail
