#pragma once

#include "core/data/track.hpp"

#include <span>

namespace echotrail {

/// What a measured position did to a state.
struct KalmanUpdate {
    GaussianState state;
    Eigen::Vector2d innovation_m{0, 0};                                      ///< measured minus predicted
    Eigen::Matrix2d innovation_covariance_m2 = Eigen::Matrix2d::Identity();  ///< S = HΣHᵀ + R
    double nis = 0.0;                                                        ///< innovationᵀ S⁻¹ innovation
};

/// Kalman update of `prior` with a measured position (north, east, m) of covariance `covariance_m2`, which must be
/// positive definite; in Joseph's form, whose result stays symmetric and positive semidefinite under rounding.
KalmanUpdate kalmanUpdate(const GaussianState& prior, const Eigen::Vector2d& position_m,
                          const Eigen::Matrix2d& covariance_m2);

/// One of several measured positions that may be the object's.
struct PositionCandidate {
    Eigen::Vector2d position_m{0, 0};
    Eigen::Matrix2d covariance_m2 = Eigen::Matrix2d::Identity();
    double probability = 0.0;  ///< that this one is; with `none` they add up to 1
};

/// Probabilistic data association (Bar-Shalom & Tse 1975): the Kalman updates with each candidate and the prior itself
/// (probability `none`), mixed and replaced by the Gaussian of the same mean and covariance.
GaussianState associationUpdate(const GaussianState& prior, double none, std::span<const PositionCandidate> candidates);

}  // namespace echotrail
