#include "core/evaluation/trial_judge.hpp"

#include "core/data/polygon.hpp"
#include "core/simulation/ground.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace echotrail {
namespace {

constexpr int followed_target = 0;
// A region is a target's echo when it holds the target's place, or its centroid lies this near it as seen from the
// head. Along the line of sight that is the target's own size and the pulse; across it, the beam.
constexpr double own_reach_m = 1.5;
constexpr double own_reach_rad = 0.052;  // 3 degrees: the one-way width of the low-frequency beam
constexpr double object_reach_m = 2.0;
constexpr double looked_at_steps = 0.75;  // the beam came this near to the target's bearing, in steps between pings
constexpr double longest_delay_s = 20.0;  // a look further than this from every opportunity belongs to none
constexpr Microseconds beam_passage{1'000'000};
constexpr double break_factor = 3.0;  // pings this many intervals apart: some are missing

bool isNear(double range_m, Bearing bearing, double true_range_m, Bearing true_bearing, double reach_m) {
    const double across = std::max(own_reach_rad * true_range_m, reach_m / 2.0);
    return std::abs(range_m - true_range_m) <= reach_m && std::abs(bearing - true_bearing) * true_range_m <= across;
}

}  // namespace

std::pair<double, Bearing> sightOf(const Truth::Sample& target, const Pose& told) {
    if (target.has_sight) return {target.range_m, target.from_bow};
    const Eigen::Vector2d way = target.position_m - Eigen::Vector2d(told.north_m, told.east_m);
    return {way.norm(), Bearing::radians(std::atan2(way.y(), way.x()) - told.heading.inRadians())};
}

Eigen::Vector2d placeOf(const Truth::Sample& target, const Pose& told) {
    if (!target.has_sight) return target.position_m;
    const double azimuth = target.from_bow.inRadians() + told.heading.inRadians();
    return Eigen::Vector2d(told.north_m, told.east_m) +
           target.range_m * Eigen::Vector2d(std::cos(azimuth), std::sin(azimuth));
}

TrialJudge::TrialJudge(const Truth& truth, const Scenario* scenario, std::uint64_t seed, const SourceInfo& source)
    : truth_(truth), scenario_(scenario), seed_(seed), source_(source) {
    if (!scenario) return;
    debris_ = allDebris(*scenario, seed);
    rock_above_ = gaussianAbove(scenario->rock_share);
}

void TrialJudge::take(const Ping& ping, const Update& update) {
    if (!told_.empty()) {
        const double interval = secondsBetween(last_ping_, ping.time);
        if (interval_s_ > 0 && interval > break_factor * interval_s_) now_.pings_missing = true;
        interval_s_ = interval_s_ > 0 ? 0.9 * interval_s_ + 0.1 * interval : interval;
    }
    last_ping_ = ping.time;
    told_.push_back({update.time, update.pose});
    if (update.sweep_ended) closeSweep();
    now_.navigation_gap |= update.navigation_gap;
    if (const auto target = truth_.at(followed_target, update.time)) {
        const auto [range, bearing] = sightOf(*target, update.pose);
        const double off = std::abs(update.beam - bearing);
        if (off < now_.off_rad) {
            now_.off_rad = off;
            now_.time = update.time;
            now_.step_rad = ping.step_rad;
            now_.range_m = range;
            now_.bearing = bearing;
            now_.visible = range <= ping.binSize() * static_cast<double>(ping.levels.size());
        }
    }
    gather(update);
}

void TrialJudge::gather(const Update& update) {
    for (const Region& region : update.regions) regions_.push_back(label(region));
    looks_.insert(looks_.end(), update.looks.begin(), update.looks.end());
}

void TrialJudge::closeSweep() {
    if (now_.visible && now_.off_rad <= looked_at_steps * now_.step_rad)
        opportunities_.push_back(now_);
    else
        ++outside_;
    now_ = {};
}

TrialJudge::Labelled TrialJudge::label(const Region& region) const {
    Labelled labelled{.time = region.time,
                      .position_m = region.position_m,
                      .clutter_mass = region.clutter_mass,
                      .contrast_db = region.contrast_db};
    for (int target = 0; target < truth_.targets(); ++target) {
        const auto sample = truth_.at(target, region.time);
        if (!sample) continue;
        const auto [range, bearing] = sightOf(*sample, region.head);
        const bool holds = isInside(placeOf(*sample, region.head).cast<float>(), region.outline_m);
        if (target == followed_target) labelled.holds_target = holds;
        const bool near = isNear(region.range_m, region.bearing, range, bearing, own_reach_m);
        if (near || (holds && !region.clutter_mass)) {
            labelled.target = target;
            break;
        }
    }
    labelled.on_object = labelled.target < 0 && isDebris(region);
    return labelled;
}

bool TrialJudge::isDebris(const Region& region) const {
    if (!scenario_) return false;
    const double time_s = secondsBetween(source_.start, region.time);
    const Pose vehicle = vehiclePose(*scenario_, time_s);
    if (scenario_->rock_share > 0.0 && isAtRock(region, vehicle, altitudeAt(*scenario_, time_s))) return true;
    const auto isAt = [&](double north_m, double east_m, double size_m) {
        const Eigen::Vector2d way(north_m - vehicle.north_m, east_m - vehicle.east_m);
        const Bearing bearing = Bearing::radians(std::atan2(way.y(), way.x()) - vehicle.heading.inRadians());
        return isNear(region.range_m, region.bearing, way.norm(), bearing, object_reach_m + size_m / 2.0);
    };
    if (std::any_of(debris_.begin(), debris_.end(),
                    [&](const Debris& object) { return isAt(object.north_m, object.east_m, object.size_m); }))
        return true;
    // The bubbles of a wake are no target, but they are there.
    for (const SimulatedTarget& target : scenario_->targets)
        for (double age_s = 1.0; age_s <= target.wake_s; age_s += 1.0) {
            const Eigen::Vector2d place = targetMotion(target, time_s - age_s).position_m;
            if (isAt(place.x(), place.y(), 0.0)) return true;
        }
    return false;
}

/// Rock stands where it is and is met again in every sweep: a thing, as debris is.
bool TrialJudge::isAtRock(const Region& region, const Pose& vehicle, double altitude_m) const {
    const double out_m = std::sqrt(std::max(region.range_m * region.range_m - altitude_m * altitude_m, 0.0));
    const double azimuth = vehicle.heading.inRadians() + region.bearing.inRadians();
    const double along_m = region.features.along_range_m / 2.0, across_m = region.features.across_range_m / 2.0;
    for (const double l : {-along_m, 0.0, along_m})
        for (const double a : {-across_m, 0.0, across_m}) {
            const double north = vehicle.north_m + (out_m + l) * std::cos(azimuth) - a * std::sin(azimuth);
            const double east = vehicle.east_m + (out_m + l) * std::sin(azimuth) + a * std::cos(azimuth);
            if (isRock(seed_, north, east, rock_above_)) return true;
        }
    return false;
}

/// The same of a place in the frame of navigation.
bool TrialJudge::isAtDebris(const Eigen::Vector2d& place, const Update& update) const {
    const Eigen::Vector2d way = place - Eigen::Vector2d(update.pose.north_m, update.pose.east_m);
    Region there;
    there.time = update.time;
    there.range_m = way.norm();
    there.bearing = Bearing::radians(std::atan2(way.y(), way.x()) - update.pose.heading.inRadians());
    return isDebris(there);
}

void TrialJudge::endSweep(const Update& update, const std::vector<Track>& tracks) {
    SweepSnapshot snapshot{.time = update.time};
    for (const Track& track : tracks) {
        if (track.state != TrackState::Confirmed && track.state != TrackState::Coasting) continue;
        const double dt = secondsBetween(track.estimate.time, update.time);
        const Eigen::Vector2d place = track.estimate.mean.head<2>() + dt * track.estimate.mean.tail<2>();
        snapshot.estimates.push_back({track.id, place, isAtDebris(place, update)});
    }
    for (int target = 0; target < truth_.targets(); ++target)
        if (const auto sample = truth_.at(target, update.time))
            snapshot.objects.push_back({target, placeOf(*sample, update.pose), sample->visible});
    snapshots_.push_back(std::move(snapshot));
}

Pose TrialJudge::toldAt(Timestamp time) const {
    const auto next = std::lower_bound(told_.begin(), told_.end(), time,
                                       [](const TimedPose& pose, Timestamp t) { return pose.time < t; });
    if (next == told_.begin()) return next->pose;
    if (next == told_.end()) return told_.back().pose;
    const TimedPose &a = *(next - 1), &b = *next;
    const double u = secondsBetween(a.time, time) / secondsBetween(a.time, b.time);
    return {a.pose.north_m + u * (b.pose.north_m - a.pose.north_m), a.pose.east_m + u * (b.pose.east_m - a.pose.east_m),
            a.pose.heading + u * (b.pose.heading - a.pose.heading)};
}

/// The region a look took its time from.
const TrialJudge::Labelled* TrialJudge::regionOf(const TrackLook& look) const {
    const auto first = std::lower_bound(regions_.begin(), regions_.end(), look.time,
                                        [](const Labelled& region, Timestamp t) { return region.time < t; });
    const Labelled* nearest = nullptr;
    for (auto region = first; region != regions_.end() && region->time == look.time; ++region)
        if (!nearest || (region->position_m - look.position_m).norm() < (nearest->position_m - look.position_m).norm())
            nearest = &*region;
    return nearest;
}

/// Those that the beam was on when it was about the target.
std::span<const TrialJudge::Labelled> TrialJudge::regionsAbout(Timestamp time) const {
    const auto earlier = [](const Labelled& region, Timestamp t) { return region.time < t; };
    const auto first = std::lower_bound(regions_.begin(), regions_.end(), time - beam_passage, earlier);
    const auto last = std::lower_bound(first, regions_.end(), time + beam_passage, earlier);
    return {first, last};
}

EvaluatedOutput TrialJudge::output(const TrackLook& look) const {
    EvaluatedOutput output{.time = look.time, .seen = look.seen, .covariance_m2 = look.covariance_m2};
    const auto target = truth_.at(followed_target, look.time);
    if (!target) return output;
    const Labelled* region = look.seen ? regionOf(look) : nullptr;
    output.correct = region && region->target == followed_target;
    output.estimate_m = look.position_m;
    output.truth_m = placeOf(*target, toldAt(look.time));
    if (target->has_sight) {
        // Seen from the head, where the estimate counts; then turned north with the covariance.
        const double heading = toldAt(look.time).heading.inRadians();
        const auto vector = [&](double range, Bearing bearing) {
            const double azimuth = bearing.inRadians() + heading;
            return Eigen::Vector2d(range * std::cos(azimuth), range * std::sin(azimuth));
        };
        output.error_m = vector(look.range_m, look.bearing) - vector(target->range_m, target->from_bow);
    } else {
        output.error_m = look.position_m - target->position_m;
    }
    output.velocity_error_mps = look.velocity_mps - target->velocity_mps;
    output.nees = output.error_m.dot(look.covariance_m2.inverse() * output.error_m);
    return output;
}

EvaluatedLook TrialJudge::judgeOpportunity(const Opportunity& opportunity, std::span<const TrackLook> looks) const {
    EvaluatedLook judged{
        .time = opportunity.time, .true_range_m = opportunity.range_m, .true_bearing = opportunity.bearing};
    bool tentative = false;
    for (const TrackLook& look : looks) {
        judged.track = look.track;
        judged.told = look.no_echo;
        tentative |= look.state == TrackState::Tentative;
        const bool alive = look.state == TrackState::Confirmed || look.state == TrackState::Coasting;
        if (!alive) continue;
        const Labelled* region = look.seen ? regionOf(look) : nullptr;
        const bool own = region && region->target == followed_target;
        const LookOutcome outcome = !look.seen ? LookOutcome::Coasted : own ? LookOutcome::Correct : LookOutcome::Wrong;
        // Of two looks in one sweep the better one counts.
        if (judged.outcome == LookOutcome::Absent || outcome == LookOutcome::Correct) judged.outcome = outcome;
    }
    for (const Labelled& region : regionsAbout(opportunity.time))
        if (region.target == followed_target) judged.target_db = std::max(judged.target_db, region.contrast_db);
    judged.cause = causeOf(opportunity, judged, tentative);
    return judged;
}

LossCause TrialJudge::causeOf(const Opportunity& opportunity, const EvaluatedLook& look, bool tentative) const {
    if (look.outcome == LookOutcome::Correct) return LossCause::None;
    if (opportunity.pings_missing) return LossCause::HeadRestarted;
    if (opportunity.navigation_gap) return LossCause::NavigationGap;
    if (tentative) return LossCause::NotYetConfirmed;
    bool own = false, mass = false;
    for (const Labelled& region : regionsAbout(opportunity.time)) {
        own |= region.target == followed_target && !region.clutter_mass;
        mass |= (region.target == followed_target && region.clutter_mass) || region.holds_target;
    }
    return own ? LossCause::OutscoredByClutter : mass ? LossCause::Merged : LossCause::UnderThreshold;
}

/// What each confirmed track was on, by the looks it took.
void TrialJudge::countTracks(TrialResult& result) const {
    std::map<int, Follower> followers;
    for (const TrackLook& look : looks_) {
        if (!look.seen || look.state != TrackState::Confirmed) continue;
        const Labelled* region = regionOf(look);
        Follower& follower = followers[look.track];
        if (region && region->target >= 0)
            ++follower.on_target;
        else if (region && region->on_object)
            ++follower.on_debris;
        else
            ++follower.on_nothing;
    }
    for (const auto& [track, follower] : followers) {
        const int total = follower.on_target + follower.on_debris + follower.on_nothing;
        if (2 * follower.on_nothing > total)
            ++result.false_tracks;
        else if (follower.on_debris > follower.on_target)
            ++result.debris_tracks;
    }
}

void TrialJudge::conclude(TrialResult& result) {
    const auto by_time = [](const auto& a, const auto& b) { return a.time < b.time; };
    std::stable_sort(regions_.begin(), regions_.end(), by_time);
    std::stable_sort(looks_.begin(), looks_.end(), by_time);
    std::vector<std::vector<TrackLook>> of(opportunities_.size());
    for (const TrackLook& look : looks_) {
        if (!look.target) continue;
        const bool alive = look.state == TrackState::Confirmed || look.state == TrackState::Coasting;
        if (alive && truth_.at(followed_target, look.time))  // the last echoes may be later than the last sample
            result.outputs.push_back(output(look));
        if (opportunities_.empty()) continue;
        const auto nearest = std::min_element(opportunities_.begin(), opportunities_.end(), [&](auto& a, auto& b) {
            return std::abs(secondsBetween(a.time, look.time)) < std::abs(secondsBetween(b.time, look.time));
        });
        if (std::abs(secondsBetween(nearest->time, look.time)) < longest_delay_s)
            of[static_cast<std::size_t>(nearest - opportunities_.begin())].push_back(look);
    }
    double contrast = 0;
    int contrasts = 0;
    for (std::size_t k = 0; k < opportunities_.size(); ++k) {
        result.looks.push_back(judgeOpportunity(opportunities_[k], of[k]));
        const EvaluatedLook& look = result.looks.back();
        if (look.target_db > 0) {
            contrast += look.target_db;
            ++contrasts;
        }
        if (look.outcome == LookOutcome::Correct && !result.confirmed_after_s)
            result.confirmed_after_s = secondsBetween(opportunities_.front().time, look.time);
    }
    result.mean_contrast_db = contrasts ? contrast / contrasts : 0.0;
    result.snapshots = std::move(snapshots_);
    result.sweeps_outside_sector = outside_;
    result.sweeps_unfinished = now_.off_rad < 10.0 ? 1 : 0;
    countTracks(result);
}

}  // namespace echotrail
