#include "ui/panels/connection/recent_links.hpp"

#include <QSettings>

namespace echotrail {
namespace {

constexpr qsizetype most = 8;

QString keyOf(LinkUse use) {
    return use == LinkUse::Sonar ? QStringLiteral("recent_sonar_links") : QStringLiteral("recent_navigation_links");
}

}  // namespace

QStringList recentLinks(LinkUse use) { return QSettings().value(keyOf(use)).toStringList(); }

void rememberLink(LinkUse use, const QString& address) {
    QStringList links = recentLinks(use);
    links.removeAll(address);
    links.prepend(address);
    QSettings().setValue(keyOf(use), links.mid(0, most));
}

}  // namespace echotrail
