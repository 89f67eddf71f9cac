#pragma once

#include "core/data/head_settings.hpp"

namespace echotrail {

/// Sound in water, echoes and the head's beams. Levels in decibels, ranges in metres; powers are relative to an echo
/// of target strength 0 dB, so a power of 1 is what a 0 dB point target on the axis gives.

/// Beam of a transducer: full widths between half-power points, in radians.
struct Beam {
    double frequency_hz = 0.0;
    double across_rad = 0.0;
    double upright_rad = 0.0;
};

/// SeaKing: 325 kHz 3° × 20°, 675 kHz 1.5° × 40°.
Beam beamOf(Channel channel);

/// Power gain at `angle` off the axis, one way: Gaussian, 2^−(2 angle / width)².
double beamGain(double angle_rad, double width_rad);

/// Absorption of sea water at 15 °C, salinity 35, pH 8, near the surface, in dB per metre (Ainslie & McColm 1998).
double absorptionPerMetre(double frequency_hz);

/// 40 log r + 2 α r: what the way there and back takes, and what the receiver's time-varied gain gives back.
double wayLoss(double range_m, double absorption_db_per_m);

/// Corner reflector with triangular faces of the given edge: far-field 20 log(edge² / √3 λ), limited near by its mirror
/// image to 20 log(r / 2).
double cornerReflectorStrength(double edge_m, double range_m, double wavelength_m);

/// Backscatter of a plane at distance `height` (the bottom, or the surface), S0 sin²γ over the lit strip of one range
/// bin, sin γ = height / range: a power. Nothing nearer than the plane.
double planeBackscatter(double strength_db, double height_m, double range_m, double bin_m, const Beam& beam);

/// Backscatter of the water in one range bin (−75 dB per m³): a power.
double volumeBackscatter(double range_m, double bin_m, const Beam& beam);

/// Sea and receiver noise at a range, as the power of an echo that would be as loud: thermal noise in 100 kHz of
/// bandwidth, 28 dB directivity, 205 dB source level.
double noisePower(double range_m, double absorption_db_per_m, const Beam& beam);

inline constexpr double two_way_floor_db = -45.0;  ///< side lobes

}  // namespace echotrail
