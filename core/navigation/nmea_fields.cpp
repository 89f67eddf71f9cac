#include "core/navigation/nmea_fields.hpp"

#include "core/base/angles.hpp"

#include <array>
#include <cassert>
#include <charconv>
#include <chrono>
#include <cmath>

namespace echotrail {

std::string nmeaNumber(double value, int decimals, std::size_t whole) {
    const double scale = std::pow(10.0, decimals);
    const double rounded = std::round(value * scale) / scale + 0.0;  // no "-0"
    std::array<char, 64> text{};
    const auto done =
        std::to_chars(text.data(), text.data() + text.size(), rounded, std::chars_format::fixed, decimals);
    assert(done.ec == std::errc());
    std::string digits(text.data(), done.ptr);
    const std::size_t length = whole + (decimals > 0 ? 1 : 0) + static_cast<std::size_t>(decimals);
    if (digits.size() < length) digits.insert(0, length - digits.size(), '0');
    return digits;
}

std::string nmeaCoordinate(double radians, std::size_t degree_digits, char positive, char negative) {
    constexpr double millionths = 60e6;  // of a minute, in a degree
    // Rounded before it is split, so that no minutes of 60 come about.
    const double rounded = std::round(std::abs(degreesFromRadians(radians)) * millionths);
    const double degrees = std::floor(rounded / millionths);
    return nmeaNumber(degrees, 0, degree_digits) + nmeaNumber((rounded - degrees * millionths) / 1e6, 6, 2) + ',' +
           (radians < 0.0 ? negative : positive);
}

std::string nmeaTimeOfDay(Timestamp utc) {
    const auto since_midnight = utc - std::chrono::floor<std::chrono::days>(utc);
    const std::chrono::hh_mm_ss time(std::chrono::floor<std::chrono::milliseconds>(since_midnight));
    const double seconds = std::chrono::duration<double>(time.seconds() + time.subseconds()).count();
    return nmeaNumber(static_cast<double>(time.hours().count()), 0, 2) +
           nmeaNumber(static_cast<double>(time.minutes().count()), 0, 2) + nmeaNumber(seconds, 3, 2);
}

}  // namespace echotrail
