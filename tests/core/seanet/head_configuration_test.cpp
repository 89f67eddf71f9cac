#include "core/seanet/head_configuration.hpp"

#include "core/seanet/ping_decoder.hpp"
#include "tests/core/seanet/test_bytes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace echotrail::seanet {
namespace {

HeadIdentity seaKing() {
    HeadIdentity head;
    head.version = VersionData{.byte13 = 0x31, .serial = 123};
    head.block = BBUserData{};
    head.block->transmit_khz[0] = 325;
    head.block->transmit_khz[1] = 675;
    return head;
}

HeadIdentity micron() {
    HeadIdentity head;
    head.block = BBUserData{};
    head.block->board_type = 15;
    head.block->head_kind = 3;
    head.block->channel[0] = {.transmit_start_hz = 650'000, .transmit_end_hz = 750'000};
    return head;
}

/// What a head answers that obeys to the letter.
HeadData obedient(const HeadCommand& command) {
    HeadData line;
    const std::size_t channel = command.head_control & 0x80 ? 1 : 0;
    line.device_type = command.head_type;
    line.head_control = command.head_control;
    line.range_scale = command.range_scale;
    line.transmit_word = command.transmit_word[channel];
    line.gain = command.gain[channel];
    line.ad_interval = command.ad_interval;
    line.left_limit = command.left_limit;
    line.right_limit = command.right_limit;
    line.step = command.step;
    line.data.assign(line.eightBit() ? command.bins : command.bins / 2, 0);
    return line;
}

TEST(HeadConfiguration, SynthesiserWordsAreThoseOfTheMakersProgram) {
    const HeadCommand command = commandFor({}, seaKing());
    EXPECT_EQ(command.transmit_word[0], 43'620'761u);
    EXPECT_EQ(command.receive_word[0], 104'689'827u);
    EXPECT_EQ(command.transmit_word[1], 90'596'966u);
    EXPECT_EQ(command.receive_word[1], 151'666'032u);
    EXPECT_EQ(command.slope[0], 90);
    EXPECT_EQ(command.slope[1], 125);
}

TEST(HeadConfiguration, PulseGrowsWithRangeAsInTheMakersSets) {
    const auto pulseAt = [](double range) { return commandFor({.range_m = range}, seaKing()).pulse_us; };
    EXPECT_EQ(pulseAt(6), 40);
    EXPECT_EQ(pulseAt(10), 50);
    EXPECT_EQ(pulseAt(30), 100);
    EXPECT_EQ(pulseAt(450), 350);
}

TEST(HeadConfiguration, ASectorAheadHasTheLimitsOfTheNotes) {
    const HeadCommand command = commandFor({.sector_width_deg = 90}, seaKing());
    EXPECT_EQ(command.left_limit, 2400);
    EXPECT_EQ(command.right_limit, 4000);
    EXPECT_EQ(command.head_control, 0x2381);
}

TEST(HeadConfiguration, ASectorAsternGoesThroughZero) {
    const HeadCommand command = commandFor({.sector_centre_deg = 180, .sector_width_deg = 90}, seaKing());
    EXPECT_EQ(command.left_limit, 5600);
    EXPECT_EQ(command.right_limit, 800);
}

TEST(HeadConfiguration, AFullCircleIsContinuous) {
    const HeadCommand command = commandFor({.sector_width_deg = 360, .channel = Channel::Low}, seaKing());
    EXPECT_EQ(command.head_control, 0x2307);
    EXPECT_EQ(command.left_limit, 1);
    EXPECT_EQ(command.right_limit, 6399);
}

TEST(HeadConfiguration, AnUpsideDownHeadIsToldTheMirroredSector) {
    HeadSettings settings{.sector_centre_deg = 30, .sector_width_deg = 90};
    settings.mount_inverted = true;
    settings.mount_heading_deg = 10;
    const HeadCommand command = commandFor(settings, seaKing());
    EXPECT_NEAR(command.left_limit, 3200 + (-20 - 45) / 0.05625, 0.51);
    EXPECT_EQ(command.head_control & 0x0008, 0);
    EXPECT_NEAR(confirmedSettings(obedient(command), settings).sector_centre_deg, 30, 0.06);
}

TEST(HeadConfiguration, FourBitsAndTheLowChannelAreBits) {
    EXPECT_EQ(commandFor({.channel = Channel::Low, .bits = 4}, seaKing()).head_control, 0x2300);
}

TEST(HeadConfiguration, DigitalHeadsHaveTheirTypeAndOneChannelHasNoSecond) {
    const HeadCommand command = commandFor({.channel = Channel::High}, micron());
    EXPECT_EQ(command.head_type, 0x11);
    EXPECT_EQ(command.head_control & 0x80, 0);
    EXPECT_TRUE(command.channels);
    EXPECT_NEAR(frequencyOf(command.transmit_word[0]), 700e3, 1);
}

TEST(HeadConfiguration, AnOldHeadOfOneChannelGetsTheShortCommand) {
    HeadIdentity head = seaKing();
    head.block->transmit_khz[0] = head.block->transmit_khz[1] = 675;
    EXPECT_FALSE(commandFor({}, head).channels);
}

TEST(HeadConfiguration, TheLineEndsAtTheRangeWithinTwoBinsAndHasAnEvenNumberOfThem) {
    for (double range = 2.0; range <= 450.0; range *= 1.3) {
        const HeadSettings settings{.range_m = range};
        const HeadCommand command = commandFor(settings, seaKing());
        const double bin_m = settings.sound_speed * command.ad_interval * 640e-9 / 2.0;
        EXPECT_NEAR(command.bins * bin_m, range, std::max(2.0 * bin_m, 0.002 * range)) << range;
        EXPECT_EQ(command.bins % 2, 0);
        EXPECT_LE(command.bins, 800);
        EXPECT_GE(command.ad_interval, 10);
    }
}

TEST(HeadConfiguration, AnObedientHeadConfirmsWhateverItWasTold) {
    for (const HeadIdentity& head : {seaKing(), micron()})
        for (const int bits : {4, 8})
            for (const double width : {0.225, 45.0, 360.0}) {
                const HeadCommand command = commandFor({.sector_width_deg = width, .bits = bits}, head);
                EXPECT_EQ(differenceOf(command, obedient(command)), "");
            }
}

TEST(HeadConfiguration, RoundingAndDirectionAreNoDifference) {
    const HeadCommand command = commandFor({}, seaKing());
    HeadData line = obedient(command);
    line.ad_interval = static_cast<std::uint16_t>(line.ad_interval + 1);
    line.head_control ^= 0x0004;
    line.data.push_back(0);
    EXPECT_EQ(differenceOf(command, line), "");
    line.ad_interval = 0;  // some heads do not tell
    EXPECT_EQ(differenceOf(command, line), "");
}

TEST(HeadConfiguration, EveryOtherDifferenceHasAName) {
    const HeadCommand command = commandFor({}, seaKing());
    const auto after = [&](auto change) {
        HeadData line = obedient(command);
        change(line);
        return differenceOf(command, line);
    };
    EXPECT_EQ(after([](HeadData& l) { l.range_scale = 300; }), "range is 30 m, not 50 m");
    EXPECT_EQ(after([](HeadData& l) { l.left_limit = 1600; }), "left limit is -90 deg, not -45 deg");
    EXPECT_EQ(after([](HeadData& l) { l.right_limit = 4800; }), "right limit is 90 deg, not 45 deg");
    EXPECT_EQ(after([](HeadData& l) { l.step = 16; }), "step is 0.9 deg, not 1.8 deg");
    EXPECT_EQ(after([](HeadData& l) { l.gain = 105; }), "gain is 50 %, not 40 %");
    EXPECT_NE(after([](HeadData& l) { l.ad_interval = 200; }), "");
    EXPECT_NE(after([](HeadData& l) { l.data.resize(100); }), "");
    for (const int bit : {0x0001, 0x0002, 0x0010, 0x0020, 0x0080, 0x1000})
        EXPECT_NE(after([&](HeadData& l) { l.head_control = static_cast<std::uint16_t>(l.head_control ^ bit); }), "")
            << bit;
}

TEST(HeadConfiguration, WhatTheHeadConfirmsIsWhatWasSet) {
    const HeadSettings settings{.range_m = 30,
                                .sector_centre_deg = 170,
                                .sector_width_deg = 90,
                                .step_deg = 0.9,
                                .channel = Channel::Low,
                                .gain_percent = 60,
                                .bits = 4};
    const HeadSettings said = confirmedSettings(obedient(commandFor(settings, seaKing())), settings);
    EXPECT_DOUBLE_EQ(said.range_m, 30);
    EXPECT_NEAR(said.sector_centre_deg, 170, 0.06);
    EXPECT_NEAR(said.sector_width_deg, 90, 0.06);
    EXPECT_DOUBLE_EQ(said.step_deg, 0.9);
    EXPECT_EQ(said.channel, Channel::Low);
    EXPECT_NEAR(said.gain_percent, 60, 0.25);
    EXPECT_EQ(said.bits, 4);
}

TEST(HeadConfiguration, OnlyAChangeOfGainFitsTheShortForm) {
    const HeadIdentity head = seaKing();
    const HeadCommand before = commandFor({.gain_percent = 40}, head);
    EXPECT_TRUE(differOnlyInGains(before, commandFor({.gain_percent = 50}, head)));
    EXPECT_FALSE(differOnlyInGains(before, before));
    EXPECT_FALSE(differOnlyInGains(before, commandFor({.range_m = 30, .gain_percent = 50}, head)));
}

TEST(HeadConfiguration, DamagedFrequenciesMakeNoCommandOfNonsense) {
    HeadIdentity dst = micron(), dfs = seaKing();
    dst.block->channel[0] = dst.block->channel[1] = {.transmit_start_hz = 0xFFFFFFFF, .transmit_end_hz = 0xFFFFFFFF};
    dfs.block->transmit_khz[0] = 0xFFFF;
    EXPECT_NEAR(dst.frequencyHz(0), 700e3, 1);
    EXPECT_FALSE(dst.twoChannels());
    EXPECT_EQ(commandFor({}, dfs).transmit_word[0], 43'620'761u);  // as its version says
}

TEST(HeadConfiguration, RealHeadsAreNamedFromTheirReplies) {
    const std::string version = sharedCapture("seaking_dfs_v4log/rep_mtVersionData_seaking_dfs.hex");
    if (version.empty()) GTEST_SKIP() << "needs the shared recordings";
    HeadIdentity head;
    const auto takeFrame = [&](const Frame& frame) {
        const Message message = decodeMessage(frame);
        if (const auto* data = std::get_if<VersionData>(&message)) head.version = *data;
        if (const auto* data = std::get_if<BBUserData>(&message)) head.block = *data;
    };
    FrameParser().take(readHex(version), takeFrame);
    EXPECT_TRUE(head.twoChannels());
    EXPECT_TRUE(head.halfDuplex());  // it has not said
    FrameParser().take(readHex(sharedCapture("seaking_dfs_v4log/rep_mtBBUserData_seaking_dfs.hex")), takeFrame);
    EXPECT_FALSE(head.halfDuplex());
    EXPECT_TRUE(head.text().starts_with("SeaKing DFS"));
    EXPECT_TRUE(head.text().ends_with("node 2, 325/675 kHz")) << head.text();
    FrameParser().take(readHex(sharedCapture("vectors/rep_mtBBUserData_micron_dst.hex")), takeFrame);
    EXPECT_TRUE(head.text().starts_with("Micron DST"));
    EXPECT_TRUE(head.text().ends_with("700 kHz")) << head.text();
}

}  // namespace
}  // namespace echotrail::seanet
