#include "core/filters/lookup_filter.hpp"

#include "core/data/polygon.hpp"
#include "core/filters/covariance.hpp"

#include <cmath>

namespace echotrail {

LookupUpdate lookupUpdate(const GaussianState& prior, std::span<const ScoredArea> areas, int particles, double floor_m,
                          RandomStream stream, ParticleCloud* cloud) {
    LookupUpdate update{.posterior = {prior, 0.0, 0.0, true}, .share = std::vector<double>(areas.size(), 0.0)};
    const Eigen::Matrix2d spread = withEigenvalueFloor(prior.covariance.topLeftCorner<2, 2>(), floor_m * floor_m);
    const Eigen::Matrix2d root = lowerRoot(spread);
    std::vector<Eigen::Vector2d> places;
    std::vector<double> weights;
    double total = 0, squares = 0;
    Eigen::Vector2d mean(0, 0);
    for (int n = 0; n < particles; ++n) {
        const double first = stream.gaussian(), second = stream.gaussian();
        const Eigen::Vector2d place = prior.mean.head<2>() + root * Eigen::Vector2d(first, second);
        double weight = 0;
        for (std::size_t k = 0; k < areas.size() && weight == 0; ++k) {
            if (!isInside(place.cast<float>(), areas[k].outline_m)) continue;
            weight = areas[k].score;
            update.share[k] += weight;
        }
        places.push_back(place);
        weights.push_back(weight);
        total += weight;
        squares += weight * weight;
        mean += weight * place;
    }
    if (!(total > 1e-12)) return update;
    mean /= total;
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
    for (std::size_t n = 0; n < places.size(); ++n)
        covariance += weights[n] / total * (places[n] - mean) * (places[n] - mean).transpose();
    for (double& share : update.share) share /= total;
    auto& state = update.posterior.state;
    state.mean.head<2>() = mean;
    state.covariance.setZero();
    state.covariance.topLeftCorner<2, 2>() = withEigenvalueFloor(covariance, floor_m * floor_m);
    state.covariance.bottomRightCorner<2, 2>() = prior.covariance.bottomRightCorner<2, 2>();
    update.posterior.evidence = total / particles;
    update.posterior.effective_sample_size = total * total / squares;
    update.posterior.missed = false;
    if (cloud) {
        *cloud = {};
        for (std::size_t n = 0; n < places.size(); ++n) {
            cloud->position_m.push_back(places[n].cast<float>());
            cloud->weight.push_back(static_cast<float>(weights[n] / total));
        }
        cloud->effective = update.posterior.effective_sample_size;
    }
    return update;
}

}  // namespace echotrail
