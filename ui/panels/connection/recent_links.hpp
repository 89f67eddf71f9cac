#pragma once

#include <QStringList>

namespace echotrail {

enum class LinkUse { Sonar, Navigation };

/// The addresses connected to last, newest first, kept in the settings.
QStringList recentLinks(LinkUse use);
void rememberLink(LinkUse use, const QString& address);

}  // namespace echotrail
