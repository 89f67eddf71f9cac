#include "core/seanet/ping_decoder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace echotrail::seanet {
namespace {

constexpr double sound_speed = 1500.0;

HeadData fourBitLine() {
    HeadData line;
    line.head_control = 0x2302;
    line.range_scale = 200;
    line.ad_low = 40;
    line.ad_span = 45;
    line.bearing = 3200;
    line.step = 16;
    line.data = {0x0F, 0x10};
    return line;
}

Ping pingOf(const HeadData& line) { return pingFrom(line, 0, Timestamp{}, sound_speed); }

TEST(PingDecoder, HeadUnits3200IsAheadAndTheyCountClockwise) {
    HeadData line = fourBitLine();
    EXPECT_NEAR(pingOf(line).bearing.inDegrees(), 0.0, 1e-12);
    line.bearing = 4800;
    EXPECT_NEAR(pingOf(line).bearing.inDegrees(), 90.0, 1e-12);
    line.bearing = 1600;
    EXPECT_NEAR(pingOf(line).bearing.inDegrees(), -90.0, 1e-12);
    line.bearing = 0;
    EXPECT_NEAR(pingOf(line).bearing - Bearing::degrees(180), 0.0, 1e-12);
    EXPECT_NEAR(pingOf(line).step_rad, std::numbers::pi / 200.0, 1e-12);  // 16 units are 0.9 degrees
}

TEST(PingDecoder, TheHighNibbleIsNearerAndSpansFromAdLow) {
    EXPECT_EQ(levelsOf(fourBitLine()), (std::vector<std::uint8_t>{40, 85, 43, 40}));
}

TEST(PingDecoder, FourBitLevelsRiseAndStopAtFullScale) {
    HeadData line = fourBitLine();
    line.ad_low = 200;
    line.ad_span = 255;
    line.data = {0x01, 0x23, 0x45, 0x67, 0x89, 0xAB, 0xCD, 0xEF};
    const auto levels = levelsOf(line);
    ASSERT_EQ(levels.size(), 16u);
    for (std::size_t i = 1; i < levels.size(); ++i) EXPECT_GE(levels[i], levels[i - 1]);
    EXPECT_EQ(levels.front(), 200);
    EXPECT_EQ(levels.back(), 255);
}

TEST(PingDecoder, RangesComeFromTheBinIntervalNotFromTheRangeScale) {
    HeadData line = fourBitLine();
    line.head_control = 0x2301;
    line.ad_interval = 100;
    EXPECT_DOUBLE_EQ(pingOf(line).bin_interval_s, 64e-6);
    EXPECT_DOUBLE_EQ(pingOf(line).binSize(), sound_speed * 64e-6 / 2.0);
}

TEST(PingDecoder, WithoutABinIntervalTheBinsFillTheRangeScale) {
    const Ping ping = pingOf(fourBitLine());
    ASSERT_EQ(ping.levels.size(), 4u);
    EXPECT_NEAR(ping.binSize() * 4, 20.0, 1e-9);
    HeadData empty = fourBitLine();
    empty.data.clear();
    EXPECT_TRUE(std::isfinite(pingOf(empty).binSize()));
}

TEST(PingDecoder, RangeScalesKnowTheirUnits) {
    EXPECT_DOUBLE_EQ(rangeScaleMetres(500), 50.0);
    EXPECT_NEAR(rangeScaleMetres(0x4000 | 1000), 30.48, 1e-9);
    EXPECT_NEAR(rangeScaleMetres(0x8000 | 100), 18.288, 1e-9);
    EXPECT_NEAR(rangeScaleMetres(0xC000 | 100), 9.144, 1e-9);
}

TEST(PingDecoder, FrequencyIsThatOfTheSynthesiser) {
    EXPECT_NEAR(frequencyOf(43'620'761), 325e3, 0.01);
    EXPECT_NEAR(frequencyOf(87'241'523), 650e3, 0.01);
}

TEST(PingDecoder, GainAndFlagsAreThoseOfTheLine) {
    HeadData line = fourBitLine();
    line.gain = 105;
    line.head_control = 0x2304;
    line.status = 0x02;
    const Ping ping = pingFrom(line, 7, Timestamp(Microseconds(5)), sound_speed);
    EXPECT_DOUBLE_EQ(ping.gain_percent, 50.0);
    EXPECT_TRUE(ping.clockwise);
    EXPECT_TRUE(ping.motor_lost_sync);
    EXPECT_EQ(ping.sequence, 7u);
    EXPECT_EQ(ping.time, Timestamp(Microseconds(5)));
    line.head_control = 0x2300;
    line.status = 0;
    EXPECT_FALSE(pingOf(line).clockwise);
    EXPECT_FALSE(pingOf(line).motor_lost_sync);
}

TEST(PingDecoder, APingLastsAsLongAsTheSlowerOfWaterAndWire) {
    HeadData line = fourBitLine();
    line.range_scale = 1500;  // 0.2 s there and back
    EXPECT_GT(pingDurationSeconds(line, sound_speed), 0.2);
    EXPECT_LT(pingDurationSeconds(line, sound_speed), 0.21);
    line.range_scale = 20;
    line.data.assign(1500, 0);
    EXPECT_NEAR(pingDurationSeconds(line, sound_speed), 1545 * 10 / 115'200.0, 1e-9);
}

}  // namespace
}  // namespace echotrail::seanet
