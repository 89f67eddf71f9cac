#include "core/detection/recent_regions.hpp"

#include <algorithm>
#include <cmath>

namespace echotrail {
namespace {

constexpr double nearest_m = 0.2;
constexpr double passage_s = 2.0;

}  // namespace

void RecentRegions::add(const std::vector<Region>& regions) {
    for (const Region& region : regions) {
        regions_.push_back(region);
        regions_.back().outline_m.clear();
    }
    while (!regions_.empty() && secondsBetween(regions_.front().time, regions_.back().time) > 2.0 * passage_s)
        regions_.pop_front();
}

bool RecentRegions::explain(const Region& region, const MultipathRule& rule) const {
    return std::any_of(regions_.begin(), regions_.end(), [&](const Region& other) {
        const double beyond_m = region.range_m - other.range_m;
        const double apart_m = std::abs(region.bearing - other.bearing) * region.range_m;
        const double reach_m = std::max(other.features.across_range_m, region.features.across_range_m) / 2.0;
        return !other.clutter_mass && beyond_m > nearest_m && beyond_m < rule.farthest_m && apart_m < reach_m &&
               other.peak_db - region.peak_db >= rule.weaker_db &&
               std::abs(secondsBetween(other.time, region.time)) < passage_s;
    });
}

bool RecentRegions::hasMassAt(const Eigen::Vector2d& place_m, Timestamp time) const {
    return std::any_of(regions_.begin(), regions_.end(), [&](const Region& region) {
        if (!region.clutter_mass || std::abs(secondsBetween(region.time, time)) >= passage_s) return false;
        // Its outline is gone; its widths along the line of sight and across it do.
        const Eigen::Vector2d sight = region.position_m - Eigen::Vector2d(region.head.north_m, region.head.east_m);
        const Eigen::Vector2d along = sight / std::max(sight.norm(), 0.1), off = place_m - region.position_m;
        return std::abs(off.dot(along)) < region.features.along_range_m / 2.0 &&
               std::abs(off.x() * along.y() - off.y() * along.x()) < region.features.across_range_m / 2.0;
    });
}

}  // namespace echotrail
