#include "core/simulation/vehicle_path.hpp"

#include <algorithm>
#include <cassert>

namespace echotrail {

VehiclePath::Moment VehiclePath::at(double time_s) const {
    assert(!moments_.empty());
    const auto next = std::lower_bound(moments_.begin(), moments_.end(), time_s,
                                       [](const Moment& moment, double time) { return moment.time_s < time; });
    if (next == moments_.begin()) {
        Moment waiting = moments_.front();
        if (time_s < waiting.time_s) waiting.over_ground_mps.setZero();
        waiting.time_s = time_s;
        return waiting;
    }
    Moment moment = *(next - 1);
    const double passed_s = time_s - moment.time_s;
    if (next == moments_.end()) {
        moment.pose.north_m += moment.over_ground_mps.x() * passed_s;
        moment.pose.east_m += moment.over_ground_mps.y() * passed_s;
    } else {
        const double u = passed_s / (next->time_s - moment.time_s);
        moment.pose.north_m += u * (next->pose.north_m - moment.pose.north_m);
        moment.pose.east_m += u * (next->pose.east_m - moment.pose.east_m);
        moment.pose.heading = moment.pose.heading + u * (next->pose.heading - moment.pose.heading);
        moment.over_ground_mps += u * (next->over_ground_mps - moment.over_ground_mps);
    }
    moment.time_s = time_s;
    return moment;
}

}  // namespace echotrail
