#include "core/runtime/timeline.hpp"

#include <algorithm>

namespace echotrail {

std::uint64_t Timeline::positionAt(Timestamp time) const {
    if (!ping_times) return 0;
    const auto after = std::upper_bound(ping_times->begin(), ping_times->end(), time);
    return static_cast<std::uint64_t>(after - ping_times->begin());
}

std::uint64_t Timeline::sweepBefore(std::uint64_t position) const {
    // The ping shown at `position` has index position - 1; its own sweep start does not count as "before".
    const auto at = std::lower_bound(sweep_starts.begin(), sweep_starts.end(), position == 0 ? 0 : position - 1);
    return at == sweep_starts.begin() ? 0 : *(at - 1) + 1;
}

std::uint64_t Timeline::sweepAfter(std::uint64_t position) const {
    const auto at = std::lower_bound(sweep_starts.begin(), sweep_starts.end(), position);
    return at == sweep_starts.end() ? pings() : *at + 1;
}

std::vector<PingSpan> findGaps(const std::vector<Timestamp>& times) {
    if (times.size() < 3) return {};
    std::vector<Microseconds> intervals(times.size() - 1);
    for (std::size_t i = 0; i + 1 < times.size(); ++i) intervals[i] = times[i + 1] - times[i];
    auto sorted = intervals;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    const Microseconds limit = std::max<Microseconds>(std::chrono::seconds(1), 10 * *middle);
    std::vector<PingSpan> gaps;
    for (std::size_t i = 0; i < intervals.size(); ++i)
        if (intervals[i] > limit) gaps.push_back({i, i + 1});
    return gaps;
}

bool isFollowed(TrackState state) { return state == TrackState::Confirmed || state == TrackState::Coasting; }

bool anyFollowed(const std::vector<Track>& tracks) {
    return std::any_of(tracks.begin(), tracks.end(), [](const Track& track) { return isFollowed(track.state); });
}

void extendSpans(std::vector<PingSpan>& spans, std::uint64_t index) {
    if (!spans.empty() && spans.back().end == index)
        spans.back().end = index + 1;
    else
        spans.push_back({index, index + 1});
}

void extendTimeline(Timeline& timeline, std::uint64_t index, bool sweep_began, bool followed) {
    if (sweep_began) timeline.sweep_starts.push_back(index);
    if (followed) extendSpans(timeline.confirmed, index);
    timeline.analysed = index + 1;
}

}  // namespace echotrail
