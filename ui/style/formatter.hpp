#pragma once

#include "core/base/angles.hpp"
#include "core/base/time.hpp"

#include <QHash>
#include <QString>
#include <cstdint>

namespace echotrail {

/// The operator's own names of tracks, by id.
using TrackNames = QHash<int, QString>;

/// The one way numbers become text: decimal point, true minus, thin groups, a unit after a narrow space. A value that
/// is not finite is unknown, and unknown is a dash, never 0.
class Formatter {
public:
    static QString unknown();
    /// "−1 184.25"
    static QString number(double value, int decimals);
    /// "+14.5", "−27.6"
    static QString signedNumber(double value, int decimals);
    /// "54°21.4183′ N", "010°09.7712′ E": WGS-84.
    static QString latitude(double radians);
    static QString longitude(double radians);
    /// "12.5 dB"; the unit is left out where the value is unknown.
    static QString withUnit(double value, int decimals, const QString& unit);
    /// In MB, from 1 GB on in GB.
    static QString bytes(std::uint64_t number);
    /// "12 480"
    static QString count(std::uint64_t value);
    /// "21.1 m"; two decimals below 10 m.
    static QString range(double metres);
    /// The same without the unit, for columns that name it in their head.
    static QString rangeNumber(double metres);
    /// "045.3°R": from the bow, 000.0 to 359.9.
    static QString relativeBearing(Bearing from_bow);
    /// "045.3°T": from north.
    static QString trueBearing(Bearing from_north);
    /// "045.3"
    static QString bearingNumber(Bearing bearing);
    /// "−30°", "00°", "+30°": marks on the fan.
    static QString bearingMark(int degrees_from_bow);
    /// "1.7 s"
    static QString age(double seconds);
    /// "0.85 m/s"
    static QString speed(double metres_per_second);
    /// "0.94"
    static QString probability(double value);
    /// "2010-05-23T08:00:12.950Z"
    static QString utc(Timestamp time);
    /// "T07"
    static QString trackId(int id);
    /// "T03 buoy": with the operator's name for it, where there is one.
    static QString trackLabel(int id, const TrackNames& names);
};

}  // namespace echotrail
