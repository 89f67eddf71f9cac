#pragma once

#include "core/data/track.hpp"
#include "core/tracking/target_report.hpp"

#include <nlohmann/json.hpp>

namespace echotrail {

/// A line of the tracks file: the fields' names are fixed, other programs read them. `t` counts from the first ping.
nlohmann::ordered_json trackLine(const TrackLook& look, Timestamp first_ping);

/// The same of a report to a motion controller, with what only that has.
nlohmann::ordered_json reportLine(const TargetReport& report, Timestamp first_ping);

}  // namespace echotrail
