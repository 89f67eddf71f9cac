#include "core/link/link.pb.h"
#include "core/link/wire_values.hpp"
#include "tests/core/link/link_pair.hpp"

#include <gtest/gtest.h>

namespace echotrail::test {
namespace {

/// Aboard lies one recording of so many rows, each of 1000 bytes.
struct Shelf {
    explicit Shelf(Wire& to) : wire(to) { wire.server.serveRecordings(); }
    void answer() {
        while (auto request = wire.server.nextRecordRequest(wire.now())) {
            requests.push_back(*request);
            wire.server.answer(*request, of(*request), wire.now());
        }
    }
    Result<LinkRecordAnswer> of(const LinkRecordRequest& request) const {
        if (std::holds_alternative<LinkListRecordings>(request.content))
            return LinkRecordAnswer(LinkRecordings{0, {{"a.echotrail", 12, at(1.0), true}}});
        if (const auto* described = std::get_if<LinkDescribeRecording>(&request.content)) {
            if (described->recording != "a.echotrail") return Error{"there is no such recording"};
            return LinkRecordAnswer(LinkRecording{0, "a.echotrail", {header, {{rows, 3}}}});
        }
        const LogRowsWanted& wanted = std::get<LinkReadRows>(request.content).rows;
        LogRows read{wanted.table, {}, rows, 1};
        for (std::int64_t row = wanted.first; row <= std::min(wanted.last, rows); ++row) {
            if (!read.rows.empty() && 1'000 * (read.rows.size() + 1) > wanted.most_bytes) break;
            read.rows.push_back({row, {row, 1, 5'000'000 * row, 4, 0, 1}, 99, std::vector<std::uint8_t>(1'000, 7)});
        }
        return LinkRecordAnswer(LinkRows{0, std::move(read)});
    }
    Wire& wire;
    LogHeader header{"1.0", "head\xff", "x = 1", 7, at(2.0)};
    std::int64_t rows = 10'000;
    std::vector<LinkRecordRequest> requests;
};

LinkReadRows some(std::int64_t first, std::size_t most_bytes) {
    return {"a.echotrail", {0, LogTable::Events, first, 9'000, most_bytes}};
}

TEST(LinkRecordings, AreListedDescribedAndReadRowByRow) {
    Wire wire;
    Shelf shelf(wire);
    Console console("shore");
    wire.plug(console);
    wire.carry({&console});
    ASSERT_TRUE(console.client.status().mayReadRecordings());
    const auto listed = console.client.listRecordings();
    const auto described = console.client.describeRecording("a.echotrail");
    const auto read = console.client.readRows(some(11, 3'500));
    const auto nowhere = console.client.describeRecording("../b");
    for (int turn = 0; turn < 4; ++turn) {
        wire.carry({&console});
        shelf.answer();
    }
    wire.carry({&console});
    ASSERT_EQ(console.heard<LinkRecordings>().size(), 1U);
    EXPECT_EQ(console.heard<LinkRecordings>()[0].request, listed);
    EXPECT_EQ(console.heard<LinkRecordings>()[0].entries[0], (LinkRecordingEntry{"a.echotrail", 12, at(1.0), true}));
    ASSERT_EQ(console.heard<LinkRecording>().size(), 1U);
    const LinkRecording recording = console.heard<LinkRecording>()[0];
    EXPECT_EQ(recording.request, described);
    EXPECT_EQ(recording.log.header, shelf.header) << "as it stands in the log";
    EXPECT_EQ(recording.log.parts, (std::vector<LogExtent>{{10'000, 3}}));
    ASSERT_EQ(console.heard<LinkRows>().size(), 1U);
    const LinkRows rows = console.heard<LinkRows>()[0];
    EXPECT_EQ(rows.request, read);
    ASSERT_EQ(rows.rows.rows.size(), 3U);
    EXPECT_EQ(rows.rows.rows[2].row, 13);
    EXPECT_EQ(rows.rows.there, 10'000);
    ASSERT_NE(console.replyTo(nowhere), nullptr);
    EXPECT_EQ(console.replyTo(nowhere)->reason, "there is no such recording");
    EXPECT_EQ(console.client.unanswered(), 0U);
}

TEST(LinkRecordings, ATrackerThatGivesNoneAwaySaysSo) {
    Wire wire;
    Console console("shore");
    wire.plug(console);
    wire.carry({&console});
    EXPECT_FALSE(console.client.status().mayReadRecordings());
    const auto asked = console.client.listRecordings();
    wire.carry({&console});
    ASSERT_NE(console.replyTo(asked), nullptr);
    EXPECT_FALSE(console.replyTo(asked)->done);
}

TEST(LinkRecordings, TracksGoBeforeRows) {
    Wire wire;
    Shelf shelf(wire);
    Console console("shore");
    wire.plug(console);
    wire.carry({&console});
    console.client.readRows(some(1, 60'000));
    console.reads = 0;
    wire.carry({&console});
    shelf.answer();
    wire.ping(0);
    console.events.clear();
    console.reads = 1 << 24;
    wire.carry({&console});
    ASSERT_GE(console.events.size(), 3U);
    EXPECT_TRUE(std::holds_alternative<LinkTracks>(console.events.front()));
    EXPECT_TRUE(std::holds_alternative<LinkRows>(console.events.back()));
}

TEST(LinkRecordings, OneAnswerAtATimeWaitsAndSoManyRequests) {
    Wire wire;
    Shelf shelf(wire);
    Console console("shore");
    wire.plug(console);
    wire.carry({&console});
    console.reads = 0;
    for (int i = 0; i < 10; ++i) console.client.readRows(some(1, 60'000));
    wire.carry({&console});
    shelf.answer();
    EXPECT_EQ(shelf.requests.size(), 1U) << "the others wait until this one has gone";
    EXPECT_EQ(wire.server.counts().refused.at("too_many"), 6U);
    EXPECT_LT(wire.server.waitingBytes(console.number), 200'000U);
    for (int i = 0; i < 40; ++i) console.client.readRows(some(1, 60'000));
    console.reads = 1 << 24;
    wire.carry({&console});
    EXPECT_EQ(console.number, 0U) << "who does not listen is dropped";
}

TEST(LinkRecordings, AllConsolesTogetherGetSoManyBytesInASecond) {
    Wire wire;
    Shelf shelf(wire);
    std::vector<std::unique_ptr<Console>> consoles;
    std::vector<Console*> all;
    for (int i = 0; i < 8; ++i) {
        consoles.push_back(std::make_unique<Console>("shore " + std::to_string(i)));
        all.push_back(consoles.back().get());
        wire.plug(*all.back());
    }
    wire.carry(all);
    constexpr double seconds = 4.0;
    for (double passed = 0.0; passed < seconds; passed += 0.01) {
        for (Console* console : all)
            if (console->client.unanswered() == 0) console->client.readRows(some(1, 1 << 20));
        wire.run(0.01, all, 0.01);
        shelf.answer();
    }
    const auto given = static_cast<double>(wire.server.counts().record_bytes);
    EXPECT_GT(given, 0.9 * seconds * link_limits::rows_per_second);
    EXPECT_LT(given, (seconds + 0.5) * link_limits::rows_per_second + 8e4);
    std::size_t least = SIZE_MAX, most = 0;
    for (Console* console : all) {
        const std::size_t got = console->heard<LinkRows>().size();
        least = std::min(least, got);
        most = std::max(most, got);
    }
    EXPECT_LE(most - least, 2U) << "to each as to the others";
}

TEST(LinkRecordings, WhereTheWayIsTooSlowForThePictureRowsAreFewAndSpareIt) {
    Wire wire;
    Shelf shelf(wire);
    Console console("shore");
    wire.plug(console);
    wire.carry({&console});
    std::uint64_t number = 0;
    console.reads = 5;  // in a turn; four turns each 50 ms
    while (wire.server.levelOf(console.number, wire.now()) == SendQueue::Everything) {
        wire.ping(number++);
        wire.run(0.05, {&console});
    }
    shelf.requests.clear();
    const Timestamp begun = wire.now();
    console.reads = 500;
    while (wire.server.levelOf(console.number, wire.now()) != SendQueue::Everything) {
        if (console.client.unanswered() == 0) console.client.readRows(some(1, 60'000));
        wire.run(0.05, {&console});
        shelf.answer();
        ASSERT_LT(secondsBetween(begun, wire.now()), 60.0) << "rows do not keep the picture away";
    }
    const double seconds = secondsBetween(begun, wire.now());
    EXPECT_GE(shelf.requests.size(), 2U);
    EXPECT_LE(static_cast<double>(shelf.requests.size()), seconds + 1.0);
    for (const LinkRecordRequest& request : shelf.requests)
        EXPECT_LE(std::get<LinkReadRows>(request.content).rows.most_bytes, link_limits::fewest_rows);
}

TEST(LinkRecordings, WhatIsThrownAwayForASnapshotIsNotTheRows) {
    SendQueue queue;
    const auto frame = [](std::size_t bytes) { return std::make_shared<const std::string>(bytes, 'x'); };
    ASSERT_TRUE(queue.add(SendQueue::Lane::Record, frame(1'000), at(0.0)));
    EXPECT_FALSE(queue.add(SendQueue::Lane::Urgent, frame(link_limits::urgent_bytes + 1), at(0.1)));
    EXPECT_EQ(queue.waitingIn(SendQueue::Lane::Record), 1'000U);
    queue.judge(at(60.0));
    EXPECT_EQ(queue.waitingIn(SendQueue::Lane::Record), 1'000U) << "they are as true later";
    EXPECT_EQ(queue.level(), SendQueue::Everything) << "and say nothing about the way";
}

TEST(LinkRecordings, WhatCannotBeIsNotRead) {
    wire::Rows rows;
    rows.set_there(5);
    rows.set_parts(1);
    ASSERT_TRUE(read(rows));
    wire::Rows::Row& row = *rows.add_rows();
    row.set_row(5);
    for (int i = 0; i < 6; ++i) row.add_numbers(i);
    ASSERT_TRUE(read(rows));
    rows.set_table(wire::RESULTS);
    EXPECT_FALSE(read(rows)) << "a result has two numbers";
    rows.set_table(static_cast<wire::LogTable>(2));
    EXPECT_FALSE(read(rows));
    rows.set_table(wire::EVENTS);
    row.set_payload(std::string(link_limits::longest_payload + 1, 'x'));
    EXPECT_FALSE(read(rows));
    row.clear_payload();
    row.set_row(-1);
    EXPECT_FALSE(read(rows));

    wire::ReadRows wanted;
    ASSERT_TRUE(read(wanted));
    wanted.set_most_bytes(1 << 30);
    EXPECT_EQ(read(wanted)->rows.most_bytes, link_limits::longest_rows);
    wanted.set_first(-3);
    EXPECT_FALSE(read(wanted));
    wanted.set_first(0);
    wanted.set_recording(std::string(link_limits::longest_word + 1, 'a'));
    EXPECT_FALSE(read(wanted));

    wire::Recordings recordings;
    wire::Recordings::Entry& entry = *recordings.add_entries();
    entry.set_name("a.echotrail");
    ASSERT_TRUE(read(recordings));
    entry.set_name("a\nb");
    EXPECT_FALSE(read(recordings));

    wire::Recording recording;
    EXPECT_FALSE(read(recording)) << "a log has one part at least";
    recording.add_parts();
    ASSERT_TRUE(read(recording));
    recording.mutable_parts(0)->set_events(-1);
    EXPECT_FALSE(read(recording));
}

}  // namespace
}  // namespace echotrail::test
