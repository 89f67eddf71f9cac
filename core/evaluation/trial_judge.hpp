#pragma once

#include "core/evaluation/trial.hpp"

#include <map>
#include <span>
#include <utility>
#include <vector>

namespace echotrail {

/// Range from the head and bearing from the bow of a target's true place. `told` is where navigation says the vehicle
/// is; it is needed only where the truth gives places and no sights.
std::pair<double, Bearing> sightOf(const Truth::Sample& target, const Pose& told);

/// A target's true place in the frame of `told`, the vehicle's pose as navigation tells it: so an error of navigation,
/// which shifts target and vehicle alike, is not taken for an error of tracking.
Eigen::Vector2d placeOf(const Truth::Sample& target, const Pose& told);

/// Holds a run against the truth. What the beam was on, which regions grew and which looks came of it is gathered ping
/// by ping, and compared in the end: looks are told late.
/// Order: take() for every ping; endSweep() after the ping that ended one; takeLast(), then conclude(), once.
class TrialJudge {
public:
    TrialJudge(const Truth& truth, const Scenario* scenario, std::uint64_t seed, const SourceInfo& source);

    void take(const Ping& ping, const Update& update);
    void endSweep(const Update& update, const std::vector<Track>& tracks);
    void takeLast(const Update& update) { gather(update); }
    void conclude(TrialResult& result);

private:
    /// The beam's nearest approach to the followed target in a sweep.
    struct Opportunity {
        Timestamp time{};
        double off_rad = 10.0;  ///< of the beam from the target
        double step_rad = 0.0;
        bool visible = false;
        bool pings_missing = false;
        bool navigation_gap = false;
        double range_m = 0.0;
        Bearing bearing;
    };
    /// A region and whose echo it truly is.
    struct Labelled {
        Timestamp time{};
        Eigen::Vector2d position_m{0, 0};
        int target = -1;            ///< number of the target; -1: of none
        bool on_object = false;     ///< debris
        bool holds_target = false;  ///< the followed target's place is inside it
        bool clutter_mass = false;
        double contrast_db = 0.0;
    };
    struct Follower {
        int on_target = 0, on_debris = 0, on_nothing = 0;  ///< looks of a confirmed track
    };

    void gather(const Update& update);
    void closeSweep();
    Labelled label(const Region& region) const;
    bool isDebris(const Region& region) const;
    bool isAtRock(const Region& region, const Pose& vehicle, double altitude_m) const;
    bool isAtDebris(const Eigen::Vector2d& place, const Update& update) const;
    std::span<const Labelled> regionsAbout(Timestamp time) const;
    Pose toldAt(Timestamp time) const;
    const Labelled* regionOf(const TrackLook& look) const;
    EvaluatedOutput output(const TrackLook& look) const;
    EvaluatedLook judgeOpportunity(const Opportunity& opportunity, std::span<const TrackLook> looks) const;
    LossCause causeOf(const Opportunity& opportunity, const EvaluatedLook& look, bool tentative) const;
    void countTracks(TrialResult& result) const;

    const Truth& truth_;
    const Scenario* scenario_;
    std::uint64_t seed_;
    double rock_above_ = 0.0;  ///< of the smooth noise
    SourceInfo source_;
    std::vector<Debris> debris_;
    Opportunity now_;  ///< of the sweep under way
    std::vector<Opportunity> opportunities_;
    std::vector<Labelled> regions_;
    std::vector<TrackLook> looks_;
    std::vector<TimedPose> told_;
    std::vector<SweepSnapshot> snapshots_;
    Timestamp last_ping_{};
    double interval_s_ = 0.0;  ///< between pings, as it usually is
    int outside_ = 0;
};

}  // namespace echotrail
