#pragma once

#include "core/base/angles.hpp"

/// The laws of sound that the simulation is made of (method card, section i). Levels in dB, powers relative to 1.
namespace echotrail::acoustics {

double powerOf(double db);
double decibels(double power);

/// Absorption in dB per metre (Ainslie and McColm, JASA 103(3), 1998).
struct Water {
    double temperature_c = 15.0;
    double salinity_psu = 35.0;
    double acidity_ph = 8.0;
    double depth_m = 0.0;
};
double absorption(double frequency_hz, const Water& water = {});

/// A transducer's lobe: Gaussian to either side, widths between the points of half power of one way.
struct Lobe {
    double width_rad = radiansFromDegrees(3.0);
    double height_rad = radiansFromDegrees(20.0);
    /// One-way power at an angle off the axis.
    double across(double off_axis_rad) const;
    double above(double off_axis_rad) const;
    /// Widths of the two-way lobe as one rectangle: 0.753 of those at half power.
    double integralWidth() const;
    double integralHeight() const;
};
/// Of the SeaKing DFS: 3° by 20° below 500 kHz, 1.5° by 40° from there on.
Lobe lobeAt(double frequency_hz);

/// Power of both ways; side lobes let nothing fall below −45 dB.
double twoWay(double transmit, double receive);

/// Noise in the receiver's band in dB re 1 µPa: −15 + 20 log f(kHz) + 10 log(100 kHz) − 28 dB of directivity.
double noiseLevel(double frequency_hz);

/// Strength in dB of a corner reflector with edges of `edge_m` on its axis: the lesser of its far field (triangular
/// faces) and of a mirror image at that range, less 10 dB for bent faces and what goes through them.
double reflectorStrength(double edge_m, double range_m, double frequency_hz, double sound_speed_mps);

/// A flat boundary `distance_m` above or below the head, as a patch of `bin_m` in range scatters it: Lambert's law with
/// `strength_db` per square metre. Nothing nearer than the distance. With `low_grazing_floor` no angle scatters less
/// than 6° would: what was measured at lower ones is mixed.
double boundaryPower(const Lobe& lobe, double range_m, double bin_m, double distance_m, double strength_db,
                     bool low_grazing_floor);

/// What the water itself scatters: −75 dB per cubic metre in the lobe.
double volumePower(const Lobe& lobe, double range_m, double bin_m);

}  // namespace echotrail::acoustics
