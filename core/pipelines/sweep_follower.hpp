#pragma once

#include "core/base/angles.hpp"
#include "core/base/time.hpp"

#include <optional>

namespace echotrail {

/// Tells sweeps from the measured bearings. Heads do not mark the ends of a sweep reliably: some log both ends
/// twice, some overstep a limit by a step, many leave the sweep code at 0.
/// Order: pings in time order. State: the last bearing and direction.
class SweepFollower {
public:
    struct Step {
        bool turned_round =
            false;                 ///< the movement broke off before this ping: turned, flew back, or pings are missing
        bool sweep_ended = false;  ///< a sweep was finished before this ping: turned, flew back or full circle
        bool pings_missing = false;  ///< it comes later than those before it let expect
    };
    Step follow(Bearing head_bearing, double step_rad, Timestamp time);

private:
    std::optional<Bearing> last_;
    Timestamp last_time_{};
    double interval_s_ = 0.0;  ///< between pings, as it usually is; 0: not known yet
    int direction_ = 0;        ///< +1 clockwise, −1 anticlockwise, 0 not known yet
    double turned_rad_ = 0.0;  ///< in this sweep
};

}  // namespace echotrail
