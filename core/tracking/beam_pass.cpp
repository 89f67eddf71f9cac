#include "core/tracking/beam_pass.hpp"

#include <algorithm>
#include <cmath>

namespace echotrail {
namespace {

/// Probability of a standard normal variable between two limits.
double normalMass(double low, double high) {
    return 0.5 * (std::erf(high / std::sqrt(2.0)) - std::erf(low / std::sqrt(2.0)));
}

}  // namespace

ExpectedPlace expectedPlace(const GaussianState& predicted, const Pose& head) {
    ExpectedPlace place;
    place.position_m = predicted.mean.head<2>();
    const Eigen::Vector2d sight = place.position_m - Eigen::Vector2d(head.north_m, head.east_m);
    place.range_m = sight.norm();
    place.azimuth = Bearing::radians(std::atan2(sight.y(), sight.x()));
    const Eigen::Vector2d along = place.range_m > 0 ? Eigen::Vector2d(sight / place.range_m) : Eigen::Vector2d(1, 0);
    const Eigen::Vector2d across(-along.y(), along.x());
    const Eigen::Matrix2d covariance = predicted.covariance.topLeftCorner<2, 2>();
    place.along_sigma_m = std::sqrt(std::max(along.dot(covariance * along), 0.0));
    place.across_sigma_m = std::sqrt(std::max(across.dot(covariance * across), 0.0));
    return place;
}

void BeamPass::follow(const BeamMoment& beam, const ExpectedPlace& place, double half_width_rad) {
    if (ended_) return;
    const double turn = beam.azimuth - place.azimuth;
    if (std::abs(turn) > half_width_rad) {
        ended_ = inside_;
        return;
    }
    if (!inside_) {
        inside_ = true;
        start_ = beam.time;
        nearest_turn_ = lowest_turn_ = highest_turn_ = turn;
        nearest_time_ = beam.time;
        nearest_head_ = beam.head;
    }
    lowest_turn_ = std::min(lowest_turn_, turn);
    highest_turn_ = std::max(highest_turn_, turn);
    if (std::abs(turn) < std::abs(nearest_turn_)) {
        nearest_turn_ = turn;
        nearest_time_ = beam.time;
        nearest_head_ = beam.head;
    }
    const double sigma_rad = std::max(place.across_sigma_m / std::max(place.range_m, 0.1), 1e-3);
    const double reach = std::max(beam.step_rad, beam.beam_width_rad) / 2.0;  // a beam looks a little to each side
    across_ = normalMass((lowest_turn_ - reach) / sigma_rad, (highest_turn_ + reach) / sigma_rad);
    const double along_sigma = std::max(place.along_sigma_m, 1e-2);
    along_ = normalMass((beam.near_m - place.range_m) / along_sigma, (beam.far_m - place.range_m) / along_sigma);
}

}  // namespace echotrail
