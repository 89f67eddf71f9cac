#include "core/runtime/timeline.hpp"

#include <gtest/gtest.h>

namespace echotrail {
namespace {

Timestamp at(double seconds) { return Timestamp(microsecondsFromSeconds(seconds)); }

Timeline withTimes(std::vector<Timestamp> times) {
    Timeline timeline;
    timeline.ping_times = std::make_shared<const std::vector<Timestamp>>(std::move(times));
    return timeline;
}

TEST(Timeline, ThePositionAtATimeCountsThePingsSentUntilThen) {
    const Timeline timeline = withTimes({at(1), at(2), at(3)});
    EXPECT_EQ(timeline.positionAt(at(0.5)), 0U);
    EXPECT_EQ(timeline.positionAt(at(2.0)), 2U);
    EXPECT_EQ(timeline.positionAt(at(2.9)), 2U);
    EXPECT_EQ(timeline.positionAt(at(99)), 3U);
    EXPECT_EQ(Timeline{}.positionAt(at(1)), 0U);
}

TEST(Timeline, SweepsAreSteppedFromFirstPingToFirstPing) {
    Timeline timeline = withTimes(std::vector<Timestamp>(30));
    timeline.sweep_starts = {10, 20};
    EXPECT_EQ(timeline.sweepAfter(0), 11U);
    EXPECT_EQ(timeline.sweepAfter(11), 21U);
    EXPECT_EQ(timeline.sweepAfter(21), 30U);
    EXPECT_EQ(timeline.sweepBefore(30), 21U);
    EXPECT_EQ(timeline.sweepBefore(21), 11U);
    EXPECT_EQ(timeline.sweepBefore(11), 0U);
    EXPECT_EQ(timeline.sweepBefore(0), 0U);
}

TEST(Timeline, ASilenceMuchLongerThanTheRhythmIsAGap) {
    std::vector<Timestamp> times;
    for (int i = 0; i < 20; ++i) times.push_back(at(0.1 * i + (i >= 8 ? 3.0 : 0.0)));
    EXPECT_EQ(findGaps(times), (std::vector<PingSpan>{{7, 8}}));
    EXPECT_TRUE(findGaps({at(0), at(100)}).empty());
}

TEST(Timeline, SpansOfFollowedTracksCloseWhereNoneIsConfirmed) {
    Timeline timeline = withTimes(std::vector<Timestamp>(6));
    std::vector<Track> tracks(1);
    const std::vector<TrackState> states{TrackState::Tentative, TrackState::Confirmed, TrackState::Coasting,
                                         TrackState::Lost, TrackState::Confirmed};
    for (std::uint64_t i = 0; i < states.size(); ++i) {
        tracks[0].state = states[i];
        extendTimeline(timeline, i, i == 3, anyFollowed(tracks));
    }
    EXPECT_EQ(timeline.confirmed, (std::vector<PingSpan>{{1, 3}, {4, 5}}));
    EXPECT_EQ(timeline.sweep_starts, (std::vector<std::uint64_t>{3}));
    EXPECT_EQ(timeline.analysed, 5U);
}

}  // namespace
}  // namespace echotrail
