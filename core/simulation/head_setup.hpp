#pragma once

#include "core/base/angles.hpp"

namespace echotrail {

/// How a head is set for one transmission: what its commands ask of it.
struct HeadSetup {
    double range_m = 50.0;
    int bins = 800;
    double bin_interval_s = 2.0 * 50.0 / 1490.0 / 800;  ///< two-way time from bin to bin
    Bearing bearing;                                    ///< of the beam, from the head's zero: the bow
    double step_rad = radiansFromDegrees(1.8);
    double frequency_hz = 325e3;
    double gain_db = 32.0;   ///< initial gain, 0…80 dB; a scenario's own gain is meant for 32 dB (40 %)
    double ad_low_db = 0.0;  ///< the window that 4-bit levels are packed in; the echo itself is made without it
    double ad_span_db = 80.0;
    int bits = 8;
    double sound_speed = 1490.0;  ///< m/s

    double binSize() const { return sound_speed * bin_interval_s / 2.0; }  ///< in metres
};

}  // namespace echotrail
