#pragma once

#include "core/base/result.hpp"
#include "core/data/pose.hpp"

#include <cstdint>
#include <map>
#include <string>

namespace echotrail {

/// What a file of NMEA lines says about where the vehicle was.
struct NavigationFile {
    /// Origin at the first position used. A sample at every time of a heading or a position that lies within both
    /// series, the other interpolated (the heading the short way round); nothing is extended beyond its data.
    PoseHistory poses;
    std::map<std::string, std::uint64_t> used;      ///< by sentence, e.g. "HDT": what `poses` is made of
    std::map<std::string, std::uint64_t> unused;    ///< by sentence: good but not needed, or of no kind used here
    std::map<std::string, std::uint64_t> rejected;  ///< by cause, see `nmea_cause`
    double longest_heading_gap_s = 0.0;             ///< between neighbours in `used`
    double longest_position_gap_s = 0.0;            ///< likewise, of fixes or of speeds; 0 with headings only
    /// For a person: "heading (HDT) and position (RMC)", "heading (HDT), position reckoned from speed (VTG)",
    /// "heading only (HDG, magnetic)".
    std::string mode;
};

/// Reads lines of NMEA 0183, each after a TAG block with its time (see `parseNmeaLine`); the times are those of the
/// TAG blocks alone. Heading: HDT, or HDG where there is no HDT. Position: RMC or GGA, whichever has more fixes;
/// with fewer than two fixes, VTG or VBW (whichever has more) integrated by trapezoids from (0, 0); otherwise (0, 0)
/// throughout. One kind is used of each, because two instruments' offsets would make the vehicle jump to and fro.
/// Within a kind a sentence not later than the one before is rejected. Bad lines are counted and passed over.
/// Fails, with one line to be shown, when the file cannot be opened, holds no heading (without which a sonar's
/// bearings cannot be laid out), or its headings and positions have no time in common.
Result<NavigationFile> readNavigationFile(const std::string& path);

}  // namespace echotrail
