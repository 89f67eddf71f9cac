#include "core/recording/v4log.hpp"

#include "tests/core/recording/recording_files.hpp"

#include <algorithm>
#include <numeric>

namespace echotrail {
namespace {

constexpr std::size_t record_bytes = 688;

/// A real log of 312 lines; its records stand where the table says.
class SeanetProLog : public testing::Test {
protected:
    void SetUp() override {
        path_ = sharedCapture("seaking_dfs_v4log/seaking_dfs_first312.V4LOG");
        if (path_.empty()) GTEST_SKIP() << "needs the shared recordings";
        bytes_ = readBytes(path_);
        rows_ = readTable(sharedCapture("seaking_dfs_v4log/records_first312.csv"));
        ASSERT_EQ(rows_.size(), 312u);
    }
    std::size_t offsetOf(std::size_t record) const { return std::stoul(rows_[record].at("record_offset")); }

    std::string path_;
    ByteVector bytes_;
    std::vector<std::map<std::string, std::string>> rows_;
};

TEST_F(SeanetProLog, EveryLineIsThatOfTheTable) {
    auto source = openRecording(path_);
    ASSERT_TRUE(source);
    const auto pings = allPings(**source);
    ASSERT_EQ(pings.size(), rows_.size());
    for (std::size_t i = 0; i < pings.size(); ++i) {
        SCOPED_TRACE(i);
        const Ping& ping = pings[i];
        const auto& row = rows_[i];
        EXPECT_EQ(ping.sequence, i);
        EXPECT_EQ(toIso8601(ping.time), row.at("time") + "000Z");
        EXPECT_NEAR(ping.bearing - Bearing::degrees((std::stoi(row.at("bearing")) - 3200) * 360.0 / 6400), 0, 1e-12);
        EXPECT_NEAR(ping.bin_interval_s, std::stoi(row.at("adinterval")) * 640e-9, 1e-12);
        EXPECT_EQ(std::to_string(ping.levels.size()), row.at("dbytes"));
        EXPECT_EQ(crc32(ping.levels), row.at("data_crc32"));
        EXPECT_EQ(std::to_string(std::accumulate(ping.levels.begin(), ping.levels.end(), 0)), row.at("data_sum"));
        EXPECT_EQ(std::to_string(*std::max_element(ping.levels.begin(), ping.levels.end())), row.at("data_max"));
        EXPECT_EQ(ping.clockwise, (std::stoi(row.at("hdctrl")) & 4) != 0);
    }
    const SourceCounts counts = (*source)->counts();
    EXPECT_EQ(counts.lost_records, 0u);
    EXPECT_EQ(counts.skipped_bytes, 0u);
    EXPECT_TRUE(counts.rejected.empty());
    EXPECT_EQ(counts.ignored, (std::map<std::string, std::uint64_t>{{"mtBBUserData", 1}, {"mtVersionData", 1}}));
}

TEST_F(SeanetProLog, SaysWhatItHolds) {
    const auto source = openRecording(path_);
    ASSERT_TRUE(source);
    const SourceInfo& info = (*source)->info();
    EXPECT_EQ(info.pings, 312u);
    EXPECT_EQ(info.name, "seaking_dfs_first312.V4LOG");
    EXPECT_EQ(info.head, "SeaKing 325/675 kHz, node 2, at 325 kHz");
    EXPECT_DOUBLE_EQ(info.range_scale_m, 10.0);
    EXPECT_EQ(toIso8601(info.start), rows_.front().at("time") + "000Z");
    EXPECT_EQ(toIso8601(info.end), rows_.back().at("time") + "000Z");
}

TEST_F(SeanetProLog, KeepsItsOwnSpeedOfSoundUnlessToldAnother) {
    const auto own = openRecording(path_, {.default_sound_speed_mps = 1520.0});
    const auto told = openRecording(path_, {.sound_speed_mps = 1510.0});
    ASSERT_TRUE(own && told);
    EXPECT_DOUBLE_EQ((*own)->info().sound_speed_mps, 1475.0);
    EXPECT_DOUBLE_EQ((*own)->next()->sound_speed_mps, 1475.0);
    EXPECT_DOUBLE_EQ((*told)->info().sound_speed_mps, 1510.0);
    EXPECT_DOUBLE_EQ((*told)->next()->sound_speed_mps, 1510.0);
}

TEST_F(SeanetProLog, RewoundItGivesTheSamePings) {
    auto source = openRecording(path_);
    ASSERT_TRUE(source);
    const auto first = allPings(**source);
    (*source)->rewind();
    EXPECT_EQ(allPings(**source), first);
    (*source)->rewind();
    (*source)->next();
    (*source)->rewind();
    EXPECT_EQ(allPings(**source), first);
}

TEST_F(SeanetProLog, CutInsideItsLastRecordItLosesThatOneOnly) {
    // Of the records all but the first two and the last two are left out, to be quick.
    const auto at = [&](std::size_t offset) { return bytes_.begin() + static_cast<std::ptrdiff_t>(offset); };
    ByteVector log(bytes_.begin(), at(offsetOf(2)));
    log.insert(log.end(), at(offsetOf(310)), at(offsetOf(311) + record_bytes));
    log[44] = 4;
    log[45] = 0;
    const auto pings = play(log).pings;
    ASSERT_EQ(pings.size(), 4u);
    for (std::size_t left = 0; left < record_bytes; ++left) {
        const ByteVector cut(log.begin(), log.end() - static_cast<std::ptrdiff_t>(record_bytes - left));
        const Played played = play(cut);
        ASSERT_EQ(played.pings.size(), 3u) << "cut after " << left << " bytes";
        ASSERT_EQ(played.pings.back(), pings[2]);
        ASSERT_EQ(played.counts.lost_records, 1u) << "cut after " << left << " bytes";
        ASSERT_EQ(played.counts.skipped_bytes, left);
    }
}

TEST_F(SeanetProLog, AnyFlippedBitOfARecordsHeadCostsThatRecordOnly) {
    const auto pings = play(bytes_).pings;
    const std::size_t at = offsetOf(150);
    constexpr std::size_t checked_bytes = 10;  // the length and the date
    for (std::size_t bit = 0; bit < 8 * checked_bytes; ++bit) {
        ByteVector damaged = bytes_;
        damaged[at + bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8);
        const Played played = play(damaged);
        ASSERT_GE(played.pings.size(), 311u) << "bit " << bit;
        ASSERT_EQ(played.pings.size() + played.counts.lost_records, 312u) << "bit " << bit;
        ASSERT_EQ(played.pings[148].levels, pings[148].levels);  // of two dates in disorder either may be believed
        ASSERT_EQ(played.pings.back().levels, pings.back().levels);
    }
}

TEST_F(SeanetProLog, AWrongLengthInTheMiddleCostsOneRecord) {
    for (const unsigned length : {0u, 14u, 687u, 689u, 1376u, 4000u, 65535u}) {
        ByteVector damaged = bytes_;
        damaged[offsetOf(100)] = static_cast<std::uint8_t>(length & 0xFF);
        damaged[offsetOf(100) + 1] = static_cast<std::uint8_t>(length >> 8);
        const Played played = play(damaged);
        EXPECT_GE(played.pings.size(), 311u) << length;
        EXPECT_EQ(played.pings.size() + played.counts.lost_records, 312u) << length;
    }
}

TEST_F(SeanetProLog, LinesTheHeaderPromisedButThatAreMissingAreLost) {
    ByteVector more = bytes_;
    ASSERT_EQ(more[44] | more[45] << 8, 312);
    more[44] = static_cast<std::uint8_t>(more[44] + 5);
    const Played played = play(more);
    EXPECT_EQ(played.pings.size(), 312u);
    EXPECT_EQ(played.counts.lost_records, 5u);
    EXPECT_EQ(played.counts.rejected.at("missing_record"), 5u);
    ByteVector fewer = bytes_;
    fewer[44] = 1;
    EXPECT_EQ(play(fewer).counts.lost_records, 0u);
}

TEST_F(SeanetProLog, WithoutItsIndexTheRecordsAreStillFound) {
    ByteVector damaged = bytes_;
    std::fill_n(damaged.begin() + 56, 4, std::uint8_t{0xFF});
    EXPECT_EQ(play(damaged).pings.size(), 312u);
}

TEST_F(SeanetProLog, CutBetweenTwoRecordsItIsNotTakenForWhole) {
    // The header tells where the lines end and records of the head's settings begin; nothing but the settings is gone.
    const auto settings = static_cast<std::ptrdiff_t>(seanet::u32(bytes_, 48));
    ASSERT_EQ(static_cast<std::size_t>(settings), offsetOf(311) + record_bytes);
    const Played played = play({bytes_.begin(), bytes_.begin() + settings});
    EXPECT_EQ(played.pings.size(), 312u);
    EXPECT_EQ(played.counts.lost_records, 1u);
}

TEST_F(SeanetProLog, AWrongPlaceOfTheIndexCostsNoLine) {
    for (const std::size_t bit : {3U, 10U, 14U, 16U, 17U, 18U, 31U}) {
        ByteVector damaged = bytes_;
        damaged[56 + bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8);
        EXPECT_EQ(play(damaged).pings.size(), 312u) << "bit " << bit;
    }
}

TEST_F(SeanetProLog, ALongDamagedStretchIsSkippedWhole) {
    constexpr std::size_t stretch = 3'000'000;
    ByteVector damaged = bytes_;
    std::fill_n(damaged.begin() + 56, 4, std::uint8_t{0xFF});  // the index no longer stands where it did
    damaged.resize(offsetOf(311) + record_bytes);
    damaged.insert(damaged.begin() + static_cast<std::ptrdiff_t>(offsetOf(100)), stretch, std::uint8_t{0x40});
    const Played played = play(damaged);
    EXPECT_EQ(played.pings, play(bytes_).pings);
    EXPECT_EQ(played.counts.skipped_bytes, stretch);
    EXPECT_EQ(played.counts.lost_records, 1u);
}

TEST_F(SeanetProLog, HoldingNoLineItIsRefused) {
    const auto errorOf = [](const ByteVector& bytes) {
        const TemporaryFile file(bytes);
        const auto source = openRecording(file.path());
        return source ? std::string() : source.error();
    };
    const auto first = [&](std::size_t size) {
        return ByteVector(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(size));
    };
    for (const std::size_t size : {std::size_t{20}, std::size_t{79}, std::size_t{80}, offsetOf(0)}) {
        const std::string error = errorOf(first(size));
        EXPECT_NE(error.find("no sonar ping"), std::string::npos) << size;
        EXPECT_EQ(error.find('\n'), std::string::npos);
    }
}

}  // namespace
}  // namespace echotrail
