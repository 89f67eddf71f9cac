#pragma once

#include "core/base/parameters.hpp"
#include "core/data/head_settings.hpp"
#include "core/data/log_rows.hpp"
#include "core/data/ping.hpp"
#include "core/data/source.hpp"
#include "core/data/update.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

/// What goes over the link, as plain values; the messages are described in link.proto.
namespace echotrail {

/// Who one is, for the other side to read.
struct LinkIdentity {
    std::string name, program;
};

/// One echo line and where it was: all that the picture is painted from.
struct LinkBeam {
    Ping ping;           ///< its levels may be thinned (then its bins are longer), or left out
    Update update;       ///< of that ping, without regions and looks
    HeadSettings mount;  ///< of which the mounting counts
    Timestamp first_ping{};
    bool navigation_known = false;
};

using NamedValue = std::pair<std::string, ParameterValue>;

/// Parameters as they are in force.
struct LinkParameters {
    std::uint64_t revision = 0;
    std::vector<NamedValue> values;
    bool operator==(const LinkParameters&) const = default;
};

/// Who commands; numbers of consoles, 0 is nobody.
struct LinkControl {
    std::uint32_t holder = 0;
    std::string holder_name;
    std::uint32_t asking = 0;
    std::string asking_name;
    bool operator==(const LinkControl&) const = default;
};

struct LinkEnd {
    bool up = false;
    std::string reason;           ///< why it is down, one line
    std::optional<double> age_s;  ///< since the last bytes
    bool operator==(const LinkEnd&) const = default;
};

/// How the tracker is, for a person to read. Numbers are since its start.
struct LinkHealth {
    Timestamp time{};
    LinkEnd sonar;
    std::optional<LinkEnd> navigation;  ///< none where none was asked for
    std::uint32_t head_state = 0;       ///< as link.proto lists them
    std::string head, head_advice, head_difference;
    std::vector<NamedValue> head_confirmed;  ///< what the head says it does; empty before it has
    std::uint64_t head_pings = 0, head_timeouts = 0, head_retries = 0, head_resets = 0, head_rejected = 0;
    std::uint64_t pings = 0, skipped = 0, sweeps = 0, confirmed = 0, without_pose = 0;
    SourceCounts counts;
    std::uint64_t queued = 0;
    double lag_s = 0.0, processing_s = 0.0;
    std::optional<Timestamp> last_ping;
    std::string heading_kind, position_kind;
    std::optional<Timestamp> heading_time;
    std::optional<Bearing> heading;
    bool recording = false;
    std::string log_path, log_error;
    std::uint64_t log_bytes = 0, free_bytes = 0, unsaved = 0;
    std::uint32_t disk = 0;  ///< 0 good, 1 low, 2 full
    std::uint32_t consoles = 0;
    double microseconds_per_ping = 0.0;
};

struct LinkLog {
    enum class Weight { Note, Warning, Alarm };
    Timestamp time{};
    Weight weight = Weight::Note;
    std::string text;
    bool operator==(const LinkLog&) const = default;
};

/// What one ping brought about aboard.
struct LinkMoment {
    Timestamp time{};
    std::optional<LinkBeam> beam;
    std::vector<Region> regions;
    std::vector<Track> tracks;  ///< all that live, with particles and histories
    std::vector<TrackLook> looks;
};

/// Where a tracker sends and takes datagrams, and the key under which they are sealed.
struct LinkDatagrams {
    std::uint16_t port = 0;
    std::uint64_t session = 0;
    std::string key;
};

// What a console hears, in the order it came.

struct LinkWelcome {
    std::uint32_t version = 0;
    LinkIdentity tracker;
    std::vector<std::string> capabilities;
    std::uint32_t console = 0;  ///< this one's number
    std::uint64_t run = 0;
    std::optional<LinkDatagrams> datagrams;  ///< none where there are none
};
/// All that holds: what was known before is forgotten.
struct LinkSnapshot {
    LinkParameters parameters;
    LinkControl control;
    LinkHealth health;
    std::vector<Track> tracks;
    std::optional<Timestamp> first_ping;
    std::vector<LinkLog> log;
};
struct LinkRegions {
    std::vector<Region> regions;
};
struct LinkTracks {
    std::vector<Track> tracks;  ///< new and changed ones, without histories and particles
    std::vector<TrackLook> looks;
    std::vector<int> gone;
};
struct LinkClouds {
    std::vector<std::pair<int, ParticleCloud>> clouds;  ///< by track
};
struct LinkReply {
    std::uint32_t request = 0;
    bool done = false;
    std::string reason;
};

/// One recording of the list.
struct LinkRecordingEntry {
    std::string name;
    std::uint64_t bytes = 0;
    Timestamp changed{};
    bool written = false;  ///< by the run that answers
    bool operator==(const LinkRecordingEntry&) const = default;
};
/// The newest first.
struct LinkRecordings {
    std::uint32_t request = 0;
    std::vector<LinkRecordingEntry> entries;
};
struct LinkRecording {
    std::uint32_t request = 0;
    std::string name;
    LogDescription log;
};
struct LinkRows {
    std::uint32_t request = 0;
    LogRows rows;
};

using LinkEvent =
    std::variant<LinkWelcome, LinkSnapshot, LinkBeam, LinkRegions, LinkTracks, LinkClouds, LinkHealth, LinkLog,
                 LinkControl, LinkParameters, LinkReply, LinkRecordings, LinkRecording, LinkRows>;

// What a console asks for, once it has been found sound and allowed.

struct LinkSetParameters {
    std::vector<NamedValue> values;
};
struct LinkDesignate {
    double range_m = 0.0;
    Bearing from_bow;
};
struct LinkClearDesignation {};
struct LinkDrop {
    int track = 0;
    double range_m = 0.0;
    Bearing from_bow;
};
struct LinkRestore {
    int track = 0;
};
struct LinkAnnotate {
    std::string text;
};

struct LinkRequest {
    std::uint32_t console = 0, request = 0;
    std::string name;  ///< of the console
    std::variant<LinkSetParameters, LinkDesignate, LinkClearDesignation, LinkDrop, LinkRestore, LinkAnnotate> content;
};

/// The capability that a tracker names where consoles may read its recordings.
inline constexpr const char* link_recordings = "recordings";

// What a console asks for of the recordings aboard; anybody who was let in may.

struct LinkListRecordings {};
struct LinkDescribeRecording {
    std::string recording;  ///< a name of the list; empty: the one that is being written
};
struct LinkReadRows {
    std::string recording;
    LogRowsWanted rows;
};

struct LinkRecordRequest {
    std::uint32_t console = 0, request = 0;
    std::variant<LinkListRecordings, LinkDescribeRecording, LinkReadRows> content;
};

/// Its answer; whoever answers leaves the requests' numbers to the link.
using LinkRecordAnswer = std::variant<LinkRecordings, LinkRecording, LinkRows>;

enum class ControlAction { Ask = 1, Give = 2, Keep = 3, Take = 4 };

}  // namespace echotrail
