#include "core/simulation/echo_model.hpp"

#include "core/base/random.hpp"
#include "core/data/ping.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace echotrail {

namespace {

using acoustics::decibels;
using acoustics::powerOf;

constexpr HeadSetup usual_head;
constexpr double source_level_db = 205.0;
constexpr double most_compensation_db = 80.0;  // of the receiver's time-varied gain
constexpr double level_zero_db = -60.0;        // the scatterer that gives level 0 at 0 dB gain
constexpr double ring_down_m = 1.0;            // the transducer rings from full scale to nothing in this range
constexpr double most_pulse_bins = 256.0;      // a longer pulse would cost time and show nothing new
constexpr std::uint64_t speckle_numbers = 1;
constexpr double farthest_deviations = 7.0;  // beyond so many of its deviations nothing is left of an object's echo
// An echo this far above the ring is not changed by it, but for rounding.
constexpr double ring_is_gone_db = 160.0, rounding_levels = 1e-6;

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

/// Level of an echo together with the ring-down. The ring's power is added only where that can matter: two of the
/// three transcendental functions of a bin are saved, and the level is the same.
std::uint8_t levelOf(double echo_db, double ring_db) {
    const auto levels = [](double db) { return std::clamp(db, 0.0, full_scale_db) * levels_per_db; };
    if (echo_db - ring_db > ring_is_gone_db) {
        const double level = levels(echo_db);
        const double from_half = std::abs(level - std::floor(level) - 0.5);
        if (from_half > rounding_levels) return static_cast<std::uint8_t>(std::lround(level));
    }
    return static_cast<std::uint8_t>(std::lround(levels(decibels(powerOf(echo_db) + powerOf(ring_db)))));
}

bool hearAlike(const HeadSetup& a, const HeadSetup& b) {
    return a.bins == b.bins && a.binSize() == b.binSize() && a.frequency_hz == b.frequency_hz;
}

}  // namespace

EchoModel::EchoModel(const Scenario& scenario, std::uint64_t seed)
    : scenario_(scenario), seed_(seed), debris_(allDebris(scenario, seed)), ground_(scenario_, seed) {}

std::vector<std::uint8_t> EchoModel::echo(const HeadSetup& head, double time_s, std::uint64_t number) {
    assert(head.bins >= 0 && head.binSize() > 0.0);
    time_s = std::max(time_s, 0.0);
    if (!head_ || !hearAlike(*head_, head)) layTable(head);
    const VehicleState vehicle = vehicleState(scenario_, time_s);
    const ObjectEchoes objects = objectEchoes(scenario_, debris_, seed_, head, time_s);
    addBottom(head, vehicle, objects);
    addObjects(objects);

    const double gain_db = scenario_.gain_db + (head.gain_db - usual_head.gain_db);
    const double pulse_m = 0.5e-6 * scenario_.pulse_us * head.sound_speed;
    const auto grain =
        speckle(seed_, number, head.bins, scenario_.looks, std::min(pulse_m / head.binSize(), most_pulse_bins));
    std::vector<std::uint8_t> levels(table_.range_m.size());
    for (std::size_t i = 0; i < levels.size(); ++i) {
        // Mean power, as a scatterer's strength, of all that the transmission meets.
        const double power =
            (bottom_here_[i] + table_.surface[i] + table_.volume[i] + objects_here_[i] + table_.noise[i]) * grain[i];
        const double echo_db = decibels(power) - table_.uncompensated_db[i] - level_zero_db + gain_db;
        levels[i] = levelOf(echo_db, table_.ring_db[i]);
    }
    return levels;
}

void EchoModel::layTable(const HeadSetup& head) {
    head_ = head;
    lobe_ = acoustics::lobeAt(head.frequency_hz);
    altitude_m_ = -1.0;
    table_ = {};
    const double depth_m = vehicleState(scenario_, 0.0).depth_m;  // the vehicle keeps it
    const double absorption = acoustics::absorption(head.frequency_hz);
    const double noise_db = acoustics::noiseLevel(head.frequency_hz) - source_level_db;
    for (int i = 0; i < head.bins; ++i) {
        const double range_m = (i + 0.5) * head.binSize();
        // Spreading and absorption of both ways.
        const double loss_db = 40.0 * std::log10(range_m) + 2.0 * absorption * range_m;
        table_.range_m.push_back(range_m);
        table_.surface.push_back(acoustics::boundaryPower(lobe_, range_m, head.binSize(), depth_m,
                                                          scenario_.surface_strength_db, scenario_.low_grazing_floor));
        table_.volume.push_back(acoustics::volumePower(lobe_, range_m, head.binSize()));
        table_.noise.push_back(powerOf(noise_db + loss_db));
        table_.uncompensated_db.push_back(std::max(loss_db - most_compensation_db, 0.0));
        table_.ring_db.push_back(full_scale_db * (1.0 - range_m / ring_down_m));  // the same for every ping
    }
}

void EchoModel::layBottom(double altitude_m) {
    altitude_m_ = altitude_m;
    bottom_.resize(table_.range_m.size());
    for (std::size_t i = 0; i < bottom_.size(); ++i)
        bottom_[i] = acoustics::boundaryPower(lobe_, table_.range_m[i], head_->binSize(), altitude_m,
                                              scenario_.bottom_strength_db, scenario_.low_grazing_floor);
}

void EchoModel::addBottom(const HeadSetup& head, const VehicleState& vehicle, const ObjectEchoes& objects) {
    if (vehicle.altitude_m != altitude_m_) layBottom(vehicle.altitude_m);
    GroundAlongBeam ground(ground_, vehicle.pose, vehicle.pose.heading + head.bearing.inRadians(), vehicle.altitude_m,
                           lobe_);
    bottom_here_.resize(bottom_.size());
    for (std::size_t i = 0; i < bottom_.size(); ++i) bottom_here_[i] = bottom_[i] * ground.at(table_.range_m[i]);
    for (const Shadow& shadow : objects.shadows)
        for (std::size_t i = 0; i < bottom_.size(); ++i)
            if (table_.range_m[i] > shadow.near_m && table_.range_m[i] < shadow.far_m)
                bottom_here_[i] *= 1.0 - shadow.share;
}

void EchoModel::addObjects(const ObjectEchoes& objects) {
    objects_here_.assign(table_.range_m.size(), 0.0);
    const double bin_m = head_->binSize();
    const auto last = static_cast<double>(table_.range_m.size());
    for (const PointEcho& echo : objects.echoes) {
        const double reach_m = farthest_deviations * echo.deviation_m;
        const auto binAt = [&](double range_m) {
            return static_cast<std::size_t>(std::clamp(range_m / bin_m, 0.0, last));
        };
        // Two bins more than needed, so that rounding takes none away.
        for (std::size_t i = binAt(echo.range_m - reach_m - bin_m); i < binAt(echo.range_m + reach_m + 2.0 * bin_m);
             ++i) {
            const double off = (table_.range_m[i] - echo.range_m) / echo.deviation_m;
            if (std::abs(off) < farthest_deviations) objects_here_[i] += echo.power * std::exp(-off * off / 2.0);
        }
    }
}

}  // namespace echotrail
