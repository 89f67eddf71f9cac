#pragma once

#include <Eigen/Core>

namespace echotrail {

/// The symmetric part, with eigenvalues below `floor` (> 0) raised to it: always positive definite, and unchanged
/// where it was so already. Not for matrices with infinities.
Eigen::Matrix2d withEigenvalueFloor(const Eigen::Matrix2d& matrix, double floor);

/// Lower triangular L with LLᵀ = `matrix`, which must be symmetric and positive definite.
Eigen::Matrix2d lowerRoot(const Eigen::Matrix2d& matrix);

/// log N(offset; 0, covariance) in two dimensions; −∞ or not a number where the covariance is not positive definite.
double logGaussian(const Eigen::Vector2d& offset, const Eigen::Matrix2d& covariance);

}  // namespace echotrail
