#include "core/filters/motion_model.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

namespace echotrail {
namespace {

Timestamp at(double seconds) { return Timestamp{microsecondsFromSeconds(seconds)}; }

GaussianState someState() {
    GaussianState state{.time = at(100.0), .mean = {10.0, -4.0, 0.5, 1.5}};
    const Eigen::Matrix4d root{{0.8, 0, 0, 0}, {0.1, 0.5, 0, 0}, {0.2, 0.0, 0.3, 0}, {0.0, 0.1, 0.05, 0.2}};
    state.covariance = root * root.transpose();
    return state;
}

TEST(MotionModel, MovesTheMeanByItsVelocity) {
    const GaussianState later = predicted(someState(), at(104.0), 0.01);
    EXPECT_EQ(later.time, at(104.0));
    EXPECT_TRUE(later.mean.isApprox(Eigen::Vector4d(12.0, 2.0, 0.5, 1.5), 1e-14));
}

TEST(MotionModel, FromACertainStateTheCovarianceIsTheNoiseOfTheInterval) {
    GaussianState certain = someState();
    certain.covariance.setZero();
    const GaussianState later = predicted(certain, at(102.0), 0.3);
    for (int axis = 0; axis < 2; ++axis) {
        EXPECT_NEAR(later.covariance(axis, axis), 0.3 * 8.0 / 3.0, 1e-14);
        EXPECT_NEAR(later.covariance(axis, axis + 2), 0.3 * 2.0, 1e-14);
        EXPECT_NEAR(later.covariance(axis + 2, axis + 2), 0.3 * 2.0, 1e-14);
    }
    EXPECT_EQ(later.covariance(0, 1), 0.0);
    EXPECT_EQ(later.covariance(2, 3), 0.0);
}

TEST(MotionModel, TwoStepsEqualOne) {
    const GaussianState once = predicted(someState(), at(107.0), 0.05);
    const GaussianState twice = predicted(predicted(someState(), at(103.0), 0.05), at(107.0), 0.05);
    EXPECT_TRUE(once.mean.isApprox(twice.mean, 1e-13));
    EXPECT_TRUE(once.covariance.isApprox(twice.covariance, 1e-13));
}

TEST(MotionModel, TwoStepsBackEqualOneAndGrowUncertain) {
    const GaussianState once = predicted(someState(), at(93.0), 0.05);
    const GaussianState twice = predicted(predicted(someState(), at(97.0), 0.05), at(93.0), 0.05);
    EXPECT_TRUE(once.mean.isApprox(twice.mean, 1e-13));
    EXPECT_TRUE(once.covariance.isApprox(twice.covariance, 1e-13));
    const GaussianState without_noise = predicted(someState(), at(93.0), 0.0);
    const Eigen::Matrix4d added = once.covariance - without_noise.covariance;
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(added).eigenvalues().minCoeff(), 0.0);
}

TEST(MotionModel, NoTimeChangesNothing) {
    const GaussianState same = predicted(someState(), at(100.0), 0.05);
    EXPECT_EQ(same.mean, someState().mean);
    EXPECT_EQ(same.covariance, someState().covariance);
}

}  // namespace
}  // namespace echotrail
