#include "core/seanet/commands.hpp"

#include "tests/core/seanet/test_bytes.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace echotrail::seanet {
namespace {

using nlohmann::json;

class CommandVectors : public testing::Test {
protected:
    void SetUp() override {
        const std::string path = sharedCapture("vectors/expected.json");
        if (path.empty()) GTEST_SKIP() << "needs the shared recordings";
        std::ifstream(path) >> expected_;
    }
    static ByteVector bytesOf(const std::string& name) { return readHex(sharedCapture("vectors/" + name + ".hex")); }
    json expected_;
};

TEST_F(CommandVectors, FixedCommandsAreByteExact) {
    EXPECT_EQ(encodeSendVersion(), bytesOf("cmd_mtSendVersion"));
    EXPECT_EQ(encodeSendBBUser(), bytesOf("cmd_mtSendBBUser"));
    EXPECT_EQ(encodeReBoot(), bytesOf("cmd_mtReBoot"));
    EXPECT_EQ(encodeSendData(61'891'786), bytesOf("cmd_mtSendData"));
    EXPECT_EQ(encodeReverseScan(), bytesOf("cmd_mtHeadCommand_scanreverse_corrected"));
}

json meaningOf(const HeadCommand& c) {
    const ChannelGains& g = *c.channels;
    return {{"type", 29},
            {"hdctrl", c.head_control},
            {"hdtype", c.head_type},
            {"txn1", c.transmit_word[0]},
            {"txn2", c.transmit_word[1]},
            {"rxn1", c.receive_word[0]},
            {"rxn2", c.receive_word[1]},
            {"txpulse_us", c.pulse_us},
            {"rangescale_dm", c.range_scale},
            {"leftlim", c.left_limit},
            {"rightlim", c.right_limit},
            {"adspan", c.ad_span},
            {"adlow", c.ad_low},
            {"igain1", c.gain[0]},
            {"igain2", c.gain[1]},
            {"slope1", c.slope[0]},
            {"slope2", c.slope[1]},
            {"motime_10us", c.motor_time},
            {"step", c.step},
            {"adinterval", c.ad_interval},
            {"nbins", c.bins},
            {"maxadbuf", c.max_buffer},
            {"lockout_us", c.lockout_us},
            {"minoraxis", c.minor_axis},
            {"majoraxis", c.major_axis},
            {"ctl2", c.control2},
            {"scanz", c.scan_z},
            {"v3b",
             {{"adspan1", g.ad_span[0]},
              {"adspan2", g.ad_span[1]},
              {"adlow1", g.ad_low[0]},
              {"adlow2", g.ad_low[1]},
              {"igain1", g.gain[0]},
              {"igain2", g.gain[1]},
              {"adcset1", g.set_point[0]},
              {"adcset2", g.set_point[1]},
              {"slope1", g.slope[0]},
              {"slope2", g.slope[1]},
              {"slopedelay1", g.slope_delay[0]},
              {"slopedelay2", g.slope_delay[1]}}}};
}

TEST_F(CommandVectors, HeadCommandsMatchFieldByFieldAndComeBackByteExact) {
    std::size_t commands = 0;
    for (const auto& [name, meaning] : expected_.items()) {
        if (!meaning.contains("headcommand")) continue;
        SCOPED_TRACE(name);
        const ByteVector bytes = bytesOf(name);
        const auto command = decodeHeadCommand(Frame{bytes}.payload());
        ASSERT_TRUE(command);
        ASSERT_TRUE(command->channels);
        EXPECT_EQ(meaningOf(*command), meaning["headcommand"]);
        EXPECT_EQ(encodeHeadCommand(*command), bytes);
        ++commands;
    }
    EXPECT_EQ(commands, 7u);
}

TEST_F(CommandVectors, GainsMatchAndComeBackByteExact) {
    const ByteVector bytes = bytesOf("drv_mtHeadCommand_gainB_dst_sonia");
    const auto gains = decodeGains(Frame{bytes}.payload());
    ASSERT_TRUE(gains);
    const json& meaning = expected_["drv_mtHeadCommand_gainB_dst_sonia"];
    EXPECT_EQ(json(gains->ad_span), meaning["adspan"]);
    EXPECT_EQ(json(gains->ad_low), meaning["adlow"]);
    EXPECT_EQ(json(gains->gain), meaning["igain"]);
    EXPECT_EQ(json(gains->set_point), meaning["spare"]);
    EXPECT_EQ(json(gains->slope), meaning["slope"]);
    EXPECT_EQ(json(gains->slope_delay), meaning["slopedelay"]);
    EXPECT_EQ(encodeGains(*gains), bytes);
}

TEST(Commands, StopAlivesIsMessage66) {
    EXPECT_EQ(encodeStopAlives(), (ByteVector{'@', '0', '0', '0', '8', 8, 0, 255, 2, 3, 0x42, 0x80, 2, 0x0A}));
}

TEST(Commands, TheNodeIsWhomTheCommandIsFor) {
    for (const FrameBytes& bytes : {encodeSendVersion(5), encodeSendData(1, 5), encodeHeadCommand({}, 5),
                                    encodeGains({}, 5), encodeReverseScan(5), encodeStopAlives(5)}) {
        const Frame frame{bytes};
        EXPECT_EQ(frame.source(), 255);
        EXPECT_EQ(frame.destination(), 5);
        EXPECT_EQ(frame.node(), 5);
        EXPECT_EQ(frame.count(), bytes.size() - 11);
    }
}

TEST(Commands, TheSingleChannelFormComesBackAndOtherLengthsAreNoCommand) {
    HeadCommand command;
    command.range_scale = 300;
    command.slope = {90, 0x1234};
    const FrameBytes bytes = encodeHeadCommand(command);
    const ByteVector payload(bytes.begin() + 13, bytes.end() - 1);
    EXPECT_EQ(payload.front(), 1);
    EXPECT_EQ(decodeHeadCommand(payload), command);
    for (std::size_t length = 0; length < payload.size(); ++length) {
        EXPECT_FALSE(decodeHeadCommand(Bytes(payload).first(length)));
        EXPECT_FALSE(decodeGains(Bytes(payload).first(length)));
    }
}

}  // namespace
}  // namespace echotrail::seanet
