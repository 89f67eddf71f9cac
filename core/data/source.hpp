#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/data/ping.hpp"
#include "core/data/pose.hpp"

namespace echotrail {

/// Where pings come from, for a person to read.
struct SourceInfo {
    std::string name;                ///< file name or scenario
    std::string format;              ///< "Seanet Pro V4LOG", "raw Seanet byte stream", "simulation"
    std::string head;                ///< e.g. "SeaKing DFS, node 2, 325 kHz"
    Timestamp start{};               ///< of the first ping
    Timestamp end{};                 ///< of the last ping
    std::uint64_t pings = 0;
    double range_scale_m = 0.0;      ///< of the first ping
    double sound_speed_mps = 0.0;
    std::vector<std::string> notes;  ///< what the reader should know, e.g. that the times are rebuilt
};

/// What was not as it should be. Causes are short words: "bad_length", "no_line_feed", "cut_record", …
struct SourceCounts {
    std::map<std::string, std::uint64_t> rejected;  ///< cause → frames, records or messages that were refused
    std::map<std::string, std::uint64_t> ignored;   ///< message name → well-formed ones that carry no ping
    std::uint64_t skipped_bytes = 0;                ///< not part of any whole frame
    std::uint64_t lost_records = 0;                 ///< whole lines known or presumed lost; not 0 means exit code 3
};

/// What the operator did during a run: it takes effect before the ping that follows it.
struct RunControl {
    enum class Kind { Parameters, Designation, ClearDesignation, Drop, Restore };
    Kind kind = Kind::Parameters;
    std::string parameters;  ///< TOML text of all parameters
    double range_m = 0.0;    ///< of the designated place or the dropped track, from the head
    Bearing from_bow;
    int track = 0;           ///< that is dropped or taken back
    bool operator==(const RunControl&) const = default;
};

/// How the run was set that a recording was made in.
struct RecordedRun {
    std::uint64_t seed = 0;
    std::string parameters;  ///< TOML text of all parameters
};

/// A recording or a simulation, ping by ping, in time order.
/// State: next() walks forward; rewind() starts again and then gives the same pings.
class PingSource {
public:
    virtual ~PingSource() = default;
    virtual std::optional<Ping> next() = 0;
    virtual void rewind() = 0;
    virtual const SourceInfo& info() const = 0;
    /// What has been met since the last rewind().
    virtual SourceCounts counts() const = 0;
    /// The vehicle's poses, over the whole source or as far as the last ping needs them; empty where it holds no
    /// navigation.
    virtual const PoseHistory& navigation() const = 0;
    /// Only of a recording of our own.
    virtual std::optional<RecordedRun> recordedRun() const { return std::nullopt; }
    /// What takes effect before the ping that next() gave last, in order; each is given once.
    virtual std::vector<RunControl> takeControls() { return {}; }
};

}  // namespace echotrail
