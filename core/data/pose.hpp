#pragma once

#include "core/base/angles.hpp"
#include "core/base/time.hpp"

#include <optional>
#include <vector>

namespace echotrail {

/// Where the vehicle was and which way it faced, in the local frame: origin where it was at the first ping,
/// north and east in metres. Without navigation it is the identity: the vehicle stands still and
/// north is the bow.
struct Pose {
    double north_m = 0.0;
    double east_m = 0.0;
    Bearing heading;  ///< from north
    bool operator==(const Pose&) const = default;
};

struct TimedPose {
    Timestamp time{};
    Pose pose;
};

/// Poses over time, with linear interpolation (the heading the short way round).
/// Order: samples in time order; an older or equal one is refused and counted.
/// State: empty means "no navigation", and every pose is then the identity.
class PoseHistory {
public:
    void add(const TimedPose& sample);
    /// What is older may go; it goes when it is half of what there is.
    void forgetBefore(Timestamp time);
    bool empty() const { return samples_.empty(); }
    std::size_t refused() const { return refused_; }

    /// The pose at `time`, interpolated between neighbours that both lie within `max_gap_s` of it; where only one does,
    /// or there is only one, that one holds; empty where none does (a navigation gap). So a sample later than
    /// `time + max_gap_s` changes nothing: who waits that long gets what the whole history would give.
    /// Identity when there is no navigation.
    std::optional<Pose> at(Timestamp time, double max_gap_s) const;

private:
    std::vector<TimedPose> samples_;
    std::size_t refused_ = 0;
};

}  // namespace echotrail
