#pragma once

namespace echotrail {

/// How many deviations about an expected place are looked at.
inline constexpr double gate_sigmas = 3.0;

/// Of the area that is expected: a region this large may hold more than one echo.
inline constexpr double merged_area = 1.5;

}  // namespace echotrail
