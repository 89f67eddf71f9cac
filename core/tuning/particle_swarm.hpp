#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace echotrail {

/// The constants of the method card, section c.
struct SwarmParams {
    int particles = 20;
    int iterations = 30;
    double first_inertia = 0.9, last_inertia = 0.4;  ///< share of the velocity that is kept, falling evenly
    double own_pull = 2.0;                           ///< towards the best place of the particle itself
    double common_pull = 2.0;                        ///< towards the best place of all
    double fastest_share = 0.2;                      ///< of a bound's width, in one iteration
    double rebound = 0.5;                            ///< of the velocity, the other way, at a bound
};

/// What one coordinate may be, both ends included.
struct Bounds {
    double low = 0.0;
    double high = 1.0;
};

using SwarmPoint = std::vector<double>;

struct SwarmResult {
    SwarmPoint best;
    double value = -std::numeric_limits<double>::infinity();
    int evaluations = 0;
};

/// Looks for the point within `bounds` where a function is greatest, by particle swarm (Kennedy & Eberhart 1995, with
/// the falling inertia of Shi & Eberhart 1998). One particle begins at `start`, brought within the bounds, the others
/// anywhere. A value that is no number counts as the worst there is.
///
/// `evaluate` is given the points of a whole iteration at once and fills in their values, so that a caller may share
/// them among threads: the answer depends on the seed alone. `cancelled`, asked before each iteration, ends the search
/// with what it has found.
SwarmResult maximise(const std::function<void(std::span<const SwarmPoint>, std::span<double>)>& evaluate,
                     const std::vector<Bounds>& bounds, const SwarmPoint& start, std::uint64_t seed,
                     const SwarmParams& params = {}, const std::function<bool()>& cancelled = {});

}  // namespace echotrail
