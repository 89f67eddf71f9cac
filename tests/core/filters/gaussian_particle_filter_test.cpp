#include "core/filters/gaussian_particle_filter.hpp"

#include "core/filters/kalman.hpp"
#include "core/filters/motion_model.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace echotrail {
namespace {

GaussianParticleFilter filterOf(int particles) {
    GaussianParticleFilterParams params;
    params.particles = particles;
    return GaussianParticleFilter(params);
}

GaussianState someState() {
    GaussianState state{.time = Timestamp{Microseconds{5}}, .mean = {10.0, -4.0, 0.5, 1.5}};
    const Eigen::Matrix4d root{{0.8, 0, 0, 0}, {0.1, 0.6, 0, 0}, {0.2, 0.0, 0.3, 0}, {0.0, 0.1, 0.05, 0.2}};
    state.covariance = root * root.transpose();
    return state;
}

std::vector<Cue> twoCues() {
    return {{.position_m = {10.9, -3.2}, .covariance_m2 = Eigen::Matrix2d{{0.06, 0.02}, {0.02, 0.09}}, .weight = 3.0},
            {.position_m = {9.0, -4.8}, .covariance_m2 = Eigen::Matrix2d{{0.10, -0.03}, {-0.03, 0.05}}, .weight = 1.5}};
}

double density(const Eigen::Vector2d& offset, const Eigen::Matrix2d& covariance) {
    return std::exp(-0.5 * offset.dot(covariance.inverse() * offset)) /
           (2.0 * std::numbers::pi * std::sqrt(covariance.determinant()));
}

double evidence(const GaussianState& prior, double miss_weight, const std::vector<Cue>& cues) {
    double sum = miss_weight;
    for (const Cue& cue : cues)
        sum += cue.weight * density(cue.position_m - prior.mean.head<2>(),
                                    prior.covariance.topLeftCorner<2, 2>() + cue.covariance_m2);
    return sum;
}

double leastEigenvalue(const Eigen::Matrix4d& matrix) {
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(matrix).eigenvalues().minCoeff();
}

/// Mean and covariance of a one-step posterior, by summing prior · likelihood over a grid of positions; the velocity
/// at each position is the prior's, given the position.
struct GridMoments {
    GridMoments(const GaussianState& prior, double miss_weight, const std::vector<Cue>& cues) {
        const Eigen::Matrix2d position = prior.covariance.topLeftCorner<2, 2>();
        const Eigen::Matrix2d gain = prior.covariance.bottomLeftCorner<2, 2>() * position.inverse();
        const Eigen::Matrix2d rest = prior.covariance.bottomRightCorner<2, 2>() - gain * position * gain.transpose();
        double total = 0;
        Eigen::Matrix4d squares = Eigen::Matrix4d::Zero();
        for (double n = -5.0; n <= 5.0; n += 0.04)
            for (double e = -5.0; e <= 5.0; e += 0.04) {
                const Eigen::Vector2d offset(n, e);
                double likelihood = miss_weight;
                for (const Cue& cue : cues)
                    likelihood +=
                        cue.weight * density(cue.position_m - prior.mean.head<2>() - offset, cue.covariance_m2);
                const double weight = likelihood * density(offset, position);
                Eigen::Vector4d x;
                x << offset, gain * offset;
                total += weight;
                mean += weight * x;
                squares += weight * x * x.transpose();
            }
        mean /= total;
        covariance = squares / total - mean * mean.transpose();
        covariance.bottomRightCorner<2, 2>() += rest;
        mean += prior.mean;
    }
    Eigen::Vector4d mean = Eigen::Vector4d::Zero();
    Eigen::Matrix4d covariance;
};

TEST(GaussianParticleFilter, EqualsTheKalmanFilterOnLinearGaussianData) {
    constexpr double dt = 5.0, q = 0.01;
    const Eigen::Matrix2d noise{{0.09, 0.03}, {0.03, 0.25}};
    const Eigen::Matrix2d noise_root = noise.llt().matrixL();
    GaussianState start;
    start.covariance.diagonal() << 0.7, 0.63, 0.25, 0.25;
    const Eigen::Matrix4d start_root = start.covariance.llt().matrixL();
    GaussianState still;
    still.covariance.setZero();
    const Eigen::Matrix4d step_root =
        predicted(still, still.time + microsecondsFromSeconds(dt), q).covariance.llt().matrixL();
    GaussianParticleFilter filter = filterOf(500);
    double error_kalman = 0, error_particles = 0, nees_kalman = 0, nees_particles = 0;
    int count = 0;
    for (std::uint64_t run = 0; run < 100; ++run) {
        RandomStream random(11, run, 0);
        const auto normal4 = [&] {
            return Eigen::Vector4d(random.gaussian(), random.gaussian(), random.gaussian(), random.gaussian());
        };
        Eigen::Vector4d truth = start_root * normal4();
        GaussianState kalman = start, particles = start;
        for (std::uint64_t step = 0; step < 30; ++step) {
            const Timestamp time = kalman.time + microsecondsFromSeconds(dt);
            truth.head<2>() += dt * truth.tail<2>();
            truth += step_root * normal4();
            const Eigen::Vector2d measured =
                truth.head<2>() + noise_root * Eigen::Vector2d(random.gaussian(), random.gaussian());
            kalman = kalmanUpdate(predicted(kalman, time, q), measured, noise).state;
            const Cue cue{.position_m = measured, .covariance_m2 = noise, .weight = 1.0};
            const auto posterior = filter.update(predicted(particles, time, q), 0.0, std::span(&cue, 1),
                                                 RandomStream(7, run, step), nullptr);
            ASSERT_FALSE(posterior.missed);
            particles = posterior.state;
            const auto add = [&](const GaussianState& state, double& error, double& nees) {
                const Eigen::Vector2d e = state.mean.head<2>() - truth.head<2>();
                error += e.squaredNorm();
                nees += e.dot(state.covariance.topLeftCorner<2, 2>().inverse() * e);
            };
            add(kalman, error_kalman, nees_kalman);
            add(particles, error_particles, nees_particles);
            ++count;
        }
    }
    EXPECT_NEAR(std::sqrt(error_particles / error_kalman), 1.0, 0.01);
    EXPECT_NEAR(nees_particles / count, nees_kalman / count, 0.05);
    EXPECT_NEAR(nees_kalman / count, 2.0, 0.15);  // and the data are what they are meant to be
    RecordProperty("rmse_ratio", std::to_string(std::sqrt(error_particles / error_kalman)));
    RecordProperty("nees_kalman", std::to_string(nees_kalman / count));
    RecordProperty("nees_particles", std::to_string(nees_particles / count));
}

TEST(GaussianParticleFilter, TwoCuesGiveTheMomentsOfTheTwoHumpedPosterior) {
    const GridMoments exact(someState(), 0.1, twoCues());
    const auto posterior = filterOf(20000).update(someState(), 0.1, twoCues(), RandomStream(1, 2, 3), nullptr);
    EXPECT_FALSE(posterior.missed);
    EXPECT_LT((posterior.state.mean - exact.mean).cwiseAbs().maxCoeff(), 0.02);
    EXPECT_LT((posterior.state.covariance - exact.covariance).cwiseAbs().maxCoeff(), 0.02);
    EXPECT_GT(exact.covariance(0, 0), 0.5);  // two humps: wider than any single echo would leave it
}

TEST(GaussianParticleFilter, EvidenceIsTheIntegralOfLikelihoodTimesPrior) {
    GaussianParticleFilter filter = filterOf(2000);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const auto posterior = filter.update(someState(), 0.1, twoCues(), RandomStream(seed, 0, 0), nullptr);
        EXPECT_NEAR(posterior.evidence / evidence(someState(), 0.1, twoCues()), 1.0, 0.05);
    }
}

TEST(GaussianParticleFilter, DrawnFromThePriorAloneItFindsTheSamePosterior) {
    GaussianParticleFilterParams params;
    params.particles = 20000;
    params.prior_share = 1.0;
    const GridMoments exact(someState(), 0.1, twoCues());
    const auto posterior =
        GaussianParticleFilter(params).update(someState(), 0.1, twoCues(), RandomStream(1, 2, 3), nullptr);
    EXPECT_LT((posterior.state.mean - exact.mean).cwiseAbs().maxCoeff(), 0.04);
    EXPECT_NEAR(posterior.evidence / evidence(someState(), 0.1, twoCues()), 1.0, 0.05);
}

TEST(GaussianParticleFilter, DrawsAgainWhereTheFirstParticlesMissTheEcho) {
    GaussianParticleFilterParams params;
    params.particles = 1000;
    params.prior_share = 1.0;  // nothing drawn near the echo: only a few particles of the prior reach it
    GaussianState prior = someState();
    prior.covariance = Eigen::Vector4d(4.0, 4.0, 0.1, 0.1).asDiagonal();
    const std::vector<Cue> cues{{.position_m = {13.0, -2.0}, .covariance_m2 = 0.04 * Eigen::Matrix2d::Identity()}};
    ParticleCloud cloud;
    const auto posterior = GaussianParticleFilter(params).update(prior, 0.0, cues, RandomStream(1, 2, 3), &cloud);
    const GaussianState exact = kalmanUpdate(prior, cues[0].position_m, cues[0].covariance_m2).state;
    EXPECT_EQ(cloud.weight.size(), 2000U);  // twice as many
    EXPECT_FALSE(posterior.missed);
    EXPECT_GT(posterior.effective_sample_size, 400.0);
    EXPECT_LT((posterior.state.mean - exact.mean).norm(), 0.05);
}

TEST(GaussianParticleFilter, WithoutACueThePosteriorIsThePrediction) {
    GaussianParticleFilter filter = filterOf(2000);
    ParticleCloud cloud;
    cloud.weight.resize(3);
    const auto posterior = filter.update(someState(), 0.25, {}, RandomStream(1, 2, 3), &cloud);
    EXPECT_EQ(posterior.state.mean, someState().mean);
    EXPECT_EQ(posterior.state.covariance, someState().covariance);
    EXPECT_EQ(posterior.evidence, 0.25);
    EXPECT_FALSE(posterior.missed);
    EXPECT_TRUE(cloud.weight.empty());
}

TEST(GaussianParticleFilter, SameSeedSameBytesOtherSeedOthers) {
    GaussianParticleFilter one = filterOf(2000), other = filterOf(2000);
    ParticleCloud first_cloud, again_cloud;
    const auto first = one.update(someState(), 0.1, twoCues(), RandomStream(1, 2, 3), &first_cloud);
    other.update(someState(), 0.3, std::vector<Cue>{twoCues().front()}, RandomStream(4, 5, 6), nullptr);
    const auto again = other.update(someState(), 0.1, twoCues(), RandomStream(1, 2, 3), &again_cloud);
    const auto differently = one.update(someState(), 0.1, twoCues(), RandomStream(1, 2, 4), nullptr);
    EXPECT_EQ(first.state.mean, again.state.mean);
    EXPECT_EQ(first.state.covariance, again.state.covariance);
    EXPECT_EQ(first.evidence, again.evidence);
    EXPECT_EQ(first_cloud.weight, again_cloud.weight);
    EXPECT_TRUE(first_cloud.position_m == again_cloud.position_m);
    EXPECT_NE(first.state.mean, differently.state.mean);
}

TEST(GaussianParticleFilter, TheCloudIsThePosterior) {
    ParticleCloud cloud;
    const auto posterior = filterOf(2000).update(someState(), 0.1, twoCues(), RandomStream(1, 2, 3), &cloud);
    ASSERT_EQ(cloud.weight.size(), 2000U);
    ASSERT_EQ(cloud.position_m.size(), 2000U);
    double total = 0, squares = 0;
    Eigen::Vector2d mean(0, 0);
    for (std::size_t i = 0; i < cloud.weight.size(); ++i) {
        total += cloud.weight[i];
        squares += double{cloud.weight[i]} * cloud.weight[i];
        mean += cloud.weight[i] * cloud.position_m[i].cast<double>();
    }
    EXPECT_NEAR(total, 1.0, 1e-5);
    EXPECT_NEAR(cloud.effective, 1.0 / squares, 0.1);
    EXPECT_EQ(cloud.effective, posterior.effective_sample_size);
    EXPECT_LT((mean - posterior.state.mean.head<2>()).norm(), 1e-4);
}

TEST(GaussianParticleFilter, APriorOfRankOneSurvives) {
    GaussianState prior = someState();
    const Eigen::Vector4d line(1.0, 0.5, 0.2, 0.1);
    prior.covariance = line * line.transpose();
    const auto posterior = filterOf(500).update(prior, 0.1, twoCues(), RandomStream(1, 2, 3), nullptr);
    EXPECT_FALSE(posterior.missed);
    EXPECT_TRUE(posterior.state.mean.allFinite());
    EXPECT_GT(leastEigenvalue(posterior.state.covariance), 0.0);
    EXPECT_LT((posterior.state.mean - prior.mean).norm(), 1.0);
}

TEST(GaussianParticleFilter, DeviationsKeepTheirFloors) {
    GaussianState state = someState();
    const Cue cue{.position_m = {10.0, -4.0}, .covariance_m2 = 1e-4 * Eigen::Matrix2d::Identity()};
    GaussianParticleFilter filter = filterOf(500);
    for (std::uint64_t i = 0; i < 50; ++i)
        state = filter.update(state, 0.0, std::span(&cue, 1), RandomStream(1, 2, i), nullptr).state;
    const Eigen::Matrix2d position = state.covariance.topLeftCorner<2, 2>();
    const Eigen::Matrix2d velocity = state.covariance.bottomRightCorner<2, 2>();
    EXPECT_GE(Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(position).eigenvalues().minCoeff(), 0.0499 * 0.0499);
    EXPECT_GE(Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(velocity).eigenvalues().minCoeff(), 0.0199 * 0.0199);
}

TEST(GaussianParticleFilter, CuesOfNoWeightLeaveThePrior) {
    std::vector<Cue> cues = twoCues();
    for (Cue& cue : cues) cue.weight = 0.0;
    const auto posterior = filterOf(500).update(someState(), 0.1, cues, RandomStream(1, 2, 3), nullptr);
    EXPECT_EQ(posterior.state.mean, someState().mean);
    EXPECT_EQ(posterior.state.covariance, someState().covariance);
    EXPECT_EQ(posterior.evidence, 0.1);
}

TEST(GaussianParticleFilter, ACueOutOfReachChangesNothingWhileAMissIsPossible) {
    for (const double distance : {50.0, 1e4, 1e9, 1e30, 1e200}) {
        const Cue cue{.position_m = {distance, 0.0}, .covariance_m2 = 0.1 * Eigen::Matrix2d::Identity()};
        const auto posterior =
            filterOf(2000).update(someState(), 0.1, std::span(&cue, 1), RandomStream(1, 2, 3), nullptr);
        EXPECT_FALSE(posterior.missed);
        EXPECT_LT((posterior.state.mean - someState().mean).norm(), 1e-3) << distance;
        EXPECT_LT((posterior.state.covariance - someState().covariance).norm(), 0.01) << distance;
        EXPECT_NEAR(posterior.evidence, 0.1, 1e-3) << distance;
    }
}

TEST(GaussianParticleFilter, BadCuesAreLeftOutAndTheGoodOneIsUsed) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    const Eigen::Matrix2d unit = Eigen::Matrix2d::Identity();
    const std::vector<Cue> bad{{.position_m = {nan, 0.0}, .covariance_m2 = unit},
                               {.position_m = {0.0, infinity}, .covariance_m2 = unit},
                               {.position_m = {10.0, -4.0}, .covariance_m2 = unit, .weight = nan},
                               {.position_m = {10.0, -4.0}, .covariance_m2 = unit, .weight = -1.0},
                               {.position_m = {10.0, -4.0}, .covariance_m2 = -unit},
                               {.position_m = {10.0, -4.0}, .covariance_m2 = Eigen::Matrix2d::Zero()},
                               {.position_m = {10.0, -4.0}, .covariance_m2 = nan * unit}};
    std::vector<Cue> all = bad;
    all.push_back(twoCues().front());
    const auto only_bad = filterOf(500).update(someState(), 0.1, bad, RandomStream(1, 2, 3), nullptr);
    EXPECT_EQ(only_bad.state.mean, someState().mean);
    const auto mixed = filterOf(500).update(someState(), 0.1, all, RandomStream(1, 2, 3), nullptr);
    const auto good = filterOf(500).update(someState(), 0.1, std::span(all).last(1), RandomStream(1, 2, 3), nullptr);
    EXPECT_EQ(mixed.state.mean, good.state.mean);
    EXPECT_EQ(mixed.evidence, good.evidence);
}

TEST(GaussianParticleFilter, AnUnusablePriorIsReportedAsAMiss) {
    GaussianState broken = someState();
    broken.covariance(0, 1) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(filterOf(500).update(broken, 0.1, twoCues(), RandomStream(1, 2, 3), nullptr).missed);
    broken = someState();
    broken.covariance *= 1e300;
    const auto posterior = filterOf(500).update(broken, 0.1, twoCues(), RandomStream(1, 2, 3), nullptr);
    EXPECT_TRUE(posterior.state.mean.allFinite());
}

TEST(GaussianParticleFilter, CovarianceStaysPositiveDefiniteWhateverComesIn) {
    RandomStream random(3, 1, 4);
    const auto size = [&](double low, double high) { return std::pow(10.0, low + (high - low) * random.uniform()); };
    GaussianParticleFilter filter = filterOf(200);
    int missed = 0;
    for (std::uint64_t i = 0; i < 10'000; ++i) {
        GaussianState prior;
        Eigen::Matrix4d root = Eigen::Matrix4d::Zero();
        for (int row = 0; row < 4; ++row) {
            prior.mean[row] = size(-2, 4) * random.gaussian();
            const double scale = size(-4, 2);
            for (int column = 0; column < 4; ++column)
                root(row, column) = random.uniform() < 0.3 ? 0.0 : scale * random.gaussian();
        }
        prior.covariance = root * root.transpose();
        std::vector<Cue> cues(1 + random.bits() % 5);
        for (Cue& cue : cues) {
            Eigen::Matrix2d r;
            for (double& value : r.reshaped()) value = size(-3, 2) * random.gaussian();
            cue.covariance_m2 = r * r.transpose();
            cue.position_m = prior.mean.head<2>() + size(-3, 3) * Eigen::Vector2d(random.gaussian(), random.gaussian());
            cue.weight = random.uniform() < 0.1 ? 0.0 : size(-8, 5);
        }
        const double miss_weight = random.uniform() < 0.2 ? 0.0 : random.uniform();
        const auto posterior = filter.update(prior, miss_weight, cues, RandomStream(5, 0, i), nullptr);
        missed += posterior.missed;
        ASSERT_TRUE(posterior.state.mean.allFinite()) << i;
        ASSERT_TRUE(std::isfinite(posterior.evidence)) << i;
        ASSERT_GE(posterior.evidence, 0.0) << i;
        if (posterior.effective_sample_size == 0.0) continue;  // no usable cue: the prior as it came
        const Eigen::Vector4d scale = posterior.state.covariance.diagonal().cwiseSqrt().cwiseInverse();
        ASSERT_EQ(
            Eigen::LLT<Eigen::Matrix4d>(scale.asDiagonal() * posterior.state.covariance * scale.asDiagonal()).info(),
            Eigen::Success)
            << i << '\n'
            << posterior.state.covariance;
    }
    EXPECT_LT(missed, 1000);
}

}  // namespace
}  // namespace echotrail
