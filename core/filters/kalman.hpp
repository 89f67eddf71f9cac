#pragma once

#include "core/data/track.hpp"

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

}  // namespace echotrail
