#include "core/simulation/simulated_navigation.hpp"

#include <cmath>

namespace echotrail {

namespace {

constexpr std::uint64_t navigation_numbers = 3;

}  // namespace

NavigationSample SimulatedNavigation::next() {
    const NavigationErrors& errors = scenario_.navigation;
    const double interval_s = std::chrono::duration<double>(interval).count();
    RandomStream random(seed_, navigation_numbers, number_);
    const double latency_s =
        errors.least_latency_s + (errors.most_latency_s - errors.least_latency_s) * random.uniform();
    const double heading_rad =
        radiansFromDegrees(errors.heading_bias_deg + errors.heading_noise_deg * random.gaussian());
    const Eigen::Vector2d white(random.gaussian(), random.gaussian());

    NavigationSample sample;
    sample.time_s = static_cast<double>(number_) * interval_s;
    const VehicleState truth = vehicleState(scenario_, sample.time_s - latency_s);
    const double bow_rad = truth.pose.heading.inRadians();
    const Eigen::Vector2d ahead(std::cos(bow_rad), std::sin(bow_rad));
    const Eigen::Vector2d velocity_error = errors.velocity_bias_mps * ahead + errors.velocity_noise_mps * white;
    if (number_ > 0) position_error_m_ += interval_s * (velocity_error - position_error_m_ / errors.position_hold_s);
    sample.pose = {truth.pose.north_m + position_error_m_.x(), truth.pose.east_m + position_error_m_.y(),
                   truth.pose.heading + heading_rad};
    sample.over_ground_mps = truth.over_ground_mps + velocity_error;
    sample.through_water_mps = truth.through_water_mps + velocity_error;
    sample.depth_m = truth.depth_m;
    sample.altitude_m = truth.altitude_m;
    ++number_;
    return sample;
}

}  // namespace echotrail
