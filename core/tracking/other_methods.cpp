#include "core/base/random.hpp"
#include "core/filters/covariance.hpp"
#include "core/filters/kalman.hpp"
#include "core/filters/lookup_filter.hpp"
#include "core/tracking/tracker.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

// The forms of a track's update that ours is measured against: the published one, and association by place alone.
namespace echotrail {
namespace {

constexpr double reach_sigmas = 3.0;  // particles lie no further from the prediction

}  // namespace

/// In the published form a region speaks where a particle lies in it, so every region in reach takes part.
Tracker::Pairing Tracker::pairAsPublished(const FollowedTrack& followed, const Region& region) const {
    Pairing pairing;
    const GaussianState prior = predict(followed, region.time);
    const Eigen::Vector2d innovation = region.position_m - prior.mean.head<2>();
    const Eigen::Matrix2d spread = prior.covariance.topLeftCorner<2, 2>();
    const double size = std::max(region.features.across_range_m, region.features.along_range_m);
    const double reach = reach_sigmas * std::sqrt(spread.trace()) + size / 2.0;
    pairing.gated = innovation.norm() <= reach;
    if (!pairing.gated) return pairing;
    pairing.innovation_m = innovation.norm();
    pairing.nis = innovation.dot((spread + measurementCovariance(region, region.features)).inverse() * innovation);
    pairing.likeness = likeness(region.features, expectedFeatures(followed, region.range_m), params_.likeness);
    return pairing;
}

/// The update of Zhang et al.: no clutter model, no other tracks, no existence; a cue that is lost widens the search.
void Tracker::processAsPublished(FollowedTrack& followed, const std::vector<std::size_t>& regions,
                                 std::vector<TrackLook>& looks) {
    std::vector<ScoredArea> areas;
    std::vector<std::size_t> numbers;
    std::vector<Pairing> pairings;
    for (const std::size_t j : regions) {
        const Region& region = pending_[j].region;
        const Pairing pairing = pairAsPublished(followed, region);
        if (!pairing.gated || region.time <= followed.track.estimate.time) continue;
        areas.push_back({region.outline_m, pairing.likeness});
        numbers.push_back(j);
        pairings.push_back(pairing);
    }
    const Timestamp nearest = std::max(followed.pass.nearestTime(), followed.track.estimate.time);
    const GaussianState prior = predict(followed, nearest);
    LookupUpdate update =
        lookupUpdate(prior, areas, params_.filter.particles, params_.filter.position_floor_m,
                     RandomStream(seed_, followed.track.id, followed.updates++), &followed.track.particles);
    const Region* region = nullptr;
    if (!update.posterior.missed) {
        const auto best = std::max_element(update.share.begin(), update.share.end()) - update.share.begin();
        region = &pending_[numbers[static_cast<std::size_t>(best)]].region;
        update.posterior.state.time = region->time;
    }
    const NoEcho cause = region ? NoEcho::None : whyNoEcho(followed, nearest, numbers, pairings);
    for (const std::size_t j : numbers) pending_[j].claimed = true;
    update.posterior.evidence = 1.0;  // the published method does not doubt that there is a target
    const Pairing pairing = region ? pairAsPublished(followed, *region) : Pairing{};
    concludePass(followed, update.posterior, region ? region->time : nearest, region, pairing, !areas.empty(), cause,
                 looks);
}

GaussianParticleFilter::Posterior Tracker::updateByPlace(const GaussianState& prior, double miss_weight,
                                                         const std::vector<Cue>& cues) const {
    std::vector<PositionCandidate> candidates;
    double evidence = miss_weight;
    for (const Cue& cue : cues) {
        const KalmanUpdate update = kalmanUpdate(prior, cue.position_m, cue.covariance_m2);
        const double density = std::exp(logGaussian(update.innovation_m, update.innovation_covariance_m2));
        candidates.push_back({cue.position_m, cue.covariance_m2, cue.weight * density});
        evidence += cue.weight * density;
    }
    for (PositionCandidate& candidate : candidates) candidate.probability /= evidence;
    const GaussianState state = associationUpdate(prior, miss_weight / evidence, candidates);
    return {state, evidence, static_cast<double>(params_.filter.particles), false};
}

}  // namespace echotrail
