#pragma once

#include "core/base/time.hpp"
#include "core/data/track.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace echotrail {

/// Pings [begin, end) by index.
struct PingSpan {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
    bool operator==(const PingSpan&) const = default;
};

/// A recording at a glance, for a seek bar. Times are known from the start; the rest up to `analysed`.
struct Timeline {
    /// Of every ping, by index; while a run lasts, one for every second (RunTimeline).
    std::shared_ptr<const std::vector<Timestamp>> ping_times;
    std::vector<PingSpan> gaps;               ///< begin: the last ping before a silence; end: the first after it
    std::vector<std::uint64_t> sweep_starts;  ///< indices of pings that began a new sweep
    std::vector<PingSpan> confirmed;          ///< while at least one track was confirmed or coasting
    std::vector<PingSpan> recalled;           ///< of a run that lasts: not seen here, but in its recording
    std::uint64_t analysed = 0;               ///< pings run through the pipeline for this summary
    std::uint64_t revision = 0;               ///< of the parameters it was made with

    std::uint64_t pings() const { return ping_times ? ping_times->size() : 0; }
    /// The number of pings transmitted up to `time`: the position that shows that moment.
    std::uint64_t positionAt(Timestamp time) const;
    /// The position right after the first ping of the sweep before, or after, the one shown at `position`.
    std::uint64_t sweepBefore(std::uint64_t position) const;
    std::uint64_t sweepAfter(std::uint64_t position) const;
};

/// Silences between pings: longer than a second and than ten times the median interval.
std::vector<PingSpan> findGaps(const std::vector<Timestamp>& times);

/// Whether a track in this state is confirmed or coasting; and whether at least one of several is.
bool isFollowed(TrackState state);
bool anyFollowed(const std::vector<Track>& tracks);

/// Adds the ping with this index, which is not before the last one there.
void extendSpans(std::vector<PingSpan>& spans, std::uint64_t index);

/// Notes in `timeline` what the ping with this index brought about.
void extendTimeline(Timeline& timeline, std::uint64_t index, bool sweep_began, bool followed);

}  // namespace echotrail
