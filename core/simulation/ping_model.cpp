#include "core/simulation/ping_model.hpp"

#include "core/base/random.hpp"
#include "core/simulation/acoustics.hpp"
#include "core/simulation/ground.hpp"
#include "core/simulation/objects.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

namespace echotrail {

namespace {

using acoustics::decibels;
using acoustics::powerOf;

constexpr HeadSetup usual_head;
constexpr double rest_between_pings_s = 0.035;
constexpr double source_level_db = 205.0;
constexpr double most_compensation_db = 80.0;  // of the receiver's time-varied gain
constexpr double level_zero_db = -60.0;        // the scatterer that gives level 0 at 0 dB gain
constexpr double gain_db_per_percent = 0.8;
constexpr double ring_down_m = 1.0;        // the transducer rings from full scale to nothing in this range
constexpr double most_pulse_bins = 256.0;  // a longer pulse would cost time and show nothing new
constexpr std::uint64_t speckle_numbers = 1;

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

/// Mean power, as a scatterer's strength, of all that a transmission meets.
class Scene {
public:
    Scene(const Scenario& scenario, std::uint64_t seed, const HeadSetup& head, double time_s)
        : scenario_(scenario),
          head_(head),
          lobe_(acoustics::lobeAt(head.frequency_hz)),
          vehicle_(vehicleState(scenario, time_s)),
          objects_(objectEchoes(scenario, seed, head, time_s)),
          ground_(scenario, seed, vehicle_.pose, vehicle_.pose.heading + head.bearing.inRadians(), vehicle_.altitude_m,
                  lobe_),
          noise_db_(acoustics::noiseLevel(head.frequency_hz) - source_level_db) {}

    /// `loss_db`: spreading and absorption of both ways.
    double powerAt(double range_m, double loss_db) {
        return bottomPower(range_m) + boundary(range_m, vehicle_.depth_m, scenario_.surface_strength_db) +
               acoustics::volumePower(lobe_, range_m, head_.binSize()) + objectPower(range_m) +
               powerOf(noise_db_ + loss_db);
    }

private:
    double boundary(double range_m, double distance_m, double strength_db) const {
        return acoustics::boundaryPower(lobe_, range_m, head_.binSize(), distance_m, strength_db,
                                        scenario_.low_grazing_floor);
    }

    double bottomPower(double range_m) {
        double power = boundary(range_m, vehicle_.altitude_m, scenario_.bottom_strength_db) * ground_.at(range_m);
        for (const Shadow& shadow : objects_.shadows)
            if (range_m > shadow.near_m && range_m < shadow.far_m) power *= 1.0 - shadow.share;
        return power;
    }

    double objectPower(double range_m) const {
        constexpr double farthest = 7.0;  // beyond so many deviations nothing is left
        double power = 0.0;
        for (const PointEcho& echo : objects_.echoes) {
            const double off = (range_m - echo.range_m) / echo.deviation_m;
            if (std::abs(off) < farthest) power += echo.power * std::exp(-off * off / 2.0);
        }
        return power;
    }

    const Scenario& scenario_;
    const HeadSetup& head_;
    acoustics::Lobe lobe_;
    VehicleState vehicle_;
    ObjectEchoes objects_;
    GroundAlongBeam ground_;
    double noise_db_;
};

/// Speckle: the power of a complex Gaussian echo, one per bin, or the mean of several. A pulse of `pulse_bins` meets
/// the scatterers of several bins at once, so that neighbours are alike. Unit mean.
std::vector<double> speckle(std::uint64_t seed, std::uint64_t number, int bins, int looks, double pulse_bins) {
    const auto whole = static_cast<std::size_t>(std::max(pulse_bins, 1.0));
    const double rest = std::max(pulse_bins, 1.0) - static_cast<double>(whole);
    const double norm = 2.0 * looks * (static_cast<double>(whole) + rest * rest);
    const auto count = static_cast<std::size_t>(bins);
    std::vector<float> real(count + whole), imaginary(count + whole);
    std::vector<double> power(count);
    RandomStream random(seed, speckle_numbers, number);
    for (int look = 0; look < looks; ++look) {
        random.fillGaussian(real);
        random.fillGaussian(imaginary);
        for (std::size_t i = 0; i < count; ++i) {
            double x = rest * real[i + whole], y = rest * imaginary[i + whole];
            for (std::size_t k = i; k < i + whole; ++k) {
                x += real[k];
                y += imaginary[k];
            }
            power[i] += (x * x + y * y) / norm;
        }
    }
    return power;
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
    assert(head.bins >= 0 && head.binSize() > 0.0);
    std::vector<std::uint8_t> levels;
    levels.reserve(static_cast<std::size_t>(head.bins));
    Scene scene(scenario, seed, head, std::max(time_s, 0.0));
    const double absorption = acoustics::absorption(head.frequency_hz);
    const double gain_db = scenario.gain_db + (head.gain_db - usual_head.gain_db);
    const double pulse_m = 0.5e-6 * scenario.pulse_us * head.sound_speed;
    const auto grain =
        speckle(seed, number, head.bins, scenario.looks, std::min(pulse_m / head.binSize(), most_pulse_bins));
    for (int i = 0; i < head.bins; ++i) {
        const double range_m = (i + 0.5) * head.binSize();
        const double loss_db = 40.0 * std::log10(range_m) + 2.0 * absorption * range_m;
        const double power = scene.powerAt(range_m, loss_db) * grain[static_cast<std::size_t>(i)];
        const double uncompensated_db = std::max(loss_db - most_compensation_db, 0.0);
        const double echo_db = decibels(power) - uncompensated_db - level_zero_db + gain_db;
        const double ring_db = full_scale_db * (1.0 - range_m / ring_down_m);  // the same for every ping
        const double level_db = decibels(powerOf(echo_db) + powerOf(ring_db));
        levels.push_back(
            static_cast<std::uint8_t>(std::lround(std::clamp(level_db, 0.0, full_scale_db) * levels_per_db)));
    }
    return levels;
}

HeadSetup headSetup(const Scenario& scenario, std::uint64_t number) {
    HeadSetup head;
    head.range_m = scenario.range_m;
    head.bin_interval_s = 2.0 * scenario.range_m / head.sound_speed / head.bins;
    head.bearing = pingBearing(scenario, number);
    head.step_rad = radiansFromDegrees(scenario.step_deg);
    head.frequency_hz = 1000.0 * scenario.frequency_khz;
    return head;
}

Ping simulatePing(const Scenario& scenario, std::uint64_t seed, std::uint64_t number) {
    return simulatePing(scenario, seed, number, headSetup(scenario, number), sweepOf(scenario, number).clockwise());
}

Ping simulatePing(const Scenario& scenario, std::uint64_t seed, std::uint64_t number, const HeadSetup& head,
                  bool clockwise) {
    const double ping_s = pingTime(scenario, number);
    return {.sequence = number,
            .time = simulation_start + microsecondsFromSeconds(ping_s),
            .bearing = head.bearing,
            .step_rad = head.step_rad,
            .range_scale_m = head.range_m,
            .bin_interval_s = head.bin_interval_s,
            .sound_speed_mps = head.sound_speed,
            .frequency_hz = head.frequency_hz,
            .gain_percent = head.gain_db / gain_db_per_percent,
            .clockwise = clockwise,
            .levels = simulateEcho(scenario, seed, head, ping_s, number)};
}

}  // namespace echotrail
