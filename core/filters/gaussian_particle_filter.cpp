#include "core/filters/gaussian_particle_filter.hpp"

#include "core/filters/covariance.hpp"
#include "core/filters/kalman.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace echotrail {
namespace {

constexpr int fewest_pairs = 8;  // a component with fewer cannot be whitened well and is not worth a pass

/// A state as position and, given the position, velocity: v = velocity + gain · (p − position) + N(0, rest).
/// Built on floored parts, so that joining them gives a positive definite covariance whatever came in.
struct SplitState {
    SplitState(const GaussianState& state, double position_floor_m, double velocity_floor_mps)
        : position_m2(
              withEigenvalueFloor(state.covariance.topLeftCorner<2, 2>(), position_floor_m * position_floor_m)) {
        const Eigen::Matrix2d cross =
            0.5 * (state.covariance.bottomLeftCorner<2, 2>() + state.covariance.topRightCorner<2, 2>().transpose());
        gain = cross * position_m2.inverse();
        rest = withEigenvalueFloor(state.covariance.bottomRightCorner<2, 2>() - gain * cross.transpose(),
                                   velocity_floor_mps * velocity_floor_mps);
    }
    Eigen::Matrix4d covariance(const Eigen::Matrix2d& position) const {
        const Eigen::Matrix2d cross = gain * position;
        Eigen::Matrix4d joined;
        joined.topLeftCorner<2, 2>() = position;
        joined.bottomLeftCorner<2, 2>() = cross;
        joined.topRightCorner<2, 2>() = cross.transpose();
        joined.bottomRightCorner<2, 2>() = cross * gain.transpose() + rest;
        return 0.5 * (joined + joined.transpose());
    }
    Eigen::Matrix2d position_m2;
    Eigen::Matrix2d gain;
    Eigen::Matrix2d rest;
};

bool isUsable(const Cue& cue) {
    const Eigen::Matrix2d& r = cue.covariance_m2;
    return cue.position_m.allFinite() && r.allFinite() && std::isfinite(cue.weight) && cue.weight > 0 && r(0, 0) > 0 &&
           r.determinant() > 0;
}

bool isFinite(const GaussianState& state) { return state.mean.allFinite() && state.covariance.allFinite(); }

}  // namespace

GaussianParticleFilter::GaussianParticleFilter(const Params& params) : params_(params) {}

GaussianParticleFilter::Posterior GaussianParticleFilter::update(const GaussianState& prior, double miss_weight,
                                                                 std::span<const Cue> cues, RandomStream stream,
                                                                 ParticleCloud* cloud) {
    if (cloud) {  // emptied, its memory kept for the next particles
        cloud->position_m.clear();
        cloud->weight.clear();
        cloud->effective = 0.0;
    }
    Posterior posterior{.state = prior, .evidence = std::isfinite(miss_weight) ? std::max(miss_weight, 0.0) : 0.0};
    posterior.missed = !isFinite(prior);
    if (posterior.missed) return posterior;

    const SplitState split(prior, params_.position_floor_m, params_.velocity_floor_mps);
    GaussianState floored = prior;
    floored.covariance = split.covariance(split.position_m2);
    takeCues(floored, posterior.evidence, cues);
    if (echoes_.empty()) return posterior;

    propose();
    int pairs = params_.particles / 2;
    Round round = drawAndWeigh(pairs, stream);
    if (round.effective < params_.draw_again_below * 2 * pairs) {
        pairs *= 2;
        proposal_ = {{round.mean_m, 2.0 * round.covariance_m2, pairs, 0}};
        round = drawAndWeigh(pairs, stream);
    }
    GaussianState state{.time = prior.time, .mean = prior.mean, .covariance = split.covariance(round.covariance_m2)};
    state.mean.head<2>() += round.mean_m;
    state.mean.tail<2>() += split.gain * round.mean_m;
    const double evidence = std::exp(log_evidence_) * round.mean_weight;
    posterior.effective_sample_size = round.effective;
    posterior.missed =
        !(round.effective >= params_.unusable_below * 2 * pairs) || !isFinite(state) || !std::isfinite(evidence);
    posterior.state = posterior.missed ? floored : state;
    if (posterior.missed) return posterior;
    posterior.evidence = evidence;
    if (cloud) copyParticles(prior, round, *cloud);
    return posterior;
}

void GaussianParticleFilter::takeCues(const GaussianState& prior, double miss_weight, std::span<const Cue> cues) {
    prior_m2_ = prior.covariance.topLeftCorner<2, 2>();
    log_miss_ = std::log(miss_weight);
    echoes_.clear();
    double greatest = log_miss_;
    for (const Cue& cue : cues) {
        if (!isUsable(cue)) continue;
        const KalmanUpdate near =
            kalmanUpdate(prior, cue.position_m, params_.proposal_noise_factor * cue.covariance_m2);
        const Eigen::Vector2d innovation = near.innovation_m;
        const double log_joint = std::log(cue.weight) + logGaussian(innovation, prior_m2_ + cue.covariance_m2);
        if (!std::isfinite(log_joint)) continue;
        echoes_.push_back({GaussianTerm(innovation, lowerRoot(cue.covariance_m2), std::log(cue.weight)), log_joint,
                           near.state.mean.head<2>() - prior.mean.head<2>(),
                           params_.proposal_inflation * near.state.covariance.topLeftCorner<2, 2>()});
        greatest = std::max(greatest, log_joint);
    }
    double sum = std::exp(log_miss_ - greatest);
    for (const Echo& echo : echoes_) sum += std::exp(echo.log_joint - greatest);
    log_evidence_ = greatest + std::log(sum);
}

/// Shares the particles out without chance: each echo's part by its share of the evidence, the rest to the prior.
/// Each component reads the pool of random numbers from a place of its own, so that one pair more or less here
/// leaves the draws of the others as they are.
void GaussianParticleFilter::propose() {
    const int pairs = params_.particles / 2;
    const double floor = params_.position_floor_m * params_.position_floor_m;
    double echoes_log = echoes_.front().log_joint, sum = 0.0;
    for (const Echo& echo : echoes_) echoes_log = std::max(echoes_log, echo.log_joint);
    for (const Echo& echo : echoes_) sum += std::exp(echo.log_joint - echoes_log);

    proposal_.assign(1, {Eigen::Vector2d::Zero(), prior_m2_, pairs, 0});
    for (std::size_t j = 0; j < echoes_.size(); ++j) {
        const double share = (1.0 - params_.prior_share) * std::exp(echoes_[j].log_joint - echoes_log) / sum;
        const int own = static_cast<int>(share * pairs);
        if (own < fewest_pairs) continue;
        proposal_.front().pairs -= own;
        proposal_.push_back({echoes_[j].proposal_mean_m, withEigenvalueFloor(echoes_[j].proposal_m2, floor), own,
                             (j + 1) * static_cast<std::size_t>(pairs) / (echoes_.size() + 1)});
    }
}

GaussianParticleFilter::Round GaussianParticleFilter::drawAndWeigh(int pairs, RandomStream& stream) {
    draw(pairs, stream);
    weigh();
    const WeightSums sums = weightSums(weight_, particles());
    Round round;
    round.covariance_m2 = prior_m2_;
    if (!(sums.total > 0)) return round;
    round.mean_weight = sums.total / (2.0 * pairs);
    round.effective = sums.total * sums.total / sums.squares;
    round.mean_m = sums.positions / sums.total;
    const Eigen::Matrix2d squares = weightedSquares(weight_, particles(), round.mean_m) / sums.total;
    round.covariance_m2 = squares.allFinite()
                              ? withEigenvalueFloor(squares, params_.position_floor_m * params_.position_floor_m)
                              : squares;
    return round;
}

/// Fills the particles and each one's log density in the component it came from.
void GaussianParticleFilter::draw(int pairs, RandomStream& stream) {
    const auto half = static_cast<std::size_t>(pairs), count = 2 * half;
    for (auto* numbers : {&pool_north_, &pool_east_}) {
        numbers->resize(count);
        stream.fillGaussian(std::span(*numbers).first(half));
        std::copy_n(numbers->begin(), half, numbers->begin() + static_cast<std::ptrdiff_t>(half));
    }
    for (auto* array : {&north_, &east_, &log_reference_}) array->resize(count);
    std::size_t begin = 0;
    for (const Component& component : proposal_) {
        const auto own = static_cast<std::size_t>(component.pairs);
        const Positions normals{std::span(pool_north_).subspan(component.first_number, own),
                                std::span(pool_east_).subspan(component.first_number, own)};
        const Eigen::Matrix2d root = lowerRoot(component.covariance_m2);
        const Eigen::Matrix2d whitened = root * lowerRoot(meanSquare(normals)).inverse();
        const std::span north = std::span(north_).subspan(begin, 2 * own);
        const std::span east = std::span(east_).subspan(begin, 2 * own);
        placePairs(component.mean_m, whitened, normals, north, east);
        logDensity(GaussianTerm(component.mean_m, root, 0.0), {north, east},
                   std::span(log_reference_).subspan(begin, 2 * own));
        begin += 2 * own;
    }
}

/// weight = likelihood · prior / π, with the evidence of the linear Gaussian problem as unit. Both sides of the
/// quotient are taken relative to the density of the particle's own component: a log-sum-exp whose greatest term is
/// known beforehand, so that neither can overflow, nor the lower one vanish.
void GaussianParticleFilter::weigh() {
    const std::size_t count = north_.size();
    log_prior_.resize(count);
    weight_.resize(count);
    drawn_.assign(count, 0.0F);
    joint_.assign(count, 0.0F);
    for (const Component& component : proposal_) {
        const double share = 2.0 * component.pairs / static_cast<double>(count);
        addRelativeDensity(GaussianTerm(component.mean_m, lowerRoot(component.covariance_m2), std::log(share)),
                           particles(), log_reference_, drawn_);
    }
    const Eigen::Matrix2d prior_root = lowerRoot(prior_m2_);
    if (std::isfinite(log_miss_))
        addRelativeDensity(GaussianTerm(Eigen::Vector2d::Zero(), prior_root, log_miss_ - log_evidence_), particles(),
                           log_reference_, joint_);
    logDensity(GaussianTerm(Eigen::Vector2d::Zero(), prior_root, -log_evidence_), particles(), log_prior_);
    for (std::size_t i = 0; i < count; ++i) log_prior_[i] = log_reference_[i] - log_prior_[i];
    for (const Echo& echo : echoes_) addRelativeDensity(echo.likelihood, particles(), log_prior_, joint_);
    for (std::size_t i = 0; i < count; ++i) weight_[i] = joint_[i] / drawn_[i];
}

void GaussianParticleFilter::copyParticles(const GaussianState& prior, const Round& round, ParticleCloud& cloud) const {
    const Eigen::Vector2f origin = prior.mean.head<2>().cast<float>();
    const auto to_share = static_cast<float>(1.0 / (round.mean_weight * static_cast<double>(weight_.size())));
    cloud.position_m.resize(weight_.size());
    cloud.weight.resize(weight_.size());
    for (std::size_t i = 0; i < weight_.size(); ++i) {
        cloud.position_m[i] = origin + Eigen::Vector2f(north_[i], east_[i]);
        cloud.weight[i] = weight_[i] * to_share;
    }
    cloud.effective = round.effective;
}

}  // namespace echotrail
