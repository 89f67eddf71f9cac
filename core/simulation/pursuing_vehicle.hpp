#pragma once

#include "core/base/parameters.hpp"
#include "core/base/result.hpp"
#include "core/simulation/scenario.hpp"
#include "core/simulation/vehicle_path.hpp"

#include <memory>
#include <optional>
#include <string_view>

namespace echotrail {

/// How a simulated vehicle follows the target it is told of.
struct PursuitParams {
    double keep_range_m = 20.0;
    double vehicle_top_speed_mps = 1.0;
    double vehicle_acceleration_mps2 = 0.1;
    double vehicle_turn_rate_deg = 5.0;
    double range_gain = 0.1;
    double range_integral_gain = 0.002;
    double steering_gain = 0.5;
    double longest_wait_s = 3.0;
};

template <>
struct Described<PursuitParams> {
    using P = PursuitParams;
    static constexpr std::string_view group = "Simulated vehicle";
    static constexpr auto fields = std::tuple{
        Field{&P::keep_range_m, "keep_range_m", "m", 2, 200, "Range that it keeps to the target"},
        Field{&P::vehicle_top_speed_mps, "vehicle_top_speed_mps", "m/s", 0.1, 10, "Its greatest speed through water"},
        Field{&P::vehicle_acceleration_mps2, "vehicle_acceleration_mps2", "m/s²", 0.01, 5,
              "How fast its speed changes"},
        Field{&P::vehicle_turn_rate_deg, "vehicle_turn_rate_deg", "deg/s", 0.5, 60, "How fast it turns"},
        Field{&P::range_gain, "range_gain", "1/s", 0, 5, "Speed for each metre that it is too far away"},
        Field{&P::range_integral_gain, "range_integral_gain", "1/s²", 0, 1,
              "The same for each metre and second, so that a current does not keep it off"},
        Field{&P::steering_gain, "steering_gain", "1/s", 0.05, 10, "Turn rate for the angle between bow and target"},
        Field{&P::longest_wait_s, "longest_wait_s", "s", 0.2, 60,
              "Without a valid report for so long it stops and keeps its heading"}};
};

/// The part of a report (`--report`, JSON) that a controller steers by.
struct SteeringReport {
    bool valid = false;
    double range_m = 0.0;
    Bearing from_bow;
    Eigen::Vector2d velocity_mps{0, 0};  ///< of the target over ground: north, east
};
/// Reads a line of reports. What is no such line is an error, whoever sent it.
Result<SteeringReport> readSteeringReport(std::string_view line);

/// A vehicle whose controller knows nothing but the reports it hears: it turns its bow to the target and holds the
/// range, going as fast as the target goes away from it, and faster or slower by what it is too far or too near. It
/// never goes astern. A current carries it along. The same reports at the same times steer it the same way.
class PursuingVehicle {
public:
    /// It waits where the scenario's own vehicle begins.
    PursuingVehicle(const PursuitParams& params, const Scenario& scenario);

    /// `time_s` since the scenario's start, as for all that follows. It steers by it from where it has been moved to.
    void hear(const SteeringReport& report, double time_s);
    /// Moves it on to a time, in steps of 50 ms.
    void moveTo(double time_s);
    /// Where it has been. It goes on growing: a scenario whose vehicle is to be this one holds it.
    const std::shared_ptr<const VehiclePath>& path() const { return shared_path_; }
    std::uint64_t validReports() const { return valid_reports_; }

private:
    struct Heard {
        SteeringReport report;
        double time_s = 0.0;
        Bearing azimuth;  ///< of the target, from north, by the vehicle's own heading then
    };
    void step();
    double wantedSpeed();

    PursuitParams params_;
    Eigen::Vector2d current_mps_;
    std::shared_ptr<VehiclePath> path_ = std::make_shared<VehiclePath>();
    std::shared_ptr<const VehiclePath> shared_path_ = path_;
    std::uint64_t steps_ = 0;
    double speed_mps_ = 0.0;     ///< through water
    double integral_mps_ = 0.0;  ///< what the range's error has come to over time
    std::optional<Heard> heard_;
    std::uint64_t valid_reports_ = 0;
};

}  // namespace echotrail
