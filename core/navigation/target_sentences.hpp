#pragma once

#include "core/data/track.hpp"
#include "core/navigation/sentences.hpp"

#include <string>

namespace echotrail {

/// A tracked target as an NMEA 0183 (4.10) TTM sentence, with checksum and line end: number (of two digits), distance
/// in km, bearing relative to the bow (degrees, R), speed (km/h) and true course, closest approach in km, minutes until
/// then (negative ones are not sent), units K, no name, and Q (query: tentative or coasting), T (tracking) or L (lost).
std::string ttmSentence(const TrackLook& look, double closest_approach_m, double time_to_closest_s);

/// The same target as a TLL sentence: number (of two digits), latitude and longitude in degrees and minutes, no name,
/// UTC of the position, and L, Q or T as above.
std::string tllSentence(const TrackLook& look, const GeographicPosition& position);

}  // namespace echotrail
