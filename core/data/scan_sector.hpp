#pragma once

#include "core/base/angles.hpp"

namespace echotrail {

/// What a head scans to and fro, as its settings have it, in degrees.
struct ScanSector {
    double centre_deg = 0.0;  ///< clockwise from the bow
    double width_deg = 90.0;  ///< 360: round and round
    bool operator==(const ScanSector&) const = default;

    bool fullCircle() const { return width_deg >= 360.0; }
    /// Its left edge, from the bow.
    Bearing left() const { return Bearing::degrees(centre_deg - width_deg / 2.0); }
};

/// Whether all of `inner` lies in `outer`, but for less than a head's smallest step.
bool contains(const ScanSector& outer, const ScanSector& inner);

}  // namespace echotrail
