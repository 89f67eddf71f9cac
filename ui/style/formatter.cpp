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

}  // namespace

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

QString Formatter::age(double seconds) { return withUnit(seconds, 1, "s"); }

QString Formatter::speed(double metres_per_second) { return withUnit(metres_per_second, 2, "m/s"); }

QString Formatter::probability(double value) { return number(value, 2); }

QString Formatter::utc(Timestamp time) {
    // Milliseconds are cut, not rounded: a moment is never shown before it has come.
    return QString::fromStdString(toIso8601(time)).chopped(4) + "Z";
}

QString Formatter::trackId(int id) { return QString("T%1").arg(id, 2, 10, QChar('0')); }

}  // namespace echotrail
