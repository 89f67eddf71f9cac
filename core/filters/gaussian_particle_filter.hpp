#pragma once

#include "core/base/parameters.hpp"
#include "core/base/random.hpp"
#include "core/data/track.hpp"
#include "core/filters/particle_kernels.hpp"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace echotrail {

/// One gated region as the filter sees it: its term in the likelihood of a position x is weight · N(position; x, R).
struct Cue {
    Eigen::Vector2d position_m{0, 0};                             ///< north, east
    Eigen::Matrix2d covariance_m2 = Eigen::Matrix2d::Identity();  ///< R
    double weight = 1.0;                                          ///< m²; terms compare with `miss_weight`
};

struct GaussianParticleFilterParams {
    int particles = 2000;
    double prior_share = 0.3;
    double proposal_noise_factor = 2.0;
    double proposal_inflation = 1.2;
    double draw_again_below = 0.1;
    double unusable_below = 0.02;
    double position_floor_m = 0.05;
    double velocity_floor_mps = 0.02;
};

template <>
struct Described<GaussianParticleFilterParams> {
    using P = GaussianParticleFilterParams;
    static constexpr std::string_view group = "Particle filter";
    static constexpr auto fields = std::tuple{
        Field{&P::particles, "particles", "", 200, 20000, "Particles per update of a track"},
        Field{&P::prior_share, "prior_share", "", 0.1, 1, "Share of the particles drawn from the prediction alone"},
        Field{&P::proposal_noise_factor, "proposal_noise_factor", "", 1, 10,
              "Factor on an echo's covariance when particles are drawn around it"},
        Field{&P::proposal_inflation, "proposal_inflation", "", 1, 4,
              "Factor on the covariance the particles around an echo are drawn with"},
        Field{&P::draw_again_below, "draw_again_below", "", 0, 1,
              "Effective share of the particles below which they are drawn once more, doubled in number"},
        Field{&P::unusable_below, "unusable_below", "", 0, 1,
              "Effective share of the particles below which the look counts as a miss"},
        Field{&P::position_floor_m, "position_floor_m", "m", 0.001, 5, "Least deviation of a track's position"},
        Field{&P::velocity_floor_mps, "velocity_floor_mps", "m/s", 0.001, 5,
              "Least deviation of a track's velocity, its position given"}};
};

/// Measurement update of the Gaussian particle filter (Kotecha & Djurić, "Gaussian particle filtering", 2003): draw
/// from a proposal π, weigh by likelihood · prior / π, keep mean and covariance. No resampling.
///
/// The likelihood looks at positions only, so given the position the velocity is as the prior has it. Particles are
/// therefore positions; the velocity's moments follow from theirs in closed form (Rao–Blackwell), which costs less and
/// errs less than drawing velocities as well.
///
/// π is a share of the prior plus, for each cue, the Kalman update with that cue, of widened noise and itself widened.
/// Each component's draws come in pairs ± and are whitened to its exact mean and covariance.
///
/// State:   scratch memory only; nothing of one update shows in the next.
/// Threads: one at a time; the result depends on the arguments alone.
class GaussianParticleFilter {
public:
    using Params = GaussianParticleFilterParams;

    struct Posterior {
        GaussianState state;
        double evidence = 0.0;               ///< ∫ likelihood · prior: mean of likelihood · prior / π
        double effective_sample_size = 0.0;  ///< 1 / sum of squared normalised weights
        bool missed = false;  ///< numerically unusable: `state` is the prior with its floors; treat as a miss
    };

    explicit GaussianParticleFilter(const Params& params);

    /// Likelihood of a position x: `miss_weight` + Σ weight · N(position; x, R). Cues that are not finite, have no
    /// positive weight or a covariance that is not positive definite are left out; with none left the posterior is the
    /// prior, exactly. Deviations of the result are at least the floors.
    /// `cloud` may be null; otherwise it gets the particles of the update (none where none were drawn).
    Posterior update(const GaussianState& prior, double miss_weight, std::span<const Cue> cues, RandomStream stream,
                     ParticleCloud* cloud);

private:
    /// A Gaussian particles are drawn from, its mean in metres from the prior's.
    struct Component {
        Eigen::Vector2d mean_m;
        Eigen::Matrix2d covariance_m2;
        int pairs;                 ///< of particles
        std::size_t first_number;  ///< its place in the pool of random numbers
    };
    /// A cue that can be used, in metres from the prior's mean.
    struct Echo {
        GaussianTerm likelihood;
        double log_joint;  ///< log of weight · N(innovation; 0, S): its share of the evidence
        Eigen::Vector2d proposal_mean_m;
        Eigen::Matrix2d proposal_m2;
    };
    /// What one round of particles says.
    struct Round {
        double mean_weight = 0.0;  ///< evidence, relative to `log_evidence_`
        double effective = 0.0;
        Eigen::Vector2d mean_m{0, 0};
        Eigen::Matrix2d covariance_m2 = Eigen::Matrix2d::Identity();
    };

    void takeCues(const GaussianState& prior, double miss_weight, std::span<const Cue> cues);
    void propose();
    void draw(int pairs, RandomStream& stream);
    void weigh();
    Round drawAndWeigh(int pairs, RandomStream& stream);
    void copyParticles(const GaussianState& prior, const Round& round, ParticleCloud& cloud) const;
    Positions particles() const { return {north_, east_}; }

    Params params_;
    std::vector<Component> proposal_;
    std::vector<Echo> echoes_;
    Eigen::Matrix2d prior_m2_ = Eigen::Matrix2d::Identity();
    double log_miss_ = 0.0;
    double log_evidence_ = 0.0;  ///< of the linear Gaussian problem: the scale that brings weights near 1
    std::vector<float> pool_north_, pool_east_;  ///< Gaussian numbers, held twice over so that a run may wrap round
    std::vector<float> north_, east_;            ///< particles, metres from the prior's mean
    std::vector<float> log_reference_;           ///< log density of the component a particle was drawn from
    std::vector<float> log_prior_;               ///< of the reference over the prior, when cues are weighed
    std::vector<float> joint_, drawn_;           ///< likelihood · prior and proposal density, by the reference
    std::vector<float> weight_;
};

}  // namespace echotrail
