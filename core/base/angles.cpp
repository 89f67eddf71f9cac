#include "core/base/angles.hpp"

#include <cmath>

namespace echotrail {

double wrapRadians(double radians) {
    constexpr double pi = std::numbers::pi;
    if (radians >= -pi && radians < pi) return radians;
    const double wrapped = radians - 2.0 * pi * std::floor((radians + pi) / (2.0 * pi));
    return wrapped < pi ? wrapped : -pi;  // rounding may land exactly on +pi
}

}  // namespace echotrail
