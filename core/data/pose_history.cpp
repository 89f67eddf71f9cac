#include "core/data/pose.hpp"

#include <algorithm>
#include <cmath>

namespace echotrail {

void PoseHistory::add(const TimedPose& sample) {
    if (!samples_.empty() && sample.time <= samples_.back().time) {
        ++refused_;
        return;
    }
    samples_.push_back(sample);
}

void PoseHistory::forgetBefore(Timestamp time) {
    if (samples_.empty() || samples_[samples_.size() / 2].time >= time) return;
    std::erase_if(samples_, [time](const TimedPose& sample) { return sample.time < time; });
}

std::optional<Pose> PoseHistory::at(Timestamp time, double max_gap_s) const {
    if (samples_.empty()) return Pose{};
    const auto after = std::lower_bound(samples_.begin(), samples_.end(), time,
                                        [](const TimedPose& sample, Timestamp t) { return sample.time < t; });
    const auto near_enough = [&](const TimedPose& s) { return std::abs(secondsBetween(s.time, time)) <= max_gap_s; };
    if (after == samples_.end() || after == samples_.begin()) {
        const TimedPose& nearest = after == samples_.end() ? samples_.back() : samples_.front();
        return near_enough(nearest) ? std::optional(nearest.pose) : std::nullopt;
    }
    const TimedPose& a = *(after - 1);
    const TimedPose& b = *after;
    if (!near_enough(a) && !near_enough(b)) return std::nullopt;
    if (!near_enough(a)) return b.pose;
    if (!near_enough(b)) return a.pose;
    const double u = secondsBetween(a.time, time) / secondsBetween(a.time, b.time);
    return Pose{a.pose.north_m + u * (b.pose.north_m - a.pose.north_m),
                a.pose.east_m + u * (b.pose.east_m - a.pose.east_m),
                a.pose.heading + u * (b.pose.heading - a.pose.heading)};
}

}  // namespace echotrail
