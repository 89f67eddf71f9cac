#include "core/filters/particle_kernels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace echotrail {
namespace {

const std::vector<float> north{0.0F, 1.0F, -2.0F, 0.5F, 3.0F, -1.5F, 2.5F, 0.25F, 4.0F, -3.0F, 0.1F};
const std::vector<float> east{0.0F, -1.0F, 0.5F, 2.0F, 1.0F, -2.5F, 0.75F, 0.125F, -4.0F, 3.0F, 0.2F};
const Eigen::Vector2d mean(0.5, -0.25);
const Eigen::Matrix2d root{{1.5, 0.0}, {0.4, 0.8}};

double density(double n, double e) {
    const double u = (n - mean.x()) / root(0, 0);
    const double v = (e - mean.y() - root(1, 0) * u) / root(1, 1);
    return std::exp(-0.5 * (u * u + v * v)) / (2.0 * std::numbers::pi * root(0, 0) * root(1, 1));
}

TEST(ParticleKernels, DensitiesAreThoseOfTheGaussian) {
    std::vector<float> log(north.size()), reference(north.size(), 1.0F), sum(north.size(), 0.5F);
    const GaussianTerm term(mean, root, std::log(3.0));
    logDensity(term, {north, east}, log);
    addRelativeDensity(term, {north, east}, reference, sum);
    for (std::size_t i = 0; i < north.size(); ++i) {
        const double expected = 3.0 * density(north[i], east[i]);
        EXPECT_NEAR(log[i], std::log(expected), 1e-5);
        EXPECT_NEAR(sum[i], 0.5 + expected / std::numbers::e, 2e-6);
    }
}

TEST(ParticleKernels, ExponentialIsGoodToASinglePrecisionRounding) {
    // A wide flat term makes the exponent minus the reference.
    const GaussianTerm flat({0, 0}, 1e9 * Eigen::Matrix2d::Identity(), std::log(2.0 * std::numbers::pi * 1e18));
    std::vector<float> reference, zeros, sum;
    for (float x = -79.0F; x < 79.0F; x += 0.0137F) reference.push_back(-x);
    zeros.assign(reference.size(), 0.0F);
    sum = zeros;
    addRelativeDensity(flat, {zeros, zeros}, reference, sum);
    for (std::size_t i = 0; i < sum.size(); ++i) {
        const double exponent = double{flat.log_scale} - double{reference[i]};
        ASSERT_NEAR(sum[i] / std::exp(exponent), 1.0, 2e-6 + 1e-7 * std::abs(exponent)) << exponent;
    }
}

TEST(ParticleKernels, WhatIsFarAwayCountsAsZeroAndNothingOverflows) {
    const float huge = std::numeric_limits<float>::max(), nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> n{100.0F, huge, -huge, nan, 0.5F}, e{0.0F, -huge, huge, 0.0F, -0.25F};
    const std::vector<float> reference{0.0F, 0.0F, 0.0F, 0.0F, -1e6F};
    std::vector<float> sum(5, 0.0F);
    addRelativeDensity(GaussianTerm(mean, root, 0.0), {n, e}, reference, sum);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(sum[i], 0.0F) << i;
    EXPECT_NEAR(sum[4] / std::exp(80.0), 1.0, 1e-5);
}

TEST(ParticleKernels, PairsLieSymmetricallyAboutTheMean) {
    std::vector<float> n(2 * north.size()), e(n.size());
    placePairs(mean, root, {north, east}, n, e);
    for (std::size_t i = 0; i < north.size(); ++i) {
        EXPECT_NEAR(n[i], 0.5F + 1.5F * north[i], 1e-6F);
        EXPECT_NEAR(e[i], -0.25F + 0.4F * north[i] + 0.8F * east[i], 1e-6F);
        EXPECT_NEAR(n[i] + n[north.size() + i], 1.0F, 1e-6F);
        EXPECT_NEAR(e[i] + e[north.size() + i], -0.5F, 1e-6F);
    }
}

TEST(ParticleKernels, SumsCoverEveryParticleOnce) {
    const std::vector<float> weight{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};  // eleven: one full row of lanes and a rest
    double total = 0, squares = 0;
    Eigen::Vector2d positions(0, 0);
    Eigen::Matrix2d about = Eigen::Matrix2d::Zero(), plain = Eigen::Matrix2d::Zero();
    for (std::size_t i = 0; i < weight.size(); ++i) {
        const Eigen::Vector2d x(north[i], east[i]);
        const double w = weight[i];
        total += w;
        squares += w * w;
        positions += w * x;
        about += w * (x - mean) * (x - mean).transpose();
        plain += x * x.transpose() / static_cast<double>(weight.size());
    }
    const WeightSums sums = weightSums(weight, {north, east});
    EXPECT_EQ(sums.total, total);
    EXPECT_EQ(sums.squares, squares);
    EXPECT_TRUE(sums.positions.isApprox(positions, 1e-14));
    EXPECT_TRUE(weightedSquares(weight, {north, east}, mean).isApprox(about, 1e-13));
    EXPECT_TRUE(meanSquare({north, east}).isApprox(plain, 1e-13));
}

}  // namespace
}  // namespace echotrail
