#pragma once

#include "core/data/pose.hpp"

#include <Eigen/Core>

#include <vector>

namespace echotrail {

/// Where a vehicle that is steered has been: as far as it has come, and a little on.
/// Order: moments in order of time.
class VehiclePath {
public:
    struct Moment {
        double time_s = 0.0;  ///< since the scenario's start
        Pose pose;
        Eigen::Vector2d over_ground_mps{0, 0};  ///< north, east
    };
    void add(const Moment& moment) { moments_.push_back(moment); }
    bool empty() const { return moments_.empty(); }
    const Moment& last() const { return moments_.back(); }

    /// At a time: straight between moments; before the first it waits there, after the last it goes on as it went.
    /// There is at least one.
    Moment at(double time_s) const;

private:
    std::vector<Moment> moments_;
};

}  // namespace echotrail
