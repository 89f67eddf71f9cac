#include "ui/style/formatter.hpp"

#include <QLocale>
#include <cmath>

namespace echotrail {
namespace {

const QString thin_space = QString(QChar(0x2009));
const QString minus = QString(QChar(0x2212));

/// Thin spaces between groups of three, counted from the end of the whole part.
QString grouped(QString digits) {
    const qsizetype point = digits.indexOf('.');
    const qsizetype whole = point < 0 ? digits.size() : point;
    for (qsizetype at = whole - 3; at > 0; at -= 3) digits.insert(at, thin_space);
    return digits;
}

/// Degrees of `digits` figures and minutes of four decimals, then the letter of its half of the earth.
QString degreesAndMinutes(double radians, int digits, char positive, char negative) {
    if (!std::isfinite(radians)) return Formatter::unknown();
    constexpr std::int64_t parts = 60 * 10'000;  // of a degree
    const std::int64_t all = std::llround(std::abs(degreesFromRadians(radians)) * static_cast<double>(parts));
    const std::int64_t rest = all % parts;
    return QString("%1%2%3.%4%5 %6")
        .arg(all / parts, digits, 10, QChar('0'))
        .arg(QChar(0xb0))
        .arg(rest / 10'000, 2, 10, QChar('0'))
        .arg(rest % 10'000, 4, 10, QChar('0'))
        .arg(QChar(0x2032))
        .arg(QChar(radians < 0.0 ? negative : positive));
}

}  // namespace

QString Formatter::signedNumber(double value, int decimals) {
    const QString digits = number(value, decimals);
    return std::isfinite(value) && !digits.startsWith(minus) ? '+' + digits : digits;
}

QString Formatter::latitude(double radians) { return degreesAndMinutes(radians, 2, 'N', 'S'); }

QString Formatter::longitude(double radians) { return degreesAndMinutes(radians, 3, 'E', 'W'); }

QString Formatter::unknown() { return QString(QChar(0x2014)); }

QString Formatter::number(double value, int decimals) {
    if (!std::isfinite(value)) return unknown();
    const QString digits = QLocale::c().toString(std::abs(value), 'f', decimals).remove(',');
    // "−0.0" would claim a side where there is none.
    const bool negative = value < 0.0 && digits.toDouble() != 0.0;
    return (negative ? minus : QString()) + grouped(digits);
}

QString Formatter::withUnit(double value, int decimals, const QString& unit) {
    if (!std::isfinite(value)) return unknown();
    return number(value, decimals) + " " + unit;
}

QString Formatter::count(std::uint64_t value) { return grouped(QString::number(value)); }

QString Formatter::rangeNumber(double metres) { return number(metres, metres < 9.995 ? 2 : 1); }

QString Formatter::range(double metres) { return std::isfinite(metres) ? rangeNumber(metres) + " m" : unknown(); }

QString Formatter::bearingNumber(Bearing bearing) {
    if (!std::isfinite(bearing.inRadians())) return unknown();
    const long tenths = std::lround(bearing.inDegrees() * 10.0 + 3600.0) % 3600;
    return QString("%1.%2").arg(tenths / 10, 3, 10, QChar('0')).arg(tenths % 10);
}

QString Formatter::relativeBearing(Bearing from_bow) {
    const QString digits = bearingNumber(from_bow);
    return digits == unknown() ? digits : digits + QChar(0xb0) + "R";
}

QString Formatter::trueBearing(Bearing from_north) {
    const QString digits = bearingNumber(from_north);
    return digits == unknown() ? digits : digits + QChar(0xb0) + "T";
}

QString Formatter::bearingMark(int degrees_from_bow) {
    const QString sign = degrees_from_bow > 0 ? QString("+") : degrees_from_bow < 0 ? minus : QString();
    return sign + QString("%1").arg(std::abs(degrees_from_bow), 2, 10, QChar('0')) + QChar(0xb0);
}

QString Formatter::bytes(std::uint64_t number) {
    const double megabytes = static_cast<double>(number) / 1e6;
    return megabytes < 1000.0 ? withUnit(megabytes, 1, "MB") : withUnit(megabytes / 1000.0, 1, "GB");
}

QString Formatter::age(double seconds) { return withUnit(seconds, 1, "s"); }

QString Formatter::speed(double metres_per_second) { return withUnit(metres_per_second, 2, "m/s"); }

QString Formatter::probability(double value) { return number(value, 2); }

QString Formatter::utc(Timestamp time) {
    // Milliseconds are cut, not rounded: a moment is never shown before it has come.
    return QString::fromStdString(toIso8601(time)).chopped(4) + "Z";
}

QString Formatter::trackId(int id) { return QString("T%1").arg(id, 2, 10, QChar('0')); }

QString Formatter::trackLabel(int id, const TrackNames& names) {
    const QString name = names.value(id);
    return name.isEmpty() ? trackId(id) : trackId(id) + " " + name;
}

}  // namespace echotrail
