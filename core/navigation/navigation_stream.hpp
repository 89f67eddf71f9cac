#pragma once

#include "core/data/pose.hpp"
#include "core/navigation/local_plane.hpp"
#include "core/navigation/sentences.hpp"

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <span>
#include <string>

namespace echotrail {

/// What a live stream of NMEA 0183 has said so far. Ages are for the reader to work out.
struct NavigationStatus {
    std::string heading_kind;                       ///< "HDT", "HDG", "HDG, magnetic"; empty before the first
    std::string position_kind;                      ///< "RMC", "GGA", "VTG", "VBW"; empty without position or speed
    std::optional<Timestamp> heading_time;          ///< of the last good one
    std::optional<Timestamp> position_time;         ///< likewise, of a fix or a speed
    std::optional<Bearing> heading;                 ///< the last one
    std::optional<double> depth_m;                  ///< of the water below the transducer, DPT or DBT
    std::optional<LocalPlane> plane;                ///< of the poses, from the first fix on
    std::map<std::string, std::uint64_t> used;      ///< by sentence
    std::map<std::string, std::uint64_t> unused;    ///< by sentence: good but not needed, or of no kind used here
    std::map<std::string, std::uint64_t> rejected;  ///< by cause, see `nmea_cause`
};

/// Bytes of NMEA 0183 as they arrive; out come poses, as soon as both heading and position reach a moment.
/// Heading: HDT; HDG until there is one. Position: fixes of the kind that came first (RMC or GGA). Speeds (of VTG or
/// VBW, whichever came first) carry it on where fixes are missing for longer than 2 s; a first fix is laid where the
/// reckoning has come to, so that nothing jumps. With headings alone the place stays (0, 0).
/// A sentence's time is that of its TAG block, or else of the read that brought its end.
/// The same bytes and times give the same poses. State: an unfinished line, the last readings, the poses
/// of the last ten minutes: a run may last for days.
class NavigationStream {
public:
    void take(Timestamp arrival, std::span<const std::uint8_t> bytes);
    /// The link was made anew: what was begun of a line is over.
    void linkChanged();

    const PoseHistory& poses() const { return poses_; }
    /// Of the latest pose.
    std::optional<Timestamp> reachedUntil() const { return reached_; }
    const NavigationStatus& status() const { return status_; }

private:
    struct TimedHeading {
        Timestamp time{};
        Bearing heading;
    };
    struct TimedPosition {
        Timestamp time{};
        LocalPosition position;
    };
    void takeLine(Timestamp arrival);
    void takeHeading(const NmeaSentence& sentence, Timestamp time);
    void takeFix(const NmeaSentence& sentence, Timestamp time);
    void takeSpeed(const NmeaSentence& sentence, Timestamp time);
    void takeDepth(const NmeaSentence& sentence);
    void reject(std::string_view cause) { ++status_.rejected[std::string(cause)]; }
    void addPosition(Timestamp time);
    void emitCovered();

    std::string line_;
    bool line_too_long_ = false;
    NavigationStatus status_;
    PoseHistory poses_;
    std::optional<Timestamp> reached_;
    // Both series from the last sample that is in poses_ on.
    std::deque<TimedHeading> headings_;
    std::deque<TimedPosition> positions_;
    std::string fix_kind_, speed_kind_;
    std::optional<Timestamp> fix_time_;
    LocalPosition place_;  ///< by fixes, carried on by speeds
    std::optional<Timestamp> place_time_;
    std::optional<LocalPosition> velocity_;  ///< m/s, at place_time_
};

}  // namespace echotrail
