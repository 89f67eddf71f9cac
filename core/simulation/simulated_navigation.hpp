#pragma once

#include "core/base/random.hpp"
#include "core/simulation/scenario.hpp"

#include <cstdint>

namespace echotrail {

/// What navigation tells at a moment, its errors included.
struct NavigationSample {
    double time_s = 0.0;  ///< since the first ping
    Pose pose;
    Eigen::Vector2d over_ground_mps{0, 0};    ///< north, east
    Eigen::Vector2d through_water_mps{0, 0};  ///< north, east
    double depth_m = 0.0;                     ///< of the head
    double altitude_m = 0.0;
};

/// The scenario's navigation, one sample every 50 ms from its start on: white and constant errors of heading and
/// velocity, a position that is reckoned from that velocity and drawn back to the truth by fixes, and poses that are
/// older than the time they are told with. Without errors it is the truth. The same scenario and seed give the same.
class SimulatedNavigation {
public:
    static constexpr Microseconds interval{50'000};

    SimulatedNavigation(const Scenario& scenario, std::uint64_t seed) : scenario_(scenario), seed_(seed) {}
    NavigationSample next();

private:
    Scenario scenario_;
    std::uint64_t seed_;
    std::uint64_t number_ = 0;
    Eigen::Vector2d position_error_m_{0, 0};
};

}  // namespace echotrail
