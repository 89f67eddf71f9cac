#include "core/simulation/acoustics.hpp"

#include "core/base/angles.hpp"

#include <algorithm>
#include <cmath>

namespace echotrail {

namespace {

constexpr double two_way_integral = 0.753;  // width of a beam's two-way pattern over its half-power width
constexpr double source_level_db = 205.0, directivity_db = 28.0, bandwidth_hz = 100e3, volume_db_per_m3 = -75.0;

double powerOf(double decibels) { return std::pow(10.0, decibels / 10.0); }

}  // namespace

Beam beamOf(Channel channel) {
    if (channel == Channel::Low) return {325e3, radiansFromDegrees(3.0), radiansFromDegrees(20.0)};
    return {675e3, radiansFromDegrees(1.5), radiansFromDegrees(40.0)};
}

double beamGain(double angle_rad, double width_rad) {
    const double u = 2.0 * angle_rad / width_rad;
    return std::exp2(-u * u);
}

double absorptionPerMetre(double frequency_hz) {
    constexpr double celsius = 15.0;
    const double f2 = (frequency_hz / 1e3) * (frequency_hz / 1e3);
    const double boron = 0.78 * std::exp(celsius / 26.0), magnesium = 42.0 * std::exp(celsius / 17.0);
    const double per_km = 0.106 * boron * f2 / (boron * boron + f2) +
                          0.52 * (1.0 + celsius / 43.0) * magnesium * f2 / (magnesium * magnesium + f2) +
                          0.00049 * f2 * std::exp(-celsius / 27.0);
    return per_km / 1e3;
}

double wayLoss(double range_m, double absorption_db_per_m) {
    return 40.0 * std::log10(range_m) + 2.0 * absorption_db_per_m * range_m;
}

double cornerReflectorStrength(double edge_m, double range_m, double wavelength_m) {
    const double far_field = 20.0 * std::log10(edge_m * edge_m / std::sqrt(3.0) / wavelength_m);
    return std::min(far_field, 20.0 * std::log10(range_m / 2.0));
}

double planeBackscatter(double strength_db, double height_m, double range_m, double bin_m, const Beam& beam) {
    if (range_m < height_m) return 0.0;
    const double sine = height_m / range_m;
    const double cosine = std::max(std::sqrt(1.0 - sine * sine), 0.1);  // straight below the strip has no end
    const double upright = beamGain(std::asin(sine), beam.upright_rad);
    const double two_way = std::max(upright * upright, powerOf(two_way_floor_db));
    const double strip_m2 = two_way_integral * beam.across_rad * range_m * bin_m / cosine;
    return powerOf(strength_db) * sine * sine * strip_m2 * two_way;
}

double volumeBackscatter(double range_m, double bin_m, const Beam& beam) {
    return powerOf(volume_db_per_m3) * two_way_integral * beam.across_rad * beam.upright_rad * range_m * range_m *
           bin_m;
}

double noisePower(double range_m, double absorption_db_per_m, const Beam& beam) {
    const double noise_db =
        -15.0 + 20.0 * std::log10(beam.frequency_hz / 1e3) + 10.0 * std::log10(bandwidth_hz) - directivity_db;
    return powerOf(noise_db - source_level_db + wayLoss(range_m, absorption_db_per_m));
}

}  // namespace echotrail
