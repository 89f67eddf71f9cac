#include "core/base/random.hpp"
#include "core/tracking/gate.hpp"
#include "core/tracking/tracker.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

// What one pass of the beam does to the tracks it went over.
namespace echotrail {
namespace {

constexpr double clutter_score_memory = 0.9;
constexpr double looked_at_coverage = 0.5;  // the expected place itself was passed over
constexpr MultipathRule copy{.farthest_m = 4.0, .weaker_db = 3.0};
constexpr double arc_widths = 2.5, arc_elongation = 2.5;
constexpr double side_lobe_widths = 1.5;     // of the beam, beside the object: nearer is the main lobe
constexpr double vaguest_side_lobe_m = 1.0;  // where the object is known less well, no more is put down to it
constexpr double sure_association = 0.9, least_likeness_to_learn = 0.1;
constexpr double real_claim = 0.2;    // of the strongest claim to a region: less is no competition
constexpr double one_place = 9.0;     // squared normalised distance
constexpr double merged_share = 0.3;  // of what is beyond the expected extent: how well the whole places one of them

bool areOnePlace(const Cue& a, const Cue& b) {
    const Eigen::Vector2d apart = a.position_m - b.position_m;
    return apart.dot((a.covariance_m2 + b.covariance_m2).inverse() * apart) <= one_place;
}

/// Track m has region k with this probability, and no other.
void giveTo(Association& joint, std::size_t m, std::size_t k, double probability) {
    joint.probability[m].assign(joint.probability[m].size(), 0.0);
    joint.probability[m][k] = probability;
    joint.none[m] = 1.0 - probability;
}

}  // namespace

/// Covariance of a region's centroid in the local frame, along the line of sight and across it. The centroid is known
/// to a share of the region's own extent, which holds what the beam, the pulse and the object spread it over. What a
/// region has beyond `expected` may be another echo that has run into the object's, and the centroid is then between
/// the two.
Eigen::Matrix2d Tracker::measurementCovariance(const Region& region, const RegionFeatures& expected) const {
    const Eigen::Vector2d sight = region.position_m - Eigen::Vector2d(region.head.north_m, region.head.east_m);
    const double range = std::max(sight.norm(), 0.1);
    const Eigen::Vector2d along = sight / range, across(-along.y(), along.x());
    const auto sigma = [&](double instrument_m, double extent_m, double expected_m) {
        return std::hypot(instrument_m, params_.tracking.centroid_share * extent_m,
                          merged_share * std::max(extent_m - expected_m, 0.0));
    };
    const double heading = radiansFromDegrees(params_.tracking.heading_sigma_deg);
    const double along_sigma =
        sigma(params_.tracking.range_sigma_m, region.features.along_range_m, expected.along_range_m);
    const double across_sigma = sigma(std::hypot(params_.tracking.range_sigma_m, range * heading),
                                      region.features.across_range_m, expected.across_range_m);
    return along_sigma * along_sigma * along * along.transpose() +
           across_sigma * across_sigma * across * across.transpose();
}

EchoGeometry Tracker::geometryAt(double range_m) const {
    return {range_m, std::hypot(beam_.beam_width_rad, beam_.step_rad / 2.0), beam_.point_length_m};
}

Tracker::Pairing Tracker::pair(const FollowedTrack& followed, const Region& region) const {
    Pairing pairing;
    if (region.time <= followed.track.estimate.time) return pairing;
    if (params_.method.likelihood == LikelihoodForm::Lookup) return pairAsPublished(followed, region);
    if (region.clutter_mass) return pairing;
    const GaussianState prior = predict(followed, region.time);
    const Eigen::Vector2d innovation = region.position_m - prior.mean.head<2>();
    const double since_seen = secondsBetween(followed.track.last_seen, region.time);
    const Eigen::Matrix2d spread = prior.covariance.topLeftCorner<2, 2>();
    const double reach = params_.tracking.max_speed_mps * since_seen + gate_sigmas * std::sqrt(spread.trace());
    if (innovation.squaredNorm() > reach * reach) return pairing;
    const RegionFeatures expected = expectedFeatures(followed, region.range_m);
    pairing.cue.covariance_m2 = measurementCovariance(region, expected);
    const Eigen::Matrix2d total = spread + pairing.cue.covariance_m2;
    pairing.nis = innovation.dot(total.inverse() * innovation);
    pairing.gated = pairing.nis <= params_.tracking.gate;
    if (!pairing.gated) return pairing;
    pairing.innovation_m = innovation.norm();
    pairing.density = std::exp(-0.5 * pairing.nis) / (2.0 * std::numbers::pi * std::sqrt(total.determinant()));
    pairing.cue.position_m = region.position_m;
    pairing.likeness = likeness(region.features, expected, params_.likeness);
    pairing.likeness *= levelLikeness(region.features.level_db, expected.level_db, params_.likeness);
    pairing.strength_ratio = strengthRatio(region.contrast_db, expected.strength_db, beam_.faintest_db,
                                           clutter_excess_db_, params_.likeness);
    return pairing;
}

RegionFeatures Tracker::expectedFeatures(const FollowedTrack& followed, double range_m) const {
    return params_.likeness.reference == ReferenceForm::Scaled ? followed.reference.expected(geometryAt(range_m))
                                                               : followed.first_features;
}

/// Whether something else explains this region: it then starts no track, and counts little as a track's echo. The flag
/// it got when it was found is not enough: the stronger one may be completed later.
bool Tracker::isGhost(const Region& region) const {
    return (params_.tracking.ghost_density > 0.0 && recent_.explain(region, copy)) || isSideLobe(region);
}

/// What is very strong is also heard while the beam looks elsewhere, at the same range. The beam may come by the thing
/// itself only later in the sweep; but if it is followed, where it is expected is known.
bool Tracker::isSideLobe(const Region& region) const {
    const RegionFeatures& seen = region.features;
    return std::any_of(followed_.begin(), followed_.end(), [&](const FollowedTrack& followed) {
        const RegionFeatures& strong = followed.track.expected_features;
        if (followed.track.state == TrackState::Lost || strong.level_db - seen.level_db < params_.tracking.side_lobe_db)
            return false;
        const ExpectedPlace place = expectedPlace(predict(followed, region.time), region.head);
        const double aside = std::abs((region.bearing + region.head.heading.inRadians()) - place.azimuth);
        const double reach_m =
            (strong.along_range_m + seen.along_range_m) / 2.0 + std::min(place.along_sigma_m, vaguest_side_lobe_m);
        return std::abs(region.range_m - place.range_m) < reach_m && aside > side_lobe_widths * beam_.beam_width_rad;
    });
}

/// Whether the region is a thin arc about the head: what side lobes make of something strong that may lie outside the
/// sector. A track that is proven may well look so where it has run into something else.
bool Tracker::isArc(const Region& region) const {
    const RegionFeatures& seen = region.features;
    return seen.across_range_m > arc_widths * beam_.beam_width_rad * region.range_m &&
           seen.across_range_m > arc_elongation * seen.along_range_m;
}

double Tracker::worth(const Pairing& pairing, bool ghost) const {
    // What else the region may be: clutter, or where a stronger one lies before it, that one's copy. Copies are as
    // strong as targets, so their strength says nothing.
    const double others = clutterDensity() + (ghost ? params_.tracking.ghost_density : 0.0);
    if (params_.method.likelihood == LikelihoodForm::Position) return params_.tracking.detection_probability / others;
    // An echo that is there was detected, however little of the place the beam covered.
    const double floor = params_.likeness.likeness_floor;
    return params_.tracking.detection_probability / others * (pairing.likeness + floor) / (clutter_score_ + floor) *
           (ghost ? 1.0 : pairing.strength_ratio);
}

/// Joint association of the cluster, then each track's own update (method card, sections f and g).
void Tracker::processCluster(const std::vector<std::size_t>& members, const std::vector<std::size_t>& regions,
                             std::vector<TrackLook>& looks) {
    if (params_.method.likelihood == LikelihoodForm::Lookup) {
        for (const std::size_t m : members) processAsPublished(followed_[m], regions, looks);
        return;
    }
    std::vector<std::vector<Pairing>> pairings(members.size());
    AssociationProblem problem;
    for (std::size_t m = 0; m < members.size(); ++m) {
        const FollowedTrack& followed = followed_[members[m]];
        const double existence = followed.track.existence;  // an unproven track has less of a claim (JIPDA)
        const double detection = params_.tracking.detection_probability * followed.pass.coverage();
        auto& weights = problem.weight.emplace_back();
        for (const std::size_t j : regions) {
            Pairing pairing = pair(followed, pending_[j].region);
            const bool unproven = followed.track.state == TrackState::Tentative && !followed.track.target;
            const Region& region = pending_[j].region;
            pairing.cue.weight = worth(pairing, isGhost(region) || (unproven && isArc(region)));
            weights.push_back(pairing.gated ? existence * pairing.cue.weight * pairing.density : 0.0);
            pairings[m].push_back(pairing);
        }
        problem.miss.push_back(1.0 - existence * detection);
    }
    const Association alone = associateAlone(problem);
    Association joint = params_.method.sharing == Sharing::Joint ? associate(problem) : alone;
    if (params_.method.sharing == Sharing::Joint) {
        settleTies(members, joint);
        keepOwn(members, regions, pairings, joint);
        shareMerged(members, regions, alone, pairings, joint);
    }
    for (std::size_t k = 0; k < regions.size(); ++k) {
        double claimed = 0, claimed_by_known = 0;
        for (std::size_t m = 0; m < members.size(); ++m) {
            claimed += joint.probability[m][k];
            if (followed_[members[m]].track.state != TrackState::Tentative) claimed_by_known += joint.probability[m][k];
        }
        pending_[regions[k]].claimed = claimed > 0.5;
        // What only an unproven track lays claim to is clutter until it is proven.
        if (claimed_by_known > 0.5) continue;
        if (claimed > 0.5) learnClutter(pending_[regions[k]].region);
        for (std::size_t m = 0; m < members.size(); ++m)
            if (pairings[m][k].gated)
                clutter_score_ += (1.0 - clutter_score_memory) * (pairings[m][k].likeness - clutter_score_);
    }
    for (std::size_t m = 0; m < members.size(); ++m)
        completePass(followed_[members[m]], regions, pairings[m], joint.probability[m], joint.none[m],
                     alone.probability[m], alone.none[m], looks);
}

/// Where several tracks claim one region and none prevails, it is the senior's: the operator's target, then a proven
/// track, then the older. Otherwise two tracks on one object would starve each other; so the younger one goes. Each
/// track has one region at most: what it leaves is the next one's.
void Tracker::settleTies(const std::vector<std::size_t>& members, Association& joint) const {
    const std::size_t regions = joint.probability.empty() ? 0 : joint.probability.front().size();
    std::vector<double> claimed(regions, 0.0), highest(regions, 0.0);
    for (const auto& claims : joint.probability)
        for (std::size_t k = 0; k < regions; ++k) {
            claimed[k] += claims[k];
            highest[k] = std::max(highest[k], claims[k]);
        }
    std::vector<std::optional<std::size_t>> owner(regions);
    for (const std::size_t m : bySeniority(members)) {
        std::optional<std::size_t> best;
        for (std::size_t k = 0; k < regions; ++k) {
            const double claim = joint.probability[m][k];
            if (owner[k] || claimed[k] < 0.5 || claim < real_claim * highest[k]) continue;
            if (!best || claim > joint.probability[m][*best]) best = k;
        }
        if (best) owner[*best] = m;
    }
    for (std::size_t m = 0; m < members.size(); ++m)
        for (std::size_t k = 0; k < regions; ++k)
            if (owner[k] && *owner[k] != m) joint.none[m] += std::exchange(joint.probability[m][k], 0.0);
    for (std::size_t k = 0; k < regions; ++k) {
        if (!owner[k]) continue;
        double& claim = joint.probability[*owner[k]][k];
        const double gained = std::min(claimed[k] - claim, joint.none[*owner[k]]);
        claim += gained;
        joint.none[*owner[k]] -= gained;
    }
}

/// Places in `members`, the senior first.
std::vector<std::size_t> Tracker::bySeniority(const std::vector<std::size_t>& members) const {
    const auto rank = [&](std::size_t m) {
        const Track& track = followed_[members[m]].track;
        return std::tuple(!track.target, track.state == TrackState::Tentative || track.state == TrackState::Lost,
                          track.id);
    };
    std::vector<std::size_t> order(members.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
    return order;
}

bool Tracker::isProvenWithoutEcho(std::size_t member, double none) const {
    const Track& track = followed_[member].track;
    return (track.state != TrackState::Tentative || track.target) && none >= 0.5;  // the operator vouches for a target
}

/// What passes behind something stronger looks like that one's copy; a proven track knows it by its place and its
/// looks, where the stronger echo is another's.
void Tracker::keepOwn(const std::vector<std::size_t>& members, const std::vector<std::size_t>& regions,
                      const std::vector<std::vector<Pairing>>& pairings, Association& joint) const {
    for (std::size_t m = 0; m < members.size(); ++m) {
        if (!isProvenWithoutEcho(members[m], joint.none[m])) continue;
        for (std::size_t k = 0; k < regions.size(); ++k) {
            const Pairing& pairing = pairings[m][k];
            double others = -joint.probability[m][k];
            for (const auto& claims : joint.probability) others += claims[k];
            const bool alike =
                pairing.gated && pairing.nis < one_place && pairing.likeness > params_.likeness.learning_score;
            if (!alike || others > 0.5 || !isGhost(pending_[regions[k]].region)) continue;
            giveTo(joint, m, k, sure_association);
            break;
        }
    }
}

/// Echoes that have run into each other are one region, and the joint association gives it to one track alone. Another
/// proven track that is expected about there, and smaller than it, has its echo in there, too.
void Tracker::shareMerged(const std::vector<std::size_t>& members, const std::vector<std::size_t>& regions,
                          const Association& alone, const std::vector<std::vector<Pairing>>& pairings,
                          Association& joint) const {
    for (std::size_t m = 0; m < members.size(); ++m) {
        const FollowedTrack& followed = followed_[members[m]];
        if (!isProvenWithoutEcho(members[m], joint.none[m])) continue;
        for (std::size_t k = 0; k < regions.size(); ++k) {
            const Region& region = pending_[regions[k]].region;
            if (!pairings[m][k].gated || alone.probability[m][k] < 0.5) continue;
            if (region.features.area_m2 < merged_area * expectedFeatures(followed, region.range_m).area_m2) continue;
            if (pairings[m][k].nis > one_place) continue;
            giveTo(joint, m, k, alone.probability[m][k]);
        }
    }
}

/// One Gaussian-particle-filter update with the regions of the pass, each weighed down by how much of it the other
/// tracks of the cluster claim.
void Tracker::completePass(FollowedTrack& followed, const std::vector<std::size_t>& regions,
                           const std::vector<Pairing>& pairings, const std::vector<double>& joint, double joint_none,
                           const std::vector<double>& alone, double alone_none, std::vector<TrackLook>& looks) {
    const double coverage = followed.pass.coverage();
    const double detection = params_.tracking.detection_probability * coverage;
    const auto share = [](double together, double single) { return single > 0 ? together / single : 0.0; };
    std::size_t best = 0;
    double echo_probability = 0;
    for (std::size_t k = 0; k < regions.size(); ++k) {
        echo_probability += joint[k];
        if (joint[k] > joint[best]) best = k;
    }
    const bool echo = echo_probability > 0.5;
    std::vector<Cue> cues;
    for (std::size_t k = 0; k < regions.size(); ++k) {
        if (!pairings[k].gated) continue;
        Cue cue = pairings[k].cue;
        // One Gaussian cannot stand for two places: its mean would lie where nothing is. The likelier place is taken.
        if (echo && params_.method.likelihood == LikelihoodForm::Soft && !areOnePlace(cue, pairings[best].cue))
            continue;
        cue.weight *= share(joint[k], alone[k]);
        if (cue.weight > 0) cues.push_back(cue);
    }
    const Timestamp time = echo ? pending_[regions[best]].region.time
                                : std::max(followed.pass.nearestTime(), followed.track.estimate.time);
    const GaussianState prior = predict(followed, time);
    GaussianParticleFilter::Posterior posterior{prior, 1.0 - detection, 0.0, true};
    const double miss_weight = (1.0 - detection) * share(joint_none, alone_none);
    if (!cues.empty())
        posterior =
            params_.method.likelihood == LikelihoodForm::Position
                ? updateByPlace(prior, miss_weight, cues)
                : filter_.update(prior, miss_weight, cues, RandomStream(seed_, followed.track.id, followed.updates++),
                                 &followed.track.particles);
    const Region* region = echo && !posterior.missed ? &pending_[regions[best]].region : nullptr;
    Pairing taken = region ? pairings[best] : Pairing{};
    if (region) taken.probability = joint[best];
    const NoEcho cause = region ? NoEcho::None : whyNoEcho(followed, time, regions, pairings);
    concludePass(followed, posterior, time, region, taken, !cues.empty(), cause, looks);
}

void Tracker::concludePass(FollowedTrack& followed, const GaussianParticleFilter::Posterior& posterior, Timestamp time,
                           const Region* region, const Pairing& pairing, bool had_cues, NoEcho cause,
                           std::vector<TrackLook>& looks) {
    const bool seen = region != nullptr;
    const double coverage = followed.pass.coverage();
    const LookResult result = seen                             ? LookResult::Seen
                              : coverage >= looked_at_coverage ? LookResult::Missed
                                                               : LookResult::NotLookedAt;
    // A place that was not looked at keeps its old estimate: it is predicted from there the next time, too.
    if (!posterior.missed || result == LookResult::Missed) followed.track.estimate = posterior.state;
    if (!had_cues && result == LookResult::Missed) followed.track.particles = {};
    if (seen) takeEcho(followed, *region, pairing);
    const bool was_lost = followed.track.state == TrackState::Lost;
    const bool was_confirmed = followed.track.state != TrackState::Tentative;
    advanceLife(followed.track, result, posterior.evidence, time, params_.life);
    if (was_lost) searchAgain(followed, result, time);
    if (!was_confirmed && followed.track.state == TrackState::Confirmed) ++confirmed_ever_;
    if (result == LookResult::Missed) widenSearch(followed.track, params_.life);

    const bool still_lost = was_lost && followed.track.state == TrackState::Lost;
    if (result != LookResult::NotLookedAt && !still_lost) {
        const Pose& head = seen ? region->head : followed.pass.nearestHead();
        looks.push_back(lookOf(followed, time, cause, head));
        remember(looks.back(), followed.track);
    }
    if (result != LookResult::NotLookedAt) followed.navigation_gap = followed.pings_missing = false;
    followed.pass.restart();
}

void Tracker::takeEcho(FollowedTrack& followed, const Region& region, const Pairing& pairing) {
    Track& track = followed.track;
    const EchoGeometry geometry = geometryAt(region.range_m);
    followed.quiet_sweeps = 0;
    followed.unwatched_s = 0.0;
    track.score = pairing.likeness;
    track.nis = pairing.nis;
    track.innovation_m = pairing.innovation_m;
    track.seen_features = region.features;
    // The first look is no better than those that follow: it may have been half a look, or another thing's.
    const bool sure = pairing.probability > sure_association &&
                      (track.score > least_likeness_to_learn || !followed.reference.settled());
    const bool alike = track.score > params_.likeness.learning_score || sure;
    const bool trusted = alike && region.clipped_fraction < 0.2 &&
                         track.particles.effective > 0.2 * static_cast<double>(track.particles.weight.size());
    if (trusted) followed.reference.learn(region.features, geometry, params_.likeness.reference_learning);
    track.expected_features = expectedFeatures(followed, region.range_m);
}

/// A lost track comes back when two looks running are much like it, or when it is proven anew.
void Tracker::searchAgain(FollowedTrack& followed, LookResult result, Timestamp time) {
    if (result == LookResult::NotLookedAt) return;
    const bool alike = result == LookResult::Seen && followed.track.score > params_.life.reacquire_score;
    followed.good_looks = alike ? followed.good_looks + 1 : 0;
    const bool proven = result == LookResult::Seen && followed.track.existence > params_.life.confirm_existence;
    if (followed.good_looks < 2 && !proven) return;
    followed.good_looks = 0;
    reacquire(followed.track, time);
}

}  // namespace echotrail
