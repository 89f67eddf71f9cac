#pragma once

#include "core/data/fan_image.hpp"
#include "core/data/ping.hpp"
#include "core/data/source.hpp"
#include "core/data/update.hpp"
#include "core/imaging/echo_memory.hpp"
#include "core/navigation/local_plane.hpp"
#include "core/runtime/paths.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace echotrail {

struct BeamLine;

/// Everything the eye needs at one moment, copied from the pipeline at the display's pace: a picture may be skipped.
struct Scene {
    std::uint64_t position = 0;  ///< pings taken in so far
    Update latest;               ///< what the last ping brought about
    Ping ping;                   ///< the last echo line
    FanImage fan;                ///< own copy
    double picture_age_s = 0.0;  ///< from the last echo line in `fan` to the last ping, which may have come without one
    FanImage enhanced;           ///< local enhancement of `fan`; empty unless asked for
    std::vector<Region> regions;  ///< of the last full turn of the beam
    std::vector<Track> tracks;
    double sweep_s = 0.0;  ///< duration of the last whole sweep; 0 before there was one
    Bearing sector_left;   ///< bearings from the bow reached by the last sweep
    Bearing sector_right;
    bool turns_clockwise = true;  ///< seen from above, whatever the head says of itself
    /// The last echo line at each bearing from the bow, as far as there was one; 1°, from −180° on.
    std::vector<std::shared_ptr<const BeamLine>> lines;
    std::shared_ptr<const BeamLine> live_line;           ///< of the last ping; null before it
    std::shared_ptr<const RememberedEchoes> remembered;  ///< null before the first sweep's end
    std::shared_ptr<const Paths> paths;                  ///< null before the first ping
    std::optional<Bearing> course;                       ///< of the vehicle, from north; none where it lies still
    std::optional<LocalPlane> plane;                     ///< the local frame on the earth, where a fix was had
    SourceCounts counts;
    double microseconds_per_ping = 0.0;  ///< processor time of the pipeline, recent mean
    bool navigation_known = false;       ///< poses are measured, not assumed
    bool at_end = false;
};

}  // namespace echotrail
