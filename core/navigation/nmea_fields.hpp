#pragma once

#include "core/base/time.hpp"

#include <cstddef>
#include <string>

namespace echotrail {

/// Fields of NMEA 0183 sentences (version 4.10) as they are said.

/// A number with a decimal point, whatever the locale; digits before it are filled up with zeros to `whole`.
std::string nmeaNumber(double value, int decimals, std::size_t whole = 1);

/// `ddmm.mmmmmm,N`, with as many digits of degrees as asked for: 2 of a latitude (N, S), 3 of a longitude (E, W).
std::string nmeaCoordinate(double radians, std::size_t degree_digits, char positive, char negative);

/// `hhmmss.sss`, UTC.
std::string nmeaTimeOfDay(Timestamp utc);

}  // namespace echotrail
