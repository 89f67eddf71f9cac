#pragma once

#include "core/base/angles.hpp"

namespace echotrail {

enum class SectorEdge { Left, Right };

/// The sector a head is told to scan, as its settings have it: degrees, clockwise from the bow.
struct CommandedSector {
    double centre_deg = 0.0;
    double width_deg = 90.0;
    double step_deg = 1.8;
    bool operator==(const CommandedSector&) const = default;

    Bearing edge(SectorEdge edge) const;
};

/// The same with one edge where the width becomes about `width_deg`: snapped to whole steps from the other edge, which
/// stays; no narrower than a head can scan, no wider than round and round.
CommandedSector withWidth(const CommandedSector& sector, SectorEdge moved, double width_deg);

/// One edge moved outwards by so many steps, inwards by negative ones.
CommandedSector widened(const CommandedSector& sector, SectorEdge moved, int steps);

}  // namespace echotrail
