#include "core/filters/gaussian_particle_filter.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

// One update of the Gaussian particle filter, and beside it, with the same arguments in the same run, the update as
// one would first write it down. The ratio of the two says more than either figure on a machine with other work.
namespace echotrail {
namespace {

constexpr double miss_weight = 0.1;

GaussianState someState() {
    GaussianState state{.mean = {10.0, -4.0, 0.5, 1.5}};
    const Eigen::Matrix4d root{{0.8, 0, 0, 0}, {0.1, 0.6, 0, 0}, {0.2, 0.0, 0.3, 0}, {0.0, 0.1, 0.05, 0.2}};
    state.covariance = root * root.transpose();
    return state;
}

/// Cues spread over the gate, so that each stands for part of the posterior.
std::vector<Cue> someCues(int count) {
    std::vector<Cue> cues;
    for (int i = 0; i < count; ++i) {
        const double turn = 2.4 * i, reach = 1.5 * std::sqrt((i + 0.5) / count);
        cues.push_back({.position_m = {10.0 + reach * std::cos(turn), -4.0 + reach * std::sin(turn)},
                        .covariance_m2 = Eigen::Matrix2d{{0.04, 0.01}, {0.01, 0.16}},
                        .weight = 2.0});
    }
    return cues;
}

void sizes(benchmark::internal::Benchmark* benchmark) {
    benchmark->ArgNames({"particles", "cues"})->ArgsProduct({{500, 2000, 10000}, {1, 5, 30}});
    benchmark->Unit(benchmark::kMicrosecond);
}

void particleFilterUpdate(benchmark::State& state) {
    GaussianParticleFilterParams params;
    params.particles = static_cast<int>(state.range(0));
    GaussianParticleFilter filter(params);
    const GaussianState prior = someState();
    const std::vector<Cue> cues = someCues(static_cast<int>(state.range(1)));
    std::uint64_t update = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(filter.update(prior, miss_weight, cues, RandomStream(1, 2, ++update), nullptr));
}
BENCHMARK(particleFilterUpdate)->Apply(sizes);

void particleFilterUpdateWithCloud(benchmark::State& state) {
    GaussianParticleFilter filter{GaussianParticleFilterParams{}};
    const GaussianState prior = someState();
    const std::vector<Cue> cues = someCues(5);
    ParticleCloud cloud;
    std::uint64_t update = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(filter.update(prior, miss_weight, cues, RandomStream(1, 2, ++update), &cloud));
}
BENCHMARK(particleFilterUpdateWithCloud)->Unit(benchmark::kMicrosecond);

/// Particles of four coordinates in double precision, drawn from the prior, weighed with std::exp one by one.
GaussianState textbookUpdate(const GaussianState& prior, const std::vector<Cue>& cues, std::size_t count,
                             std::mt19937_64& engine) {
    struct Particle {
        Eigen::Vector4d x;
        double weight;
    };
    std::normal_distribution<double> normal;
    const Eigen::Matrix4d root = prior.covariance.llt().matrixL();
    std::vector<Particle> particles(count);
    GaussianState posterior;
    posterior.mean.setZero();
    posterior.covariance.setZero();
    double total = 0;
    for (Particle& particle : particles) {
        const Eigen::Vector4d draw(normal(engine), normal(engine), normal(engine), normal(engine));
        particle.x = prior.mean + root * draw;
        particle.weight = miss_weight;
        for (const Cue& cue : cues) {
            const Eigen::Vector2d offset = cue.position_m - particle.x.head<2>();
            particle.weight += cue.weight * std::exp(-0.5 * offset.dot(cue.covariance_m2.inverse() * offset)) /
                               (2.0 * std::numbers::pi * std::sqrt(cue.covariance_m2.determinant()));
        }
        total += particle.weight;
    }
    for (const Particle& particle : particles) posterior.mean += particle.weight / total * particle.x;
    for (const Particle& particle : particles) {
        const Eigen::Vector4d offset = particle.x - posterior.mean;
        posterior.covariance += particle.weight / total * offset * offset.transpose();
    }
    return posterior;
}

void textbookParticleFilterUpdate(benchmark::State& state) {
    const GaussianState prior = someState();
    const std::vector<Cue> cues = someCues(static_cast<int>(state.range(1)));
    std::mt19937_64 engine(1);
    for (auto _ : state)
        benchmark::DoNotOptimize(textbookUpdate(prior, cues, static_cast<std::size_t>(state.range(0)), engine));
}
BENCHMARK(textbookParticleFilterUpdate)->Apply(sizes);

void gaussianNumbers(benchmark::State& state) {
    std::array<float, 2000> numbers;
    std::uint64_t update = 0;
    for (auto _ : state) {
        RandomStream(1, 2, ++update).fillGaussian(numbers);
        benchmark::DoNotOptimize(numbers);
    }
}
BENCHMARK(gaussianNumbers)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace echotrail
