#pragma once

#include <compare>
#include <numbers>

namespace echotrail {

/// Brings an angle in radians into [-pi, pi).
double wrapRadians(double radians);

constexpr double radiansFromDegrees(double degrees) { return degrees * (std::numbers::pi / 180.0); }
constexpr double degreesFromRadians(double radians) { return radians * (180.0 / std::numbers::pi); }

/// A direction, always in [-pi, pi), clockwise seen from above. What it is measured from (the bow, or north)
/// is part of the name of the variable that holds it.
class Bearing {
public:
    constexpr Bearing() = default;
    static Bearing radians(double value) { return Bearing(wrapRadians(value)); }
    static Bearing degrees(double value) { return radians(radiansFromDegrees(value)); }

    constexpr double inRadians() const { return radians_; }
    constexpr double inDegrees() const { return degreesFromRadians(radians_); }

    /// The turn in radians from `b` to `a`, the short way round: in [-pi, pi).
    friend double operator-(Bearing a, Bearing b) { return wrapRadians(a.radians_ - b.radians_); }
    friend Bearing operator+(Bearing b, double turn_rad) { return radians(b.radians_ + turn_rad); }
    friend constexpr bool operator==(Bearing, Bearing) = default;

private:
    constexpr explicit Bearing(double wrapped) : radians_(wrapped) {}
    double radians_ = 0.0;
};

}  // namespace echotrail
