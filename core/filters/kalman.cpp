#include "core/filters/kalman.hpp"

#include <Eigen/LU>

#include <utility>
#include <vector>

namespace echotrail {

KalmanUpdate kalmanUpdate(const GaussianState& prior, const Eigen::Vector2d& position_m,
                          const Eigen::Matrix2d& covariance_m2) {
    KalmanUpdate update{.state = prior};
    update.innovation_m = position_m - prior.mean.head<2>();
    update.innovation_covariance_m2 = prior.covariance.topLeftCorner<2, 2>() + covariance_m2;
    const Eigen::Matrix2d inverse = update.innovation_covariance_m2.inverse();
    update.nis = update.innovation_m.dot(inverse * update.innovation_m);
    const Eigen::Matrix<double, 4, 2> gain = prior.covariance.leftCols<2>() * inverse;
    update.state.mean += gain * update.innovation_m;
    Eigen::Matrix4d kept = Eigen::Matrix4d::Identity();
    kept.leftCols<2>() -= gain;
    const Eigen::Matrix4d joseph = kept * prior.covariance * kept.transpose() + gain * covariance_m2 * gain.transpose();
    update.state.covariance = 0.5 * (joseph + joseph.transpose());
    return update;
}

GaussianState associationUpdate(const GaussianState& prior, double none,
                                std::span<const PositionCandidate> candidates) {
    std::vector<std::pair<double, GaussianState>> parts{{none, prior}};
    for (const PositionCandidate& candidate : candidates)
        parts.emplace_back(candidate.probability,
                           kalmanUpdate(prior, candidate.position_m, candidate.covariance_m2).state);
    GaussianState mixed{.time = prior.time, .covariance = Eigen::Matrix4d::Zero()};
    for (const auto& [probability, part] : parts) mixed.mean += probability * part.mean;
    for (const auto& [probability, part] : parts) {
        const Eigen::Vector4d off = part.mean - mixed.mean;
        mixed.covariance += probability * (part.covariance + off * off.transpose());
    }
    return mixed;
}

}  // namespace echotrail
