#include "core/runtime/run_timeline.hpp"

#include "core/data/event.hpp"
#include "core/recording/log_format.hpp"

#include <gtest/gtest.h>

namespace echotrail {
namespace {

constexpr double start_s = 1'274'601'600.0;

Timestamp at(double seconds) { return Timestamp(microsecondsFromSeconds(start_s + seconds)); }

std::int64_t microsecondsAt(double seconds) { return at(seconds).time_since_epoch().count(); }

/// Four pings a second of [from, to), one sweep each ten seconds.
void seePings(RunTimeline& run, double from, double to, bool followed) {
    for (double second = from; second < to; second += 0.25)
        run.see(at(second), static_cast<std::uint64_t>(second / 10.0), followed);
}

LogRow bytesRow(double second) {
    return {.numbers = {0, static_cast<std::int64_t>(EventKind::SonarBytes), microsecondsAt(second), 0, 0, 1}};
}

LogRow lookRow(double second, const std::string& text) {
    return {.numbers = {static_cast<std::int64_t>(UpdateKind::Track), microsecondsAt(second)},
            .payload = {text.begin(), text.end()}};
}

TEST(RunTimeline, StandsForEverySecondThatWasSeen) {
    RunTimeline run;
    seePings(run, 0, 30, false);
    seePings(run, 30, 40, true);
    EXPECT_TRUE(run.changed());
    const Timeline line = run.summary();
    EXPECT_FALSE(run.changed());
    ASSERT_EQ(line.pings(), 41U);  // and the last ping of all
    EXPECT_EQ(line.ping_times->front(), at(0));
    EXPECT_EQ(line.ping_times->back(), at(39.75));
    EXPECT_EQ(line.sweep_starts, (std::vector<std::uint64_t>{10, 20, 30}));
    EXPECT_EQ(line.confirmed, (std::vector<PingSpan>{{30, 40}}));
    EXPECT_TRUE(line.gaps.empty());
    EXPECT_TRUE(line.recalled.empty());
}

TEST(RunTimeline, ASilenceIsAGapUntilTheRecordingTellsOfIt) {
    RunTimeline run;
    seePings(run, 0, 10, true);
    seePings(run, 20, 30, true);
    EXPECT_EQ(run.summary().gaps, (std::vector<PingSpan>{{9, 10}}));

    LogRows events{.table = LogTable::Events};
    for (int second = 0; second < 20; ++second) events.rows.push_back(bytesRow(second + 0.5));
    run.recall(events);
    const Timeline healed = run.summary();
    EXPECT_TRUE(healed.gaps.empty());
    EXPECT_EQ(healed.recalled, (std::vector<PingSpan>{{10, 20}}));
    EXPECT_EQ(healed.confirmed, (std::vector<PingSpan>{{0, 10}, {20, 30}}));
}

TEST(RunTimeline, WhatTheRecordingTellsOfTracksHoldsUntilItTellsOtherwise) {
    RunTimeline run;
    seePings(run, 0, 2, false);
    seePings(run, 12, 14, false);
    LogRows looks{.table = LogTable::Results};  // results come before the events, which is the harder way round
    looks.rows = {lookRow(4.5, R"({"track":3,"state":"confirmed"})"),
                  lookRow(6.5, R"({"track":5,"state":"tentative"})"), lookRow(8.5, R"({"track":3,"state":"lost"})")};
    run.recall(looks);
    LogRows events{.table = LogTable::Events};
    for (int second = 2; second < 12; ++second) events.rows.push_back(bytesRow(second + 0.1));
    run.recall(events);
    EXPECT_EQ(run.summary().confirmed, (std::vector<PingSpan>{{4, 8}}));
}

TEST(RunTimeline, BelievesNoRowThatCannotBeOfThisRun) {
    RunTimeline run;
    LogRows before{.table = LogTable::Events, .rows = {bytesRow(3)}};
    run.recall(before);  // nothing is known of the run yet
    EXPECT_FALSE(run.changed());
    seePings(run, 0, 4, false);
    const Timeline seen = run.summary();
    LogRows events{.table = LogTable::Events, .rows = {bytesRow(4e9), bytesRow(-4e9), bytesRow(2)}};
    events.rows.push_back(bytesRow(-5));
    events.rows.back().numbers[1] = static_cast<std::int64_t>(EventKind::NavigationBytes);
    run.recall(events);
    LogRows looks{.table = LogTable::Results};
    for (const char* text : {"", "{", "[]", "{}", R"({"track":"3","state":"confirmed"})",
                             R"({"track":3,"state":"mine"})", R"({"track":3,"state":7})"})
        looks.rows.push_back(lookRow(-5, text));
    run.recall(looks);
    EXPECT_EQ(run.summary().pings(), seen.pings());
}

TEST(RunTimeline, AClockThatWasSetByDaysTellsOfAnotherRun) {
    RunTimeline run;
    seePings(run, 0, 4, false);
    seePings(run, 1e6, 1e6 + 5, false);
    EXPECT_EQ(run.summary().ping_times->front(), at(1e6));
}

TEST(RunTimeline, ForgetsWhatIsTooOld) {
    RunTimeline run;
    for (std::size_t second = 0; second < RunTimeline::most_seconds + 100; ++second)
        run.see(at(static_cast<double>(second)), 0, false);
    const Timeline line = run.summary();
    EXPECT_EQ(line.pings(), RunTimeline::most_seconds);
    EXPECT_EQ(line.ping_times->front(), at(100));
}

}  // namespace
}  // namespace echotrail
