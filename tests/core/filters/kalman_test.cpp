#include "core/filters/kalman.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <array>

namespace echotrail {
namespace {

GaussianState someState() {
    GaussianState state{.mean = {10.0, -4.0, 0.5, 1.5}};
    const Eigen::Matrix4d root{{0.8, 0, 0, 0}, {0.1, 0.5, 0, 0}, {0.2, 0.0, 0.3, 0}, {0.0, 0.1, 0.05, 0.2}};
    state.covariance = root * root.transpose();
    return state;
}

TEST(Kalman, AgreesWithAddingUpInformation) {
    const GaussianState prior = someState();
    const Eigen::Vector2d measured(10.6, -3.9);
    const Eigen::Matrix2d noise{{0.09, 0.02}, {0.02, 0.04}};
    Eigen::Matrix4d information = prior.covariance.inverse();
    Eigen::Vector4d weighted = information * prior.mean;
    information.topLeftCorner<2, 2>() += noise.inverse();
    weighted.head<2>() += noise.inverse() * measured;
    const KalmanUpdate update = kalmanUpdate(prior, measured, noise);
    EXPECT_TRUE(update.state.covariance.isApprox(information.inverse(), 1e-10));
    EXPECT_TRUE(update.state.mean.isApprox(information.inverse() * weighted, 1e-10));
}

TEST(Kalman, ReportsTheInnovationAndItsSize) {
    GaussianState prior;
    prior.covariance.diagonal() << 3.0, 1.0, 1.0, 1.0;
    const KalmanUpdate update = kalmanUpdate(prior, {4.0, 2.0}, Eigen::Matrix2d::Identity());
    EXPECT_EQ(update.innovation_m, Eigen::Vector2d(4.0, 2.0));
    EXPECT_EQ(update.innovation_covariance_m2, (Eigen::Matrix2d{{4.0, 0.0}, {0.0, 2.0}}));
    EXPECT_DOUBLE_EQ(update.nis, 16.0 / 4.0 + 4.0 / 2.0);
}

TEST(Kalman, StaysPositiveUnderVeryPreciseMeasurements) {
    GaussianState state = someState();
    state.covariance *= 1e6;
    for (int i = 0; i < 100; ++i) state = kalmanUpdate(state, {10.0, -4.0}, 1e-8 * Eigen::Matrix2d::Identity()).state;
    EXPECT_EQ(state.covariance, state.covariance.transpose());
    EXPECT_GE(Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(state.covariance).eigenvalues().minCoeff(), 0.0);
}

TEST(AssociationUpdate, OneSureCandidateIsTheKalmanUpdate) {
    const GaussianState prior = someState();
    const PositionCandidate sure{{10.6, -3.9}, 0.1 * Eigen::Matrix2d::Identity(), 1.0};
    const GaussianState mixed = associationUpdate(prior, 0.0, std::array{sure});
    const GaussianState alone = kalmanUpdate(prior, sure.position_m, sure.covariance_m2).state;
    EXPECT_TRUE(mixed.mean.isApprox(alone.mean, 1e-12));
    EXPECT_TRUE(mixed.covariance.isApprox(alone.covariance, 1e-12));
}

TEST(AssociationUpdate, TwoEvenCandidatesSpreadAboutTheirMiddle) {
    GaussianState prior;
    const Eigen::Matrix2d noise = Eigen::Matrix2d::Identity();
    const std::array both{PositionCandidate{{2, 0}, noise, 0.5}, PositionCandidate{{-2, 0}, noise, 0.5}};
    const GaussianState mixed = associationUpdate(prior, 0.0, both);
    EXPECT_NEAR(mixed.mean.norm(), 0.0, 1e-12);
    EXPECT_NEAR(mixed.covariance(0, 0), 0.5 + 1.0, 1e-12);  // each halves the variance and moves half way
    EXPECT_NEAR(mixed.covariance(1, 1), 0.5, 1e-12);
}

}  // namespace
}  // namespace echotrail
