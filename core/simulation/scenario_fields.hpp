#pragma once

#include "core/base/parameters.hpp"
#include "core/simulation/scenario.hpp"

/// The names, units and limits of what a scenario file can say.
namespace echotrail {

template <>
struct Described<SimulatedTarget> {
    static constexpr std::string_view group = "targets";
    static constexpr auto fields = std::tuple{
        flag(&SimulatedTarget::loop, "loop", "The path closes and is gone along again and again"),
        Field{&SimulatedTarget::size_m, "size_m", "m", 0.05, 20, "Size"},
        Field{&SimulatedTarget::strength_db, "strength_db", "dB", -100, 60, "Target strength without a reflector"},
        Field{&SimulatedTarget::reflector_m, "reflector_m", "m", 0, 5, "Edge of its corner reflector; 0 is none"},
        Field{&SimulatedTarget::faces_deg, "faces_deg", "deg", -180, 360, "Where the reflector looks, from the course"},
        Field{&SimulatedTarget::wander_deg, "wander_deg", "deg", 0, 90, "Deviation of that direction"},
        Field{&SimulatedTarget::body_db, "body_db", "dB", -100, 60, "Strength where the reflector looks away"},
        Field{&SimulatedTarget::below_head_m, "below_head_m", "m", -100, 100, "Depth below the head"},
        Field{&SimulatedTarget::wake_s, "wake_s", "s", 0, 60, "How long its bubbles stay"},
        Field{&SimulatedTarget::wake_db, "wake_db", "dB", -100, 20, "Strength of its bubbles when young"}};
};

template <>
struct Described<Debris> {
    static constexpr std::string_view group = "debris";
    static constexpr auto fields =
        std::tuple{Field{&Debris::north_m, "north_m", "m", -10000, 10000, "Place"},
                   Field{&Debris::east_m, "east_m", "m", -10000, 10000, "Place"},
                   Field{&Debris::size_m, "size_m", "m", 0.05, 20, "Size"},
                   Field{&Debris::strength_db, "strength_db", "dB", -100, 60, "Target strength"}};
};

template <>
struct Described<DebrisField> {
    static constexpr std::string_view group = "debris_fields";
    static constexpr auto fields =
        std::tuple{Field{&DebrisField::count, "count", "", 0, 500, "How many"},
                   Field{&DebrisField::south_m, "south_m", "m", -10000, 10000, "Southern edge"},
                   Field{&DebrisField::north_m, "north_m", "m", -10000, 10000, "Northern edge"},
                   Field{&DebrisField::west_m, "west_m", "m", -10000, 10000, "Western edge"},
                   Field{&DebrisField::east_m, "east_m", "m", -10000, 10000, "Eastern edge"},
                   Field{&DebrisField::smallest_m, "smallest_m", "m", 0.05, 20, "Size of the smallest"},
                   Field{&DebrisField::largest_m, "largest_m", "m", 0.05, 20, "Size of the largest"},
                   Field{&DebrisField::weakest_db, "weakest_db", "dB", -100, 60, "Strength of the weakest"},
                   Field{&DebrisField::strongest_db, "strongest_db", "dB", -100, 60, "Strength of the strongest"}};
};

template <>
struct Described<VehicleMotion> {
    static constexpr std::string_view group = "vehicle";
    static constexpr auto fields = std::tuple{
        Field{&VehicleMotion::speed_mps, "speed_mps", "m/s", -5, 5, "Speed northwards of one that follows nothing"},
        Field{&VehicleMotion::yaw_amplitude_deg, "yaw_amplitude_deg", "deg", 0, 90, "Sway of the bow"},
        Field{&VehicleMotion::yaw_period_s, "yaw_period_s", "s", 1, 10000, "Period of that sway"},
        Field{&VehicleMotion::follow_lag_s, "follow_lag_s", "s", 0, 1000, "It goes where the first target was"},
        Field{&VehicleMotion::current_north_mps, "current_north_mps", "m/s", -5, 5, "The water's motion"},
        Field{&VehicleMotion::current_east_mps, "current_east_mps", "m/s", -5, 5, "The water's motion"},
        Field{&VehicleMotion::crab_share, "crab_share", "", 0, 1, "Part of the drift angle that the bow takes"}};
};

template <>
struct Described<NavigationErrors> {
    static constexpr std::string_view group = "navigation";
    static constexpr auto fields = std::tuple{
        Field{&NavigationErrors::heading_bias_deg, "heading_bias_deg", "deg", -180, 180, "Constant error of heading"},
        Field{&NavigationErrors::heading_noise_deg, "heading_noise_deg", "deg", 0, 30, "Deviation of heading"},
        Field{&NavigationErrors::velocity_bias_mps, "velocity_bias_mps", "m/s", -2, 2, "Constant error ahead"},
        Field{&NavigationErrors::velocity_noise_mps, "velocity_noise_mps", "m/s", 0, 2, "Deviation of velocity"},
        Field{&NavigationErrors::position_hold_s, "position_hold_s", "s", 1, 100000, "How long position errors last"},
        Field{&NavigationErrors::least_latency_s, "least_latency_s", "s", 0, 1, "Least age of a pose when told"},
        Field{&NavigationErrors::most_latency_s, "most_latency_s", "s", 0, 1, "Greatest age of a pose when told"}};
};

template <>
struct Described<Scenario> {
    static constexpr std::string_view group = "scenario";
    static constexpr auto fields = std::tuple{
        Field{&Scenario::duration_s, "duration_s", "s", 0, 86400, "Length"},
        Field{&Scenario::range_m, "range_m", "m", 2, 450, "Range scale"},
        Field{&Scenario::sector_half_width_deg, "sector_half_width_deg", "deg", 0.05625, 180, "To either side"},
        Field{&Scenario::step_deg, "step_deg", "deg", 0.05625, 14.34375, "Turn of the beam between pings"},
        Field{&Scenario::frequency_khz, "frequency_khz", "kHz", 100, 2000, "Frequency"},
        Field{&Scenario::gain_db, "gain_db", "dB", -60, 60, "Gain at the head's usual setting"},
        Field{&Scenario::pulse_us, "pulse_us", "us", 0, 5000, "Length of the pulse"},
        Field{&Scenario::looks, "looks", "", 1, 100, "Independent echoes averaged in a bin"},
        Field{&Scenario::water_depth_m, "water_depth_m", "m", 0.5, 11000, "Depth of the water"},
        Field{&Scenario::altitude_m, "altitude_m", "m", 0.1, 11000, "Mean height of the head above the bottom"},
        Field{&Scenario::altitude_swing_m, "altitude_swing_m", "m", 0, 100, "Rise and fall of the bottom"},
        Field{&Scenario::altitude_period_s, "altitude_period_s", "s", 1, 100000, "Period of that"},
        Field{&Scenario::bottom_strength_db, "bottom_strength_db", "dB", -100, 30, "Per square metre, straight down"},
        Field{&Scenario::bottom_texture, "bottom_texture", "", 0, 100, "Shape of its patches' gamma law; 0 is none"},
        Field{&Scenario::rock_share, "rock_share", "", 0, 1, "Part of the bottom that is rock"},
        Field{&Scenario::rock_db, "rock_db", "dB", -40, 40, "By which rock is stronger"},
        flag(&Scenario::low_grazing_floor, "low_grazing_floor", "No angle scatters less than 6 degrees would"),
        Field{&Scenario::surface_strength_db, "surface_strength_db", "dB", -200, 30, "-35 calm, -20 breaking"},
        Field{&Scenario::multipath_copies, "multipath_copies", "", 0, 10, "Ghosts behind every target"},
        flag(&Scenario::shadows, "shadows", "Objects hide the bottom behind them")};
};

}  // namespace echotrail
