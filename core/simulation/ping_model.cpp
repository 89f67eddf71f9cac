#include "core/simulation/ping_model.hpp"

#include "core/base/random.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace echotrail {

namespace {

// The head and the water: method card, section i.
constexpr HeadSetup usual_head;
constexpr double rest_between_pings_s = 0.035;
constexpr double beam_width_rad = radiansFromDegrees(3.0);    // θ_h, at half power
constexpr double beam_height_rad = radiansFromDegrees(20.0);  // θ_v
constexpr double integral_width = 0.753;                      // of the two-way beam, times its width at half power
constexpr double side_lobe_db = -45.0;                        // two-way floor of the beam
constexpr double source_level_db = 205.0;
constexpr double absorption_db_per_m = 0.095;  // at 325 kHz in sea water of 15 °C
constexpr double noise_level_db = 57.2;        // −15 + 20 log 325 (kHz) + 10 log 100000 (Hz) − 28 (directivity)
constexpr double volume_strength_db = -75.0;
constexpr double most_compensation_db = 80.0;                   // of the receiver's time-varied gain
constexpr double level_zero_db = -60.0;                         // the scatterer that gives level 0 at 0 dB gain
constexpr double lowest_grazing_rad = radiansFromDegrees(6.0);  // data of lower angles are mixed: no weaker than here
constexpr double gain_db_per_percent = 0.8;
constexpr double ring_down_m = 1.0;      // the transducer rings from full scale to nothing in this range
constexpr double range_smear = 0.15;     // deviation of an object's echo in range, times its size
constexpr double scintillation_s = 3.0;  // between independent strengths of an object

/// What random numbers are for; an object's number is added to the last.
enum Purpose : std::uint64_t { speckle_numbers = 1, scintillation_numbers = 1000 };

double powerOf(double db) { return std::pow(10.0, db / 10.0); }
double decibels(double power) { return 10.0 * std::log10(power); }

/// One-way power of the beam at an angle off its axis: half at half its width.
double beamPattern(double off_axis_rad, double width_rad) {
    const double widths = 2.0 * off_axis_rad / width_rad;
    return std::exp2(-widths * widths);
}

double twoWay(double transmit, double receive) { return std::max(transmit * receive, powerOf(side_lobe_db)); }

/// Steps from one end of the sector to the other, and where a ping lies in the way to and fro.
struct Sweep {
    std::uint64_t steps = 0;
    std::uint64_t phase = 0;  ///< 0 … 2·steps − 1
    bool clockwise() const { return phase < steps; }
};

Sweep sweepOf(const Scenario& scenario, std::uint64_t number) {
    const auto steps =
        static_cast<std::uint64_t>(std::llround(2.0 * scenario.sector_half_width_deg / scenario.step_deg));
    return {steps, number % (2 * steps)};
}

/// An object as one ping meets it.
struct PointEcho {
    double range_m = 0.0;
    double deviation_m = 0.0;
    double power = 0.0;  ///< target strength, the beam and the present scintillation
};

/// Strength of an object relative to its mean: gamma of shape 2, changing over some seconds. Each of four Gaussian
/// numbers turns from one knot's value to the next with its variance kept.
double scintillation(std::uint64_t seed, std::uint64_t object, double time_s) {
    const double knots = time_s / scintillation_s, knot = std::floor(knots);
    const double turn = (knots - knot) * std::numbers::pi / 2.0;
    const auto first = static_cast<std::uint64_t>(knot);
    RandomStream from(seed, scintillation_numbers + object, first), to(seed, scintillation_numbers + object, first + 1);
    double sum = 0.0;
    for (int i = 0; i < 4; ++i) {
        const double value = std::cos(turn) * from.gaussian() + std::sin(turn) * to.gaussian();
        sum += value * value;
    }
    return sum / 4.0;
}

/// How a ping meets a point at a place `positionAt(seconds since transmission)`: its range is that of the moment of
/// the echo, half-way between transmission and reception; the beam turns with the vehicle between those two.
template <class PositionAt>
PointEcho meet(const Scenario& scenario, double ping_s, const HeadSetup& head, const PositionAt& positionAt) {
    const auto seenFrom = [&](double transmitted_s, double at_s) {
        const Pose vehicle = vehiclePose(scenario, ping_s + at_s);
        const Eigen::Vector2d way = positionAt(transmitted_s) - Eigen::Vector2d(vehicle.north_m, vehicle.east_m);
        const double off_axis =
            wrapRadians(std::atan2(way.y(), way.x()) - vehicle.heading.inRadians()) - head.bearing.inRadians();
        return std::pair(way.norm(), beamPattern(wrapRadians(off_axis), beam_width_rad));
    };
    const double flight_s = seenFrom(0.0, 0.0).first / head.sound_speed;
    const double transmit = seenFrom(flight_s, 0.0).second;
    const double receive = seenFrom(flight_s, 2.0 * flight_s).second;
    return {.range_m = seenFrom(flight_s, flight_s).first, .power = twoWay(transmit, receive)};
}

std::vector<PointEcho> pointEchoes(const Scenario& scenario, std::uint64_t seed, double ping_s, const HeadSetup& head) {
    std::vector<PointEcho> echoes;
    for (const SimulatedTarget& target : scenario.targets) {
        PointEcho echo =
            meet(scenario, ping_s, head, [&](double t) { return targetMotion(target, ping_s + t).position_m; });
        echo.power *= powerOf(target.strength_db) * scintillation(seed, echoes.size(), ping_s);
        echo.deviation_m = range_smear * target.size_m;
        echoes.push_back(echo);
    }
    for (const Debris& debris : scenario.debris) {
        PointEcho echo =
            meet(scenario, ping_s, head, [&](double) { return Eigen::Vector2d(debris.north_m, debris.east_m); });
        echo.power *= powerOf(debris.strength_db);
        echo.deviation_m = range_smear * debris.size_m;
        echoes.push_back(echo);
    }
    return echoes;
}

/// Scattering of the bottom or the surface, `distance_m` below or above the head: Lambert's law over the patch that
/// the beam and the bin cut out, through the beam's vertical pattern. None nearer than the distance.
double boundaryPower(double range_m, double bin_m, double distance_m, double strength_db) {
    if (range_m < distance_m) return 0.0;
    const double sine = distance_m / range_m;
    const double law = std::max(sine, std::sin(lowest_grazing_rad));
    const double cosine = std::max(std::sqrt(1.0 - sine * sine), 0.1);  // straight below, the patch is not endless
    const double vertical = beamPattern(std::asin(sine), beam_height_rad);
    const double patch_m2 = integral_width * beam_width_rad * range_m * bin_m / cosine;
    return powerOf(strength_db) * law * law * patch_m2 * twoWay(vertical, vertical);
}

/// Mean power of what is everywhere, as a scatterer's strength: boundaries, volume and noise.
double backgroundPower(const Scenario& scenario, double range_m, double bin_m, double loss_db) {
    const double solid_angle = integral_width * beam_width_rad * integral_width * beam_height_rad;
    return boundaryPower(range_m, bin_m, scenario.altitude_m, scenario.bottom_strength_db) +
           boundaryPower(range_m, bin_m, scenario.water_depth_m - scenario.altitude_m, scenario.surface_strength_db) +
           powerOf(volume_strength_db) * solid_angle * range_m * range_m * bin_m +
           powerOf(noise_level_db - source_level_db + loss_db);
}

}  // namespace

double pingInterval(const Scenario& scenario) {
    return 2.0 * scenario.range_m / usual_head.sound_speed + rest_between_pings_s;
}

double pingTime(const Scenario& scenario, std::uint64_t number) {
    const Microseconds since_start = microsecondsFromSeconds(static_cast<double>(number) * pingInterval(scenario));
    return std::chrono::duration<double>(since_start).count();
}

Bearing pingBearing(const Scenario& scenario, std::uint64_t number) {
    const Sweep sweep = sweepOf(scenario, number);
    const std::uint64_t step = sweep.clockwise() ? sweep.phase : 2 * sweep.steps - sweep.phase;
    return Bearing::degrees(static_cast<double>(step) * scenario.step_deg - scenario.sector_half_width_deg);
}

std::vector<std::uint8_t> simulateEcho(const Scenario& scenario, std::uint64_t seed, const HeadSetup& head,
                                       double time_s, std::uint64_t number) {
    std::vector<std::uint8_t> levels;
    levels.reserve(static_cast<std::size_t>(head.bins));
    const std::vector<PointEcho> objects = pointEchoes(scenario, seed, time_s, head);
    const double gain_db = scenario.gain_db + (head.gain_db - usual_head.gain_db);
    RandomStream speckle(seed, speckle_numbers, number);
    for (int i = 0; i < head.bins; ++i) {
        const double range_m = (i + 0.5) * head.binSize();
        const double loss_db = 40.0 * std::log10(range_m) + 2.0 * absorption_db_per_m * range_m;
        double power = backgroundPower(scenario, range_m, head.binSize(), loss_db);
        for (const PointEcho& object : objects) {
            const double off = (range_m - object.range_m) / object.deviation_m;
            power += object.power * std::exp(-off * off / 2.0);
        }
        power *= -std::log(speckle.uniform());  // a single look: exponential power
        const double uncompensated_db = std::max(loss_db - most_compensation_db, 0.0);
        const double echo_db = decibels(power) - uncompensated_db - level_zero_db + gain_db;
        const double ring_db = full_scale_db * (1.0 - range_m / ring_down_m);  // the same for every ping
        const double level_db = decibels(powerOf(echo_db) + powerOf(ring_db));
        levels.push_back(
            static_cast<std::uint8_t>(std::lround(std::clamp(level_db, 0.0, full_scale_db) * levels_per_db)));
    }
    return levels;
}

Ping simulatePing(const Scenario& scenario, std::uint64_t seed, std::uint64_t number) {
    const double ping_s = pingTime(scenario, number);
    HeadSetup head;
    head.range_m = scenario.range_m;
    head.bin_interval_s = 2.0 * scenario.range_m / head.sound_speed / head.bins;
    head.bearing = pingBearing(scenario, number);
    head.step_rad = radiansFromDegrees(scenario.step_deg);
    return {.sequence = number,
            .time = simulation_start + microsecondsFromSeconds(ping_s),
            .bearing = head.bearing,
            .step_rad = head.step_rad,
            .range_scale_m = head.range_m,
            .bin_interval_s = head.bin_interval_s,
            .sound_speed_mps = head.sound_speed,
            .frequency_hz = head.frequency_hz,
            .gain_percent = head.gain_db / gain_db_per_percent,
            .clockwise = sweepOf(scenario, number).clockwise(),
            .levels = simulateEcho(scenario, seed, head, ping_s, number)};
}

}  // namespace echotrail
