#pragma once

#include "core/base/time.hpp"

#include <chrono>
#include <cstdint>
#include <vector>

namespace echotrail {

/// What reached the core, and what left it. The numbers are stored in recordings: they never change their meaning.
enum class EventKind : std::uint8_t {
    SonarBytes = 1,       ///< from the head, as they were read
    NavigationBytes = 2,  ///< NMEA 0183 text, as it was read
    SentBytes = 3,        ///< to the head
    SonarLink = 4,        ///< text: the link to the head was made or broke, so that a frame begun is over
    NavigationLink = 5,   ///< the same of the navigation
    Parameters = 6,       ///< text: a parameter file (TOML) of all parameters, in force from here
    Designation = 7,      ///< text: "range_m bearing_deg" of the operator's pick, or nothing: taken back
    Skip = 8,             ///< text: sequence number of a ping that the tracker could not take in time
    Annotation = 9,       ///< text: a remark of the operator
    Drop = 10,            ///< text: "id range_m bearing_deg" of a track nobody wants to see, or "id": taken back
};

/// One of the numbered events that are all the core ever sees: recorded in this order, replayed in this order.
struct Event {
    std::uint64_t number = 0;  ///< counts from 0 within a run
    EventKind kind = EventKind::SonarBytes;
    Timestamp utc{};                         ///< when it reached the program
    std::chrono::microseconds monotonic{0};  ///< the same by a clock that never jumps, since the run's start
    std::vector<std::uint8_t> payload;       ///< bytes, or UTF-8 text
    bool operator==(const Event&) const = default;
};

}  // namespace echotrail
