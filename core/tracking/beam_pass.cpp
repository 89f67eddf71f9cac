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

bool WatchedSector::holds(Bearing azimuth) const { return std::abs(azimuth - centre) <= half_width_rad; }

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
        first_azimuth_ = beam.azimuth;
    }
    const double swept = beam.azimuth - first_azimuth_;
    lowest_turn_ = std::min(lowest_turn_, swept);
    highest_turn_ = std::max(highest_turn_, swept);
    if (beam.time == start_ || std::abs(turn) < std::abs(nearest_turn_)) {
        nearest_turn_ = turn;
        nearest_time_ = beam.time;
        nearest_head_ = beam.head;
        nearest_place_ = place;
        nearest_beam_ = beam;
    }
}

double BeamPass::coverage() const {
    if (!inside_) return 0.0;
    // Where the place was, as a turn from the first beam; distances across the line of sight as arcs.
    const double place = nearest_place_.azimuth - first_azimuth_;
    const double reach = std::max(nearest_beam_.step_rad, nearest_beam_.beam_width_rad) / 2.0;
    const double arc = nearest_place_.range_m / std::max(nearest_place_.across_sigma_m, 1e-2);
    const double along_sigma = std::max(nearest_place_.along_sigma_m, 1e-2);
    const double across = normalMass((lowest_turn_ - reach - place) * arc, (highest_turn_ + reach - place) * arc);
    const double along =
        normalMass(-nearest_place_.range_m / along_sigma, (nearest_beam_.far_m - nearest_place_.range_m) / along_sigma);
    return across * along;
}

}  // namespace echotrail
