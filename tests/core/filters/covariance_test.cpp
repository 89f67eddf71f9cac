#include "core/filters/covariance.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace echotrail {
namespace {

TEST(EigenvalueFloor, LeavesAMatrixAboveItAlone) {
    const Eigen::Matrix2d matrix{{4.0, 1.0}, {1.0, 2.0}};
    EXPECT_EQ(withEigenvalueFloor(matrix, 0.01), matrix);
}

TEST(EigenvalueFloor, RaisesOnlyTheDirectionBelowIt) {
    const Eigen::Vector2d along(0.6, 0.8), across(-0.8, 0.6);
    const Eigen::Matrix2d line = 9.0 * along * along.transpose();
    const Eigen::Matrix2d raised = withEigenvalueFloor(line, 0.25);
    EXPECT_NEAR(along.dot(raised * along), 9.0, 1e-12);
    EXPECT_NEAR(across.dot(raised * across), 0.25, 1e-12);
    EXPECT_NEAR(along.dot(raised * across), 0.0, 1e-12);
}

TEST(EigenvalueFloor, TakesTheSymmetricPart) {
    const Eigen::Matrix2d matrix{{4.0, 3.0}, {1.0, 5.0}};
    EXPECT_EQ(withEigenvalueFloor(matrix, 0.01), (Eigen::Matrix2d{{4.0, 2.0}, {2.0, 5.0}}));
}

TEST(LowerRoot, SquaresToTheMatrixAlsoWhereEliminationFails) {
    const Eigen::Vector2d along(0.6, 0.8);
    // Singular, and by rounding not even positive: plain Cholesky refuses the second.
    for (const double error : {1e-3, -1e-16}) {
        const Eigen::Matrix2d matrix = along * along.transpose() + error * Eigen::Matrix2d::Identity();
        const Eigen::Matrix2d root = lowerRoot(matrix);
        EXPECT_EQ(root(0, 1), 0.0);
        EXPECT_GT(root(1, 1), 0.0);
        EXPECT_TRUE((root * root.transpose()).isApprox(matrix, 1e-9)) << root;
    }
}

TEST(LogGaussian, IsTheNormalDensity) {
    const Eigen::Matrix2d covariance{{4.0, 0.0}, {0.0, 9.0}};
    const double expected = std::log(std::exp(-0.5 * (1.0 / 4.0 + 4.0 / 9.0)) / (2.0 * std::numbers::pi * 6.0));
    EXPECT_NEAR(logGaussian({1.0, 2.0}, covariance), expected, 1e-14);
}

}  // namespace
}  // namespace echotrail
