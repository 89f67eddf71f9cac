#include "ui/panels/transport/moment.hpp"

#include <QDateTime>
#include <QRegularExpression>
#include <QStringList>
#include <QTimeZone>
#include <cmath>

namespace echotrail {
namespace {

std::optional<double> secondsFromClock(const QString& text) {
    double seconds = 0.0;
    for (const QString& part : text.split(':')) {
        bool number = false;
        const double value = part.toDouble(&number);
        if (!number || !std::isfinite(value) || value < 0.0) return std::nullopt;
        seconds = 60.0 * seconds + value;
    }
    return seconds;
}

}  // namespace

std::optional<Timestamp> momentFromText(const QString& text, Timestamp start) {
    static const QRegularExpression date(
        QStringLiteral("^(\\d{4}-\\d{2}-\\d{2})[T ](\\d{2}:\\d{2}:\\d{2}(?:\\.\\d+)?)Z?$"));
    QString typed = text.trimmed();
    if (const auto match = date.match(typed); match.hasMatch()) {
        const QDate day = QDate::fromString(match.captured(1), Qt::ISODate);
        const auto seconds = secondsFromClock(match.captured(2));
        if (!day.isValid() || !seconds || *seconds >= 86400.0) return std::nullopt;
        const qint64 midnight = QDateTime(day, QTime(0, 0), QTimeZone::utc()).toSecsSinceEpoch();
        return Timestamp(std::chrono::seconds(midnight)) + microsecondsFromSeconds(*seconds);
    }
    if (typed.endsWith('s')) typed = typed.chopped(1).trimmed();
    if (typed.count(':') > 2) return std::nullopt;
    const auto seconds = secondsFromClock(typed);
    if (!seconds || *seconds > 1e8) return std::nullopt;
    return start + microsecondsFromSeconds(*seconds);
}

QString elapsedText(double seconds) {
    const auto tenths = static_cast<qint64>(std::floor(std::max(0.0, seconds) * 10.0 + 1e-6));
    const auto two = [](qint64 value) { return QStringLiteral("%1").arg(value, 2, 10, QChar('0')); };
    return two(tenths / 36000) + ":" + two(tenths / 600 % 60) + ":" + two(tenths / 10 % 60) + "." +
           QString::number(tenths % 10);
}

}  // namespace echotrail
