#pragma once

#include "core/simulation/simulated_source.hpp"

#include <string>

namespace echotrail {

/// Ground truth as CSV, a line for every ping and target: t,target,north_m,east_m,velocity_north_mps,velocity_east_mps,
/// visible. `t` is in seconds since the first ping; places are true ones, in the local frame, whatever navigation
/// says of the vehicle.
std::string truthCsv(const SimulatedSource& source);

/// The same as seen from the head: t,target,range_m,bearing_deg,visible. It holds whatever navigation does.
std::string truthFromHeadCsv(const SimulatedSource& source);

}  // namespace echotrail
