#include "core/recording/byte_dump.hpp"

#include "core/seanet/head_data.hpp"
#include "tests/core/recording/recording_files.hpp"

#include <algorithm>
#include <numeric>

namespace echotrail {
namespace {

constexpr std::size_t frame_bytes = 839, first_frame = 24, datagram_bytes = 104;

/// What a serial server passed on of a real head: 24 bytes of a frame, 509 whole ones, 677 bytes of another.
class DumpOfAHead : public testing::Test {
protected:
    void SetUp() override {
        path_ = sharedCapture("seaking_dst_udp/sonar_stream_part1.bin");
        if (path_.empty()) GTEST_SKIP() << "needs the shared recordings";
        bytes_ = readBytes(path_);
        // Enough of it for what is done to it again and again: 40 whole frames and nothing else.
        const auto begin = bytes_.begin() + first_frame;
        few_ = ByteVector(begin, begin + 40 * frame_bytes);
    }
    std::string path_;
    ByteVector bytes_, few_;
};

TEST_F(DumpOfAHead, EveryLineIsThatOfTheTable) {
    const auto rows = readTable(sharedCapture("seaking_dst_udp/frames_part1.csv"));
    auto source = openRecording(path_);
    ASSERT_TRUE(source);
    const auto pings = allPings(**source);
    ASSERT_EQ(pings.size(), 509u);
    ASSERT_EQ(rows.size(), 509u);
    for (std::size_t i = 0; i < pings.size(); ++i) {
        SCOPED_TRACE(i);
        const Ping& ping = pings[i];
        const auto& row = rows[i];
        EXPECT_EQ(ping.sequence, i);
        EXPECT_NEAR(ping.bearing - Bearing::degrees((std::stoi(row.at("bearing")) - 3200) * 360.0 / 6400), 0, 1e-12);
        EXPECT_NEAR(ping.bin_interval_s, std::stoi(row.at("adinterval")) * 640e-9, 1e-12);
        EXPECT_DOUBLE_EQ(ping.range_scale_m, std::stoi(row.at("range_dm")) / 10.0);
        EXPECT_EQ(std::to_string(ping.levels.size()), row.at("dbytes"));
        EXPECT_EQ(crc32(ping.levels), row.at("data_crc32"));
        EXPECT_EQ(std::to_string(std::accumulate(ping.levels.begin(), ping.levels.end(), 0)), row.at("data_sum"));
        EXPECT_EQ(std::to_string(*std::max_element(ping.levels.begin(), ping.levels.end())), row.at("data_max"));
    }
}

TEST_F(DumpOfAHead, ACutBeginningIsNoLossACutEndIsOne) {
    auto source = openRecording(path_);
    ASSERT_TRUE(source);
    allPings(**source);
    const SourceCounts counts = (*source)->counts();
    EXPECT_EQ(counts.skipped_bytes, 24u + 677u);
    EXPECT_EQ(counts.lost_records, 1u);
    EXPECT_EQ(counts.rejected, (std::map<std::string, std::uint64_t>{{"cut_frame", 1}}));
    EXPECT_EQ((*source)->info().pings, 509u);
    EXPECT_EQ((*source)->info().head, "digital head, node 2, at 650 kHz");
}

TEST_F(DumpOfAHead, AFileOfOneLineStillKnowsItsHead) {
    const TemporaryFile file(ByteVector(few_.begin(), few_.begin() + frame_bytes));
    const auto source = openRecording(file.path());
    ASSERT_TRUE(source);
    EXPECT_EQ((*source)->info().pings, 1u);
    EXPECT_EQ((*source)->info().head, "digital head, node 2, at 650 kHz");
}

TEST_F(DumpOfAHead, TimesRiseByEachPingsOwnDuration) {
    const auto pings = play(few_).pings;
    ASSERT_EQ(pings.size(), 40u);
    EXPECT_EQ(toIso8601(pings[0].time), "1970-01-01T00:00:00.000000Z");
    for (std::size_t i = 1; i < pings.size(); ++i) {
        const double elapsed = secondsBetween(pings[i - 1].time, pings[i].time);
        EXPECT_GT(elapsed, 2 * 50.0 / 1490.0);
        EXPECT_LT(elapsed, 0.1);
    }
}

TEST_F(DumpOfAHead, RewoundItGivesTheSamePings) {
    auto source = openRecording(path_);
    ASSERT_TRUE(source);
    const auto first = allPings(**source);
    (*source)->rewind();
    (*source)->next();
    (*source)->rewind();
    EXPECT_EQ(allPings(**source), first);
    EXPECT_EQ((*source)->counts().lost_records, 1u);
}

TEST_F(DumpOfAHead, ALostDatagramCostsTheLinesItHeldAndIsCounted) {
    for (std::size_t at = 0; at + datagram_bytes <= few_.size(); at += datagram_bytes) {
        ByteVector dropped = few_;
        const auto begin = dropped.begin() + static_cast<std::ptrdiff_t>(at);
        dropped.erase(begin, begin + datagram_bytes);
        const std::size_t held = (at + datagram_bytes - 1) / frame_bytes - at / frame_bytes + 1;  // 1, seldom 2
        const Played played = play(dropped);
        ASSERT_GE(played.pings.size(), 40 - held) << "without the bytes from " << at;
        ASSERT_LT(played.pings.size(), 40u) << "without the bytes from " << at;
        if (at >= frame_bytes) {
            ASSERT_GE(played.counts.lost_records, 1u) << "without the bytes from " << at;
        }
    }
}

TEST_F(DumpOfAHead, AFlippedBitCostsNoMoreThanItsOwnLine) {
    for (std::size_t round = 0; round < 200; ++round) {
        ByteVector damaged = few_;
        // In every second frame: between two damaged ones that touch, a parser cannot tell how many were lost.
        for (std::size_t frame = 1; frame < 40; frame += 2) {
            const std::size_t bit = (round * 131 + frame * 977) % (8 * (round < 100 ? frame_bytes : 46));
            damaged[frame * frame_bytes + bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8);
        }
        const Played played = play(damaged);
        std::uint64_t ignored = 0;
        for (const auto& [name, number] : played.counts.ignored) ignored += number;
        ASSERT_GE(played.pings.size(), 20u) << "round " << round;
        ASSERT_EQ(played.pings.size() + played.counts.lost_records + ignored, 40u) << "round " << round;
    }
}

TEST(ByteDumps, FramesOfALogGiveTheLogsOwnPings) {
    const std::string log_path = sharedCapture("seaking_dfs_v4log/seaking_dfs_first312.V4LOG");
    if (log_path.empty()) GTEST_SKIP() << "needs the shared recordings";
    const auto log = openRecording(log_path);
    const auto dump = openRecording(sharedCapture("seaking_dfs_v4log/seaking_dfs_first312_reframed.bin"),
                                    {.sound_speed_mps = 1475.0});
    ASSERT_TRUE(log && dump);
    auto expected = allPings(**log), found = allPings(**dump);
    ASSERT_EQ(found.size(), 312u);
    for (auto* pings : {&expected, &found})
        for (Ping& ping : *pings) ping.time = {};
    EXPECT_EQ(found, expected);
    EXPECT_EQ((*dump)->counts().lost_records, 0u);
    EXPECT_EQ((*dump)->counts().skipped_bytes, 0u);
}

TEST(ByteDumps, OtherMessagesAreNamedNotLost) {
    seanet::HeadData line;
    line.head_control = 0x2301;
    line.bearing = 3200;
    line.data = {1, 2, 3};
    const ByteVector ping = seanet::encodeHeadData(line);
    const Played played = play(joined({ping, seanet::makeFrame(2, 255, 4, 0x80, 2, ByteVector(8, 0)), ping}));
    EXPECT_EQ(played.pings.size(), 2u);
    EXPECT_EQ(played.counts.ignored, (std::map<std::string, std::uint64_t>{{"mtAlive", 1}}));
    EXPECT_EQ(played.counts.lost_records, 0u);
}

}  // namespace
}  // namespace echotrail
