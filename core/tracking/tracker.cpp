#include "core/tracking/tracker.hpp"

#include "core/filters/motion_model.hpp"
#include "core/tracking/gate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

// The flow of tracking: passes, births, sweeps. What one pass does to a track is in track_update.cpp.
namespace echotrail {
namespace {

constexpr double least_clutter_density = 2e-5;  // regions per m²
constexpr double clutter_memory = 0.8;          // share of the past in the learned density, per sweep
constexpr double least_excess_db = 2.0, strongest_clutter_db = 20.0;
constexpr double widest_interest = 0.1;    // of the range scale, to each side
constexpr double vaguest_tentative = 0.1;  // deviation of an unproven track, in range scales
constexpr int sweeps_to_merge = 3;

}  // namespace

Tracker::Tracker(const Params& params, std::uint64_t seed)
    : params_(params), seed_(seed), filter_(params.filter), clutter_per_sweep_(params.tracking.clutter_per_sweep) {}

void Tracker::setParams(const Params& params) {
    if (params.tracking.clutter_per_sweep != params_.tracking.clutter_per_sweep)
        clutter_per_sweep_ = params.tracking.clutter_per_sweep;
    params_ = params;
    filter_ = GaussianParticleFilter(params.filter);
}

void Tracker::update(const BeamMoment& beam, const std::vector<Region>& regions, const BeamStillOn& still_on,
                     std::vector<TrackLook>& looks) {
    recent_.add(regions);
    for (const Region& region : regions) pending_.push_back({region});
    if (beam.turned_round) {
        for (FollowedTrack& followed : followed_) followed.pass.breakOff();
        settle([](double, double) { return false; }, looks);  // what the beam is on now is another pass
    }
    if (beam.sweep_ended && !isPartOfSweep()) endSweep();
    const double passed_s = secondsBetween(beam_.time, beam.time);  // watched or not
    beam_ = beam;
    scanned_turn_rad_ += beam.step_rad;
    scanned_area_m2_ += beam.step_rad * beam.far_m * beam.far_m / 2.0;
    for (FollowedTrack& followed : followed_) {
        followed.navigation_gap |= beam.navigation_gap;
        followed.pings_missing |= beam.pings_missing;
        const ExpectedPlace place = expectedPlace(predict(followed, beam.time), beam.head);
        const double half_width = halfWidth(place);
        waitUnwatched(followed, place, passed_s);
        const bool elsewhere = beam.watched && !beam.watched->holds(place.azimuth) && !followed.track.target;
        const bool begun = followed.pass.inside() || followed.pass.ended();
        if (!elsewhere || begun) followed.pass.follow(beam, place, half_width);
        followed.expected_range_m = place.range_m;
        const double along = gate_sigmas * place.along_sigma_m + followed.track.expected_features.along_range_m;
        followed.track.region_of_interest = {
            beam.head.north_m,    beam.head.east_m, place.azimuth, half_width, std::max(place.range_m - along, 0.0),
            place.range_m + along};
    }
    settle(still_on, looks);
    giveUpUnseen(looks);
    std::erase_if(followed_, [&](const FollowedTrack& f) {
        const double spread = f.track.estimate.covariance.topLeftCorner<2, 2>().trace();
        const bool unproven =
            f.track.state == TrackState::Tentative && (f.quiet_sweeps > params_.life.tentative_misses ||
                                                       std::sqrt(spread) > vaguest_tentative * beam.range_scale_m);
        return unproven || isForgotten(f.track, beam.time, params_.life);
    });
    applyDesignation();
    hushDropped(looks);
}

/// A confirmed track that nothing was seen of for long is lost, also where the beam never came by.
void Tracker::giveUpUnseen(std::vector<TrackLook>& looks) {
    for (FollowedTrack& followed : followed_) {
        Track& track = followed.track;
        const bool alive = track.state == TrackState::Confirmed || track.state == TrackState::Coasting;
        const double unseen_s = secondsBetween(track.last_seen, beam_.time) - followed.unwatched_s;
        if (!alive || unseen_s <= params_.life.lost_after_s) continue;
        track.state = TrackState::Lost;
        track.estimate = predict(followed, beam_.time);
        widenSearch(track, params_.life);  // which also bounds it
        looks.push_back(lookOf(followed, beam_.time, whyNotScanned(followed), beam_.head));
        remember(looks.back(), track);
    }
}

/// Where the head follows the target, an object elsewhere cannot be seen, and so is none the worse for it. Nor does it
/// lay claim to what is seen about the target, however uncertain its own place grows.
void Tracker::waitUnwatched(FollowedTrack& followed, const ExpectedPlace& place, double passed_s) const {
    if (beam_.watched && !beam_.watched->holds(place.azimuth)) followed.unwatched_s += passed_s;
}

/// Whether what has been scanned is only a part of the operator's sector: sweeps are counted when there is as much of
/// them as of a whole one, so that what goes by sweeps goes no faster where the head follows the target.
bool Tracker::isPartOfSweep() const {
    return beam_.watched && scanned_turn_rad_ + beam_.step_rad / 2.0 < beam_.watched->whole_width_rad;
}

std::optional<TargetOutlook> Tracker::targetAt(Timestamp time) const {
    for (const FollowedTrack& followed : followed_) {
        const Track& track = followed.track;
        if (!track.target) continue;
        GaussianState expected = predict(followed, std::max(time, track.estimate.time));
        // While the beam passes over it, its echo is only awaited: that grows no less sure by its being told late.
        const bool awaited = followed.pass.inside() || followed.pass.ended();
        const Timestamp known = awaited ? followed.pass.start() : beam_.time;
        expected.covariance = predict(followed, std::max(known, track.estimate.time)).covariance;
        return TargetOutlook{track.state, track.misses, expected, track.expected_features.across_range_m};
    }
    return std::nullopt;
}

void Tracker::finish(const std::vector<Region>& regions, std::vector<TrackLook>& looks) {
    recent_.add(regions);
    for (const Region& region : regions) pending_.push_back({region});
    for (FollowedTrack& followed : followed_) followed.pass.breakOff();
    settle([](double, double) { return false; }, looks);
    hushDropped(looks);
}

GaussianState Tracker::predict(const FollowedTrack& followed, Timestamp time) const {
    const GaussianState& last = followed.track.estimate;
    GaussianState state = params_.method.motion == MotionForm::ConstantVelocity
                              ? predicted(last, time, params_.tracking.process_noise)
                              : wandered(last, time, params_.method.random_walk_sigma);
    if (params_.method.predicted_covariance == PredictedCovariance::AsPrinted)
        state.covariance = followed.first_covariance;
    if (!beam_.navigation_known) {
        // Nobody tells how the vehicle turns, so everything may swing about it: more the further off it is.
        const Eigen::Vector2d sight = state.mean.head<2>() - Eigen::Vector2d(beam_.head.north_m, beam_.head.east_m);
        const Eigen::Vector2d swing(-sight.y(), sight.x());
        const double turn = radiansFromDegrees(params_.tracking.unknown_turn_deg);
        const double dt = std::abs(secondsBetween(followed.track.estimate.time, time));
        state.covariance.topLeftCorner<2, 2>() += turn * turn * dt * swing * swing.transpose();
    }
    return state;
}

Eigen::Vector2d Tracker::placeNow(const FollowedTrack& followed) const {
    return predict(followed, std::max(beam_.time, followed.track.estimate.time)).mean.head<2>();
}

/// How far to each side of its expected bearing an object may appear, in radians.
double Tracker::halfWidth(const ExpectedPlace& place) const {
    const double across = gate_sigmas * place.across_sigma_m + params_.tracking.merge_tracks_m / 2.0;
    const double angle = std::atan2(across, std::max(place.range_m, 0.1));
    return std::min(angle + beam_.beam_width_rad + beam_.step_rad, radiansFromDegrees(100.0));
}

void Tracker::interestsAt(const BeamMoment& beam, std::vector<RangeOfInterest>& interests) const {
    interests.clear();
    for (const FollowedTrack& followed : followed_) {
        if (followed.track.state == TrackState::Tentative || followed.track.state == TrackState::Lost) continue;
        const PolarBox& box = followed.track.region_of_interest;
        if (std::abs(beam.azimuth - box.centre) > box.half_width_rad) continue;
        // A place known only roughly is no reason to look for faint echoes everywhere.
        const double middle = followed.expected_range_m;
        const double reach = std::min(box.far_m - middle, widest_interest * beam.range_scale_m);
        interests.push_back({middle - reach, middle + reach});
    }
}

bool Tracker::isReady(const FollowedTrack& followed, const BeamStillOn& still_on) const {
    const PolarBox& box = followed.track.region_of_interest;
    return followed.pass.ended() && !still_on(box.near_m, box.far_m);
}

/// Tracks that share regions with track `first`, and those regions. False where one of them is not ready yet.
bool Tracker::collectCluster(std::size_t first, const BeamStillOn& still_on, std::vector<std::size_t>& members,
                             std::vector<std::size_t>& regions) const {
    members.assign(1, first);
    regions.clear();
    std::vector<bool> has_region(pending_.size(), false), has_track(followed_.size(), false);
    has_track[first] = true;
    for (std::size_t m = 0; m < members.size(); ++m) {  // grows while it is walked
        if (!isReady(followed_[members[m]], still_on)) return false;
        for (std::size_t j = 0; j < pending_.size(); ++j) {
            if (has_region[j] || !pair(followed_[members[m]], pending_[j].region).gated) continue;
            has_region[j] = true;
            regions.push_back(j);
            for (std::size_t t = 0; t < followed_.size(); ++t) {
                const BeamPass& pass = followed_[t].pass;
                if (has_track[t] || !(pass.inside() || pass.ended())) continue;
                if (!pair(followed_[t], pending_[j].region).gated) continue;
                has_track[t] = true;
                members.push_back(t);
            }
        }
    }
    std::sort(members.begin(), members.end());
    std::sort(regions.begin(), regions.end());
    return true;
}

/// Completes every pass that is over, with all that share its regions; what nobody claims may start a track.
void Tracker::settle(const BeamStillOn& still_on, std::vector<TrackLook>& looks) {
    std::vector<std::size_t> members, regions;
    for (std::size_t t = 0; t < followed_.size(); ++t)
        if (followed_[t].pass.ended() && collectCluster(t, still_on, members, regions))
            processCluster(members, regions, looks);
    decideBirths(looks);
}

void Tracker::decideBirths(std::vector<TrackLook>& looks) {
    std::vector<Region> unclaimed;
    std::erase_if(pending_, [&](const PendingRegion& pending) {
        if (pending.claimed) return true;
        const bool awaited = std::any_of(followed_.begin(), followed_.end(), [&](const FollowedTrack& followed) {
            return (followed.pass.inside() || followed.pass.ended()) && pair(followed, pending.region).gated;
        });
        if (!awaited) unclaimed.push_back(pending.region);
        return !awaited;
    });
    for (const Region& region : unclaimed) {
        learnClutter(region);
        if (mayBeBorn(region)) bear(region, looks);
    }
}

/// Takes in a region that is nobody's echo.
void Tracker::learnClutter(const Region& region) {
    if (region.clutter_mass) return;
    ++unclaimed_;
    const double excess = std::clamp(region.contrast_db - beam_.faintest_db, 0.0, strongest_clutter_db);
    clutter_excess_db_ = std::max(0.95 * clutter_excess_db_ + 0.05 * excess, least_excess_db);
}

bool Tracker::mayBeBorn(const Region& region) const {
    if (region.clutter_mass || region.multipath || region.only_expected ||
        region.beam_hits < params_.tracking.min_beam_hits || isGhost(region))
        return false;
    const bool pointed_at =
        designation_ && (region.position_m - designation_->position_m).norm() < designation_->radius_m;
    if (!pointed_at && (params_.method.births == Births::Picked || isArc(region))) return false;
    return std::none_of(followed_.begin(), followed_.end(), [&](const FollowedTrack& followed) {
        const GaussianState state = predict(followed, region.time);
        return (state.mean.head<2>() - region.position_m).norm() < params_.tracking.merge_tracks_m / 2.0;
    });
}

void Tracker::bear(const Region& region, std::vector<TrackLook>& looks) {
    if (static_cast<int>(followed_.size()) >= params_.tracking.max_tracks) {
        // Make room: the least likely of those that were never confirmed gives way, the others stay.
        const auto weakest = std::min_element(followed_.begin(), followed_.end(), [](const auto& a, const auto& b) {
            const auto rank = [](const FollowedTrack& f) {
                return f.track.state == TrackState::Tentative && !f.track.target ? f.track.existence : 2.0;
            };
            return rank(a) < rank(b);
        });
        if (weakest->track.state != TrackState::Tentative || weakest->track.target ||
            weakest->track.existence > params_.life.birth_existence)
            return;
        followed_.erase(weakest);
    }
    FollowedTrack born{.reference = TargetReference(region.features, geometryAt(region.range_m)),
                       .first_features = region.features};
    Track& track = born.track;
    track.id = next_id_++;
    track.existence = params_.life.birth_existence;
    track.looks = 1;
    track.born = track.last_seen = track.estimate.time = region.time;
    track.estimate.mean.head<2>() = region.position_m;
    const double position = beam_.range_scale_m * params_.tracking.initial_position_sigma_percent / 100.0,
                 speed = params_.tracking.initial_speed_sigma_mps;
    track.estimate.covariance.setZero();
    track.estimate.covariance.diagonal() << position * position, position * position, speed * speed, speed * speed;
    track.estimate.covariance.topLeftCorner<2, 2>() += measurementCovariance(region, region.features);
    born.first_covariance = track.estimate.covariance;
    track.score = 1.0;
    track.seen_features = region.features;
    track.expected_features = expectedFeatures(born, region.range_m);
    followed_.push_back(std::move(born));
    applyDesignation();
    looks.push_back(lookOf(followed_.back(), region.time, NoEcho::None, region.head));
    remember(looks.back(), followed_.back().track);
}

void Tracker::endSweep() {
    for (FollowedTrack& followed : followed_) {
        followed.track.existence *= params_.life.survival_per_sweep;
        if (followed.unwatched_s == 0.0) ++followed.quiet_sweeps;
    }
    // The given value counts as one sweep; from then on a running mean, and a fading one in the end.
    const double memory = std::min(clutter_memory, 1.0 - 1.0 / (2.0 + sweeps_learned_++));
    clutter_per_sweep_ = memory * clutter_per_sweep_ + (1.0 - memory) * unclaimed_;
    swept_area_m2_ = scanned_area_m2_;
    scanned_area_m2_ = 0.0;
    scanned_turn_rad_ = 0.0;
    unclaimed_ = 0;
    mergeTracks();
}

double Tracker::clutterDensity() const {
    // The first sweep is taken to be a quarter circle, until it is known.
    const double area = swept_area_m2_ > 0 ? swept_area_m2_ : std::numbers::pi / 4.0 * beam_.far_m * beam_.far_m;
    return std::max(clutter_per_sweep_ / area, least_clutter_density);
}

/// Two tracks on one thing: after three sweeps the younger goes, unless it is the operator's.
void Tracker::mergeTracks() {
    const auto outranks = [](const Track& a, const Track& b) { return a.target != b.target ? a.target : a.id < b.id; };
    for (FollowedTrack& followed : followed_) {
        const Eigen::Vector2d place = predict(followed, beam_.time).mean.head<2>();
        const bool shadowed = std::any_of(followed_.begin(), followed_.end(), [&](const FollowedTrack& other) {
            return &other != &followed && other.track.state != TrackState::Lost &&
                   outranks(other.track, followed.track) &&
                   (predict(other, beam_.time).mean.head<2>() - place).norm() < params_.tracking.merge_tracks_m;
        });
        followed.shadowed_sweeps = shadowed ? followed.shadowed_sweeps + 1 : 0;
    }
    std::erase_if(followed_, [](const FollowedTrack& followed) { return followed.shadowed_sweeps >= sweeps_to_merge; });
}

Timestamp Tracker::settledUntil(Timestamp regions_until) const {
    Timestamp until = regions_until;
    for (const PendingRegion& pending : pending_) until = std::min(until, pending.region.time);
    for (const FollowedTrack& followed : followed_)
        if (followed.pass.inside() || followed.pass.ended()) until = std::min(until, followed.pass.start());
    return until;
}

std::vector<Track> Tracker::tracks() const {
    std::vector<Track> tracks;
    for (const FollowedTrack& followed : followed_)
        if (!followed.dropped) tracks.push_back(followed.track);
    return tracks;
}

}  // namespace echotrail
