#pragma once

#include <cstdint>
#include <vector>

#include "core/data/pose.hpp"
#include "core/data/region.hpp"
#include "core/data/track.hpp"

namespace echotrail {

/// What one ping brought about.
struct Update {
    std::uint64_t ping = 0;          ///< sequence number
    Timestamp time{};                ///< of the ping
    Pose pose;                       ///< at that time
    Pose later_pose;                 ///< half a flight of sound later, when the farthest echo was reflected
    bool navigation_gap = false;     ///< no pose near enough in time: tracks coast
    Bearing beam;                    ///< of the ping, from the bow
    bool broke_off = false;          ///< the beam's movement broke off before it: nothing is painted in between
    std::uint64_t sweep = 0;         ///< the sweep this ping belongs to, from 0
    bool sweep_ended = false;        ///< this ping began a new sweep
    std::vector<Region> regions;     ///< that the beam has just left
    std::vector<TrackLook> looks;    ///< tracks that were looked at, in time order
};

}  // namespace echotrail
