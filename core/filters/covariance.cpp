#include "core/filters/covariance.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <cmath>
#include <numbers>

namespace echotrail {

Eigen::Matrix2d withEigenvalueFloor(const Eigen::Matrix2d& matrix, double floor) {
    const Eigen::Matrix2d symmetric = 0.5 * (matrix + matrix.transpose());
    const double half_trace = 0.5 * symmetric.trace();
    const double radius = std::hypot(0.5 * (symmetric(0, 0) - symmetric(1, 1)), symmetric(0, 1));
    if (half_trace - radius >= floor) return symmetric;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(symmetric);
    const Eigen::Matrix2d& axes = eigen.eigenvectors();
    return axes * eigen.eigenvalues().cwiseMax(floor).asDiagonal() * axes.transpose();
}

Eigen::Matrix2d lowerRoot(const Eigen::Matrix2d& matrix) {
    const Eigen::LLT<Eigen::Matrix2d> cholesky(matrix);
    if (cholesky.info() == Eigen::Success) return cholesky.matrixL();
    // So long and thin that rounding spoils the elimination: the eigenvectors still give a root, QR makes it
    // triangular.
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(matrix);
    const double least = 1e-12 * eigen.eigenvalues().cwiseAbs().maxCoeff();
    const Eigen::Vector2d sizes = eigen.eigenvalues().cwiseMax(least).cwiseSqrt();
    const Eigen::Matrix2d root = eigen.eigenvectors() * sizes.asDiagonal();
    const double first = root.row(0).norm();
    Eigen::Matrix2d lower = Eigen::Matrix2d::Zero();
    lower(0, 0) = first;
    lower(1, 0) = root.row(1).dot(root.row(0)) / first;
    lower(1, 1) = sizes.prod() / first;
    return lower;
}

double logGaussian(const Eigen::Vector2d& offset, const Eigen::Matrix2d& covariance) {
    const double determinant = covariance.determinant();
    return -0.5 * offset.dot(covariance.inverse() * offset) - 0.5 * std::log(determinant) -
           std::log(2.0 * std::numbers::pi);
}

}  // namespace echotrail
