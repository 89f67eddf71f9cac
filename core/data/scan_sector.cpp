#include "core/data/scan_sector.hpp"

#include <cmath>

namespace echotrail {

bool contains(const ScanSector& outer, const ScanSector& inner) {
    constexpr double smallest_step_deg = 360.0 / 6400.0;
    if (outer.fullCircle()) return true;
    const double apart_deg =
        degreesFromRadians(std::abs(Bearing::degrees(inner.centre_deg) - Bearing::degrees(outer.centre_deg)));
    return apart_deg + inner.width_deg / 2.0 < outer.width_deg / 2.0 + smallest_step_deg;
}

}  // namespace echotrail
