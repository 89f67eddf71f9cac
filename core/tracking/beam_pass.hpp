#pragma once

#include "core/data/pose.hpp"
#include "core/data/track.hpp"

#include <optional>

namespace echotrail {

/// The part of the operator's sector that is scanned, from north.
struct WatchedSector {
    Bearing centre;
    double half_width_rad = 0.0;
    double whole_width_rad = 0.0;  ///< of the operator's sector
    bool holds(Bearing azimuth) const;
};

/// One ping as tracking sees it: when, from where, and which way the beam looked.
struct BeamMoment {
    Timestamp time{};
    Pose head;                    ///< of the sonar head in the local frame; its heading is the bow's
    Bearing azimuth;              ///< of the beam, from north
    double step_rad = 0.0;        ///< between pings
    double beam_width_rad = 0.0;  ///< one way, between half-power points
    double near_m = 0.0;          ///< what is nearer is not looked at
    double far_m = 0.0;           ///< end of the echo line
    double range_scale_m = 0.0;
    double point_length_m = 0.0;    ///< length in range of a point's echo
    double faintest_db = 8.0;       ///< no region stands out less from the background
    bool turned_round = false;      ///< the beam's movement broke off before this ping: turned, flew back, or a gap
    bool sweep_ended = false;       ///< a sweep was finished before this ping
    bool navigation_known = false;  ///< poses are measured, not assumed
    bool navigation_gap = false;    ///< … but not at this ping
    bool pings_missing = false;     ///< there should have been some before this one
    /// Where the head follows the target: what is outside is not looked at, and its being unseen says nothing.
    std::optional<WatchedSector> watched;
};

/// Where a track's object is expected at one moment, seen from the head.
struct ExpectedPlace {
    Eigen::Vector2d position_m{0, 0};
    double range_m = 0.0;
    Bearing azimuth;  ///< from north
    double across_sigma_m = 0.0;
    double along_sigma_m = 0.0;
};

ExpectedPlace expectedPlace(const GaussianState& predicted, const Pose& head);

/// The beam's passage over the place where a track is expected. A mechanical scan looks there now and then; only
/// what it passed over counts as looked at.
/// Order: follow() once per ping. State: one pass; restart() begins the next.
class BeamPass {
public:
    /// Moves the pass on by one ping; `half_width_rad` is how far to each side the object may be.
    void follow(const BeamMoment& beam, const ExpectedPlace& place, double half_width_rad);
    /// The beam will not come further this time (it turned round, or the data ended).
    void breakOff() { ended_ = ended_ || inside_; }
    void restart() { *this = BeamPass(); }

    bool inside() const { return inside_ && !ended_; }
    bool ended() const { return ended_; }
    Timestamp start() const { return start_; }
    /// The ping whose beam came nearest to the expected place.
    Timestamp nearestTime() const { return nearest_time_; }
    const Pose& nearestHead() const { return nearest_head_; }
    /// Share of the expected place's probability that the beam passed over, 0…1.
    double coverage() const;

private:
    bool inside_ = false;
    bool ended_ = false;
    Timestamp start_{};
    Timestamp nearest_time_{};
    Pose nearest_head_;
    ExpectedPlace nearest_place_;  ///< as expected when the beam was nearest
    BeamMoment nearest_beam_;
    double nearest_turn_ = 0.0;  ///< of the beam from the expected place then, radians
    Bearing first_azimuth_;
    double lowest_turn_ = 0.0;  ///< of the beam from first_azimuth_
    double highest_turn_ = 0.0;
};

}  // namespace echotrail
