#include "core/simulation/acoustics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace echotrail::acoustics {

namespace {

constexpr double integral_width = 0.753;  // of the two-way lobe, times its width at half power
constexpr double side_lobe_db = -45.0;
constexpr double volume_strength_db = -75.0;
constexpr double reflector_loss_db = 10.0;
constexpr double lowest_grazing_rad = radiansFromDegrees(6.0);

double lobe(double off_axis_rad, double width_rad) {
    const double widths = 2.0 * off_axis_rad / width_rad;
    return std::exp2(-widths * widths);
}

}  // namespace

double powerOf(double db) { return std::pow(10.0, db / 10.0); }
double decibels(double power) { return 10.0 * std::log10(power); }

double absorption(double frequency_hz, const Water& water) {
    const double f = frequency_hz / 1000.0, square = f * f, depth_km = water.depth_m / 1000.0;
    const double t = water.temperature_c, salt = water.salinity_psu / 35.0;
    const double boric = 0.78 * std::sqrt(salt) * std::exp(t / 26.0), magnesium = 42.0 * std::exp(t / 17.0);
    const double per_km =
        0.106 * boric * square / (boric * boric + square) * std::exp((water.acidity_ph - 8.0) / 0.56) +
        0.52 * (1.0 + t / 43.0) * salt * magnesium * square / (magnesium * magnesium + square) *
            std::exp(-depth_km / 6.0) +
        0.00049 * square * std::exp(-(t / 27.0 + depth_km / 17.0));
    return per_km / 1000.0;
}

double Lobe::across(double off_axis_rad) const { return lobe(off_axis_rad, width_rad); }
double Lobe::above(double off_axis_rad) const { return lobe(off_axis_rad, height_rad); }
double Lobe::integralWidth() const { return integral_width * width_rad; }
double Lobe::integralHeight() const { return integral_width * height_rad; }

Lobe lobeAt(double frequency_hz) {
    if (frequency_hz < 500e3) return {};
    return {.width_rad = radiansFromDegrees(1.5), .height_rad = radiansFromDegrees(40.0)};
}

double twoWay(double transmit, double receive) {
    static const double side_lobe = powerOf(side_lobe_db);
    return std::max(transmit * receive, side_lobe);
}

double noiseLevel(double frequency_hz) {
    constexpr double bandwidth_db = 50.0, directivity_db = 28.0;
    return -15.0 + 20.0 * std::log10(frequency_hz / 1000.0) + bandwidth_db - directivity_db;
}

double reflectorStrength(double edge_m, double range_m, double frequency_hz, double sound_speed_mps) {
    const double area_m2 = edge_m * edge_m / std::numbers::sqrt3;
    const double far_field_db = 20.0 * std::log10(area_m2 * frequency_hz / sound_speed_mps);
    const double mirror_db = 20.0 * std::log10(range_m / 2.0);
    return std::min(far_field_db, mirror_db) - reflector_loss_db;
}

double boundaryPower(const Lobe& lobe, double range_m, double bin_m, double distance_m, double strength_db,
                     bool low_grazing_floor) {
    if (range_m < distance_m) return 0.0;
    const double sine = distance_m / range_m;
    const double law = low_grazing_floor ? std::max(sine, std::sin(lowest_grazing_rad)) : sine;
    const double cosine = std::max(std::sqrt(1.0 - sine * sine), 0.1);  // straight below, the patch is not endless
    const double vertical = lobe.above(std::asin(sine));
    const double patch_m2 = lobe.integralWidth() * range_m * bin_m / cosine;
    return powerOf(strength_db) * law * law * patch_m2 * twoWay(vertical, vertical);
}

double volumePower(const Lobe& lobe, double range_m, double bin_m) {
    return powerOf(volume_strength_db) * lobe.integralWidth() * lobe.integralHeight() * range_m * range_m * bin_m;
}

}  // namespace echotrail::acoustics
