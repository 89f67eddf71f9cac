#pragma once

#include "core/base/random.hpp"
#include "core/data/track.hpp"
#include "core/filters/gaussian_particle_filter.hpp"

#include <span>
#include <vector>

namespace echotrail {

/// A region as the published likelihood sees it: an area with a score.
struct ScoredArea {
    std::span<const Eigen::Vector2f> outline_m;  ///< closed polygon, north and east
    double score = 0.0;
};

struct LookupUpdate {
    GaussianParticleFilter::Posterior posterior;
    std::vector<double> share;  ///< of the weight that each area holds
};

/// Measurement update as Zhang et al. describe it (method card, section f, form A): particles are drawn from the
/// prediction, each weighs as much as the score of the area it lies in, and nothing outside. Where all weigh nothing
/// the cue is lost: `missed`, and the state is the prior. Velocity, which the published state does not have, stays.
LookupUpdate lookupUpdate(const GaussianState& prior, std::span<const ScoredArea> areas, int particles, double floor_m,
                          RandomStream stream, ParticleCloud* cloud);

}  // namespace echotrail
