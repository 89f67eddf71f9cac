#pragma once

namespace echotrail {

/// How many deviations about an expected place are looked at.
inline constexpr double gate_sigmas = 3.0;

}  // namespace echotrail
