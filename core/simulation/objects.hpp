#pragma once

#include "core/simulation/head_setup.hpp"
#include "core/simulation/scenario.hpp"

#include <cstdint>
#include <vector>

namespace echotrail {

/// Something small as one ping meets it.
struct PointEcho {
    double range_m = 0.0;
    double deviation_m = 0.0;  ///< of its Gaussian echo in range
    double power = 0.0;        ///< target strength, the lobe and the present scintillation
};

/// Ranges in which an object hides a part of the bottom.
struct Shadow {
    double near_m = 0.0;
    double far_m = 0.0;
    double share = 0.0;  ///< 0 … 1 of the lobe
};

struct ObjectEchoes {
    std::vector<PointEcho> echoes;
    std::vector<Shadow> shadows;
};

/// What targets, their ghosts and wakes, and debris give to a transmission at `time_s` ≥ 0. Ranges are those of the
/// moment of the echo; the lobe turns with the vehicle between transmission and reception.
ObjectEchoes objectEchoes(const Scenario& scenario, std::uint64_t seed, const HeadSetup& head, double time_s);
/// The same with allDebris() at hand.
ObjectEchoes objectEchoes(const Scenario& scenario, const std::vector<Debris>& debris, std::uint64_t seed,
                          const HeadSetup& head, double time_s);

/// Whether the two-way lobe, between its points of half power of one way, is on a target.
bool beamIsOn(const Scenario& scenario, const SimulatedTarget& target, const HeadSetup& head, double time_s);

}  // namespace echotrail
