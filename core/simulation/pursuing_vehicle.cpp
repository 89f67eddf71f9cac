#include "core/simulation/pursuing_vehicle.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace echotrail {
namespace {

constexpr double step_s = 0.05;
constexpr double farthest_m = 10'000.0, fastest_mps = 100.0;

Eigen::Vector2d ahead(Bearing heading) { return {std::cos(heading.inRadians()), std::sin(heading.inRadians())}; }

std::optional<double> numberIn(const nlohmann::json& object, const char* name, double limit) {
    const auto found = object.find(name);
    if (found == object.end() || !found->is_number()) return std::nullopt;
    const double value = found->get<double>();
    return std::abs(value) <= limit ? std::optional(value) : std::nullopt;
}

}  // namespace

Result<SteeringReport> readSteeringReport(std::string_view line) {
    const auto object = nlohmann::json::parse(line, nullptr, false);
    if (!object.is_object()) return Error{"a report has to be a JSON object"};
    const auto valid = object.find("valid");
    const auto range = numberIn(object, "range_m", farthest_m), bearing = numberIn(object, "bearing_deg", 360.0);
    const auto north = numberIn(object, "velocity_north_mps", fastest_mps),
               east = numberIn(object, "velocity_east_mps", fastest_mps);
    if (valid == object.end() || !valid->is_boolean() || !range || *range < 0.0 || !bearing || !north || !east)
        return Error{"a report has to hold valid, range_m, bearing_deg, velocity_north_mps and velocity_east_mps"};
    return SteeringReport{valid->get<bool>(), *range, Bearing::degrees(*bearing), {*north, *east}};
}

PursuingVehicle::PursuingVehicle(const PursuitParams& params, const Scenario& scenario)
    : params_(params), current_mps_(scenario.vehicle.current_north_mps, scenario.vehicle.current_east_mps) {
    path_->add({0.0, vehiclePose(scenario, 0.0), {0, 0}});
}

void PursuingVehicle::hear(const SteeringReport& report, double time_s) {
    if (!report.valid) return;
    ++valid_reports_;
    heard_ = Heard{report, time_s, path_->at(time_s).pose.heading + report.from_bow.inRadians()};
}

void PursuingVehicle::moveTo(double time_s) {
    while (static_cast<double>(steps_ + 1) * step_s <= time_s) step();
}

void PursuingVehicle::step() {
    VehiclePath::Moment now = path_->last();
    now.time_s = static_cast<double>(++steps_) * step_s;
    if (heard_ && now.time_s - heard_->time_s > params_.longest_wait_s) heard_.reset();
    const double gain = params_.vehicle_acceleration_mps2 * step_s;
    speed_mps_ += std::clamp(wantedSpeed() - speed_mps_, -gain, gain);
    if (heard_) {
        const double most = radiansFromDegrees(params_.vehicle_turn_rate_deg);
        const double rate = params_.steering_gain * (heard_->azimuth - now.pose.heading);
        now.pose.heading = now.pose.heading + step_s * std::clamp(rate, -most, most);
    }
    // Until it has ever heard of a target it is held where it is.
    now.over_ground_mps = speed_mps_ * ahead(now.pose.heading);
    if (valid_reports_ > 0) now.over_ground_mps += current_mps_;
    now.pose.north_m += step_s * now.over_ground_mps.x();
    now.pose.east_m += step_s * now.over_ground_mps.y();
    path_->add(now);
}

double PursuingVehicle::wantedSpeed() {
    if (!heard_) return 0.0;
    const SteeringReport& report = heard_->report;
    const double too_far_m = report.range_m - params_.keep_range_m;
    const double away_mps = report.velocity_mps.dot(ahead(heard_->azimuth));
    const double wanted_mps = away_mps + params_.range_gain * too_far_m + integral_mps_;
    // Where it cannot do more, there is nothing to learn from its not coming nearer.
    if (wanted_mps > 0.0 && wanted_mps < params_.vehicle_top_speed_mps)
        integral_mps_ += params_.range_integral_gain * too_far_m * step_s;
    return std::clamp(wanted_mps, 0.0, params_.vehicle_top_speed_mps);
}

}  // namespace echotrail
