#pragma once

#include <chrono>
#include <string>

namespace echotrail {

/// A moment: microseconds of UTC since 1970. It always comes with the data; the core reads no clock.
using Timestamp = std::chrono::sys_time<std::chrono::microseconds>;
using Microseconds = std::chrono::microseconds;

/// Seconds from `earlier` to `later`.
inline double secondsBetween(Timestamp earlier, Timestamp later) {
    return std::chrono::duration<double>(later - earlier).count();
}

/// The nearest whole number of microseconds.
Microseconds microsecondsFromSeconds(double seconds);

/// ISO 8601 with microseconds, e.g. `2005-05-22T14:53:19.890000Z`.
std::string toIso8601(Timestamp time);

}  // namespace echotrail
