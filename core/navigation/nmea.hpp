#pragma once

#include "core/base/result.hpp"
#include "core/base/time.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace echotrail {

/// Why a line or a sentence was rejected: the names the counts go by.
namespace nmea_cause {
inline constexpr std::string_view malformed = "malformed";        ///< not the shape of a TAG block and a sentence
inline constexpr std::string_view bad_checksum = "bad_checksum";  ///< of the TAG block or of the sentence
inline constexpr std::string_view no_checksum = "no_checksum";    ///< nothing vouches for the bytes
inline constexpr std::string_view no_time = "no_time";            ///< no TAG block with a time
inline constexpr std::string_view bad_field = "bad_field";        ///< missing, not a number, or out of its limits
inline constexpr std::string_view not_valid = "not_valid";        ///< the instrument itself says so
inline constexpr std::string_view out_of_order = "out_of_order";  ///< not later than the last of its kind
}  // namespace nmea_cause

/// One sentence whose checksums were right.
struct NmeaSentence {
    std::string id;                   ///< without the talker, e.g. "HDT"; of a proprietary one the whole address
    std::vector<std::string> fields;  ///< after the address, possibly empty texts
    std::optional<Timestamp> time;    ///< of the TAG block, where there is one

    /// The field at `index` counted from 0, or an empty text.
    std::string_view field(std::size_t index) const {
        return index < fields.size() ? std::string_view(fields[index]) : std::string_view();
    }
};

/// Reads one line of NMEA 0183 (version 4.10), with or without its end of line: `$ttSSS,…*hh` or `!ttSSS,…*hh`,
/// optionally after one TAG block `\c:1274601600079*66\` whose `c` is UTC in milliseconds (13 digits) or seconds
/// (10 digits) since 1970. A checksum is the exclusive or of the characters before its `*`.
/// Any bytes of any length may be given. The error is one of `nmea_cause`.
Result<NmeaSentence> parseNmeaLine(std::string_view line);

/// The other way round: a body such as "HEHDT,0.2,T" with its `$`, checksum and end of line.
std::string nmeaSentence(std::string_view body);

}  // namespace echotrail
