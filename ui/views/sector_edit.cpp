#include "ui/views/sector_edit.hpp"

#include <algorithm>
#include <cmath>

namespace echotrail {
namespace {

constexpr double narrowest_deg = 0.225, full_circle_deg = 360.0;

/// A head counts in 1/16 gradian, 0.05625°: half of that has six decimals. More would be noise that someone has to
/// read.
double tidy(double degrees) { return std::round(degrees * 1e6) / 1e6; }

}  // namespace

Bearing CommandedSector::edge(SectorEdge edge) const {
    const double half = width_deg / 2.0;
    // A hair inside, so that the edges of a full circle lie on their own sides of it.
    const double inside = width_deg >= full_circle_deg ? half - 1e-6 : half;
    return Bearing::degrees(centre_deg + (edge == SectorEdge::Left ? -inside : inside));
}

CommandedSector withWidth(const CommandedSector& sector, SectorEdge moved, double width_deg) {
    const double step = sector.step_deg;
    const double least = std::max(step, std::ceil(narrowest_deg / step - 1e-9) * step);
    double width = std::max(std::round(width_deg / step) * step, least);
    if (width > full_circle_deg - step / 2.0) width = full_circle_deg;
    const double outwards = (width - sector.width_deg) / 2.0;
    CommandedSector changed = sector;
    changed.width_deg = tidy(width);
    changed.centre_deg =
        tidy(Bearing::degrees(sector.centre_deg + (moved == SectorEdge::Left ? -outwards : outwards)).inDegrees());
    return changed;
}

CommandedSector widened(const CommandedSector& sector, SectorEdge moved, int steps) {
    return withWidth(sector, moved, sector.width_deg + steps * sector.step_deg);
}

}  // namespace echotrail
