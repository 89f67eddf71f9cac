#pragma once

#include "core/base/result.hpp"
#include "core/data/source.hpp"
#include "core/recording/log_format.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace echotrail {

/// Writes a source's pings, up to `end`, to a new log, as a live run would have: each as the bytes of a head's line, at
/// the moment they would have arrived. The log's pings are the source's, with their times; bin interval, step and
/// bearing to a head's resolution. `navigation` holds NMEA 0183 text with its time of arrival, in order.
/// Gives the number of pings; fails where the log cannot be written.
Result<std::uint64_t> writePingLog(const std::string& path, const LogHeader& header, PingSource& source,
                                   std::optional<Timestamp> end = {},
                                   const std::vector<std::pair<Timestamp, std::string>>& navigation = {});

}  // namespace echotrail
