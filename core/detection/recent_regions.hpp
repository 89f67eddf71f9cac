#pragma once

#include "core/data/region.hpp"

#include <deque>
#include <vector>

namespace echotrail {

/// How far behind an echo, and how much weaker, its copies by way of bottom or surface are taken to be.
struct MultipathRule {
    double farthest_m;
    double weaker_db;
};

/// What the beam has left lately, to tell copies of an echo from things of their own.
/// Order: regions as they are completed, about in order of time. State: those of the last seconds, without outlines.
class RecentRegions {
public:
    void add(const std::vector<Region>& regions);
    /// Whether one of them explains this region: it lies at the same bearing and nearer, is stronger, and was seen in
    /// the same passage of the beam (method card, section d). A clutter mass explains nothing: it has no such copies.
    bool explain(const Region& region, const MultipathRule& rule) const;
    /// Whether a place in the local frame lay in a clutter mass when the beam was there.
    bool hasMassAt(const Eigen::Vector2d& place_m, Timestamp time) const;

private:
    std::deque<Region> regions_;
};

}  // namespace echotrail
