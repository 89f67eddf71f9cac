#include "core/base/random.hpp"
#include "simulated_head_host.hpp"

namespace echotrail {
namespace {

TEST(SimulatedHead, IsSilentWhileItBootsThenTellsEverySecondThatItIsAliveUntilItIsCentred) {
    Host host(dst());
    host.runUntil(1400ms);
    EXPECT_TRUE(host.ids.empty());
    host.runUntil(8s);
    ASSERT_GE(host.alives.size(), 6u);
    EXPECT_EQ(host.alives[0].what.head_info, 0x5D);
    EXPECT_EQ(host.alives[2].what.head_info, 0x4D);
    EXPECT_EQ(host.alives.back().what.head_info, 0x4A);
    for (std::size_t i = 1; i < host.alives.size(); ++i)
        EXPECT_EQ(host.alives[i].at - host.alives[i - 1].at, Microseconds(1s));
    EXPECT_EQ(host.frame_sizes[4], 22u);
}

TEST(SimulatedHead, ParametersAreReceivedThenValidatedAndTheOldModelThenWillSend) {
    for (const auto& options : {dfs(), dst()}) {
        Host host(options);
        host.runUntil(6400ms);
        host.send(seanet::encodeHeadCommand(capturedCommand()));
        host.runUntil(8s);
        ASSERT_GE(host.alives.size(), 3u);
        EXPECT_EQ(host.alives[host.alives.size() - 2].what.head_info, 0xCA);
        EXPECT_EQ(host.alives.back().what.head_info, 0x8A);
        EXPECT_EQ(host.alives.back().what.will_send, options.model == HeadModel::Dfs ? 0x00 : 0x80);
    }
}

TEST(SimulatedHead, TheHostReadsFromItsAnswersWhichHeadItIs) {
    Host old(dfs());
    old.runUntil(2s);
    EXPECT_EQ(old.identify().text(), "SeaKing DFS, serial 2347, node 2, 325/675 kHz");
    EXPECT_FALSE(old.identify().halfDuplex());
    EXPECT_EQ(old.frame_sizes[1], 25u);
    EXPECT_EQ(old.frame_sizes[6], 264u);

    Host digital(twoWires());
    digital.runUntil(2s);
    EXPECT_EQ(digital.identify().text(), "SeaKing DST, node 2, 325/675 kHz");
    EXPECT_TRUE(digital.identify().halfDuplex());
    EXPECT_EQ(digital.frame_sizes[6], 264u);
    EXPECT_EQ(digital.frame_sizes[63], 80u);
    EXPECT_EQ(digital.frame_sizes[57], 28u);
}

TEST(SimulatedHead, ItsLinesConfirmWhateverTheOperatorSet) {
    const HeadSettings wide{.range_m = 30, .sector_width_deg = 360, .gain_percent = 55};
    const HeadSettings coarse{.range_m = 100, .sector_width_deg = 60, .channel = Channel::Low, .bits = 4};
    const HeadSettings astern{.sector_centre_deg = 170, .sector_width_deg = 40, .step_deg = 0.9};
    for (const auto& options : {dfs(), dst(), twoWires()})
        for (const HeadSettings& settings : {wide, coarse, astern}) {
            Host host(options);
            host.runUntil(5s);
            const auto command = seanet::commandFor(settings, host.identify());
            host.send(seanet::encodeHeadCommand(command));
            host.scan(3);
            ASSERT_EQ(host.lines.size(), 3u);
            for (const auto& line : host.lines) EXPECT_EQ(seanet::differenceOf(command, line.what), "");
        }
}

TEST(SimulatedHead, NewParametersTakeEffectAfterThePingUnderWayAndGainsAtOnce) {
    Host host(dst());
    host.prepare(capturedCommand());
    host.scan(3);
    auto other = capturedCommand();
    other.range_scale = 300;
    host.send(seanet::encodeHeadCommand(other));
    host.runFor(1s);
    EXPECT_EQ(host.lines[3].what.range_scale, 500);
    EXPECT_EQ(host.lines.back().what.range_scale, 300);
    host.send(seanet::encodeGains({.gain = {10, 20}}));
    host.scan(host.lines.size() + 1);
    EXPECT_EQ(host.lines.back().what.gain, 20);  // channel 2 is in use
    EXPECT_EQ(host.lines.back().what.range_scale, 300);
}

TEST(SimulatedHead, TheEchoIsAskedForWithWhatTheParametersMean) {
    std::vector<HeadSetup> asked;
    std::vector<std::uint64_t> numbers;
    Host host(dfs(), [&](const HeadSetup& head, Microseconds at, std::uint64_t number) {
        asked.push_back(head);
        numbers.push_back(number);
        return rampEcho(head, at, number);
    });
    auto command = capturedCommand();
    command.transmit_word = {43620761, 90596966};
    command.left_limit = command.right_limit = 4000;
    host.prepare(command);
    host.scan(3);
    EXPECT_EQ(numbers[2], 2u);
    EXPECT_DOUBLE_EQ(asked[0].range_m, 50.0);
    EXPECT_EQ(asked[0].bins, 794);
    EXPECT_NEAR(asked[0].binSize(), 0.0634, 1e-4);  // at 1490 m/s
    EXPECT_NEAR(asked[0].bearing.inDegrees(), 45.0, 1e-9);
    EXPECT_NEAR(asked[0].frequency_hz, 675e3, 1.0);
    EXPECT_NEAR(asked[0].gain_db, 40.0, 1e-9);
    EXPECT_EQ(asked[0].bits, 8);
}

TEST(SimulatedHead, ItsOwnRoundingOfTheBinIntervalIsInTheLine) {
    auto options = dst();
    options.interval_multiple = 8;
    Host host(options);
    host.prepare(capturedCommand());
    host.scan(1);
    EXPECT_EQ(host.lines.at(0).what.ad_interval, 136);
}

TEST(SimulatedHead, RebootLosesTheParametersAndWhatWasUnderWay) {
    Host host(dst());
    host.prepare(capturedCommand());
    host.scan(3);
    const std::size_t before = host.lines.size();
    host.send(seanet::encodeReBoot());
    host.send(seanet::encodeSendData(0));
    host.alives.clear();
    host.runFor(8s);
    EXPECT_EQ(host.lines.size(), before);
    ASSERT_FALSE(host.alives.empty());
    EXPECT_TRUE(host.alives.front().what.inCentre());
    EXPECT_TRUE(host.alives.back().what.centred());
    EXPECT_TRUE(host.alives.back().what.needsParameters());
    host.send(seanet::encodeSendData(0));
    host.runFor(1s);
    EXPECT_EQ(host.lines.size(), before);
    EXPECT_EQ(host.head.ignored().at("no_parameters"), 1u);
}

TEST(SimulatedHead, NoAlivesWhileItScansNorAfterTheyWereStopped) {
    Host host(dst());
    host.prepare(capturedCommand());
    const std::size_t before = host.alives.size();
    host.scan(40);
    EXPECT_EQ(host.alives.size(), before);
    host.runFor(3s);
    EXPECT_EQ(host.alives.size(), before + 2);
    host.send(seanet::encodeStopAlives());
    host.runFor(5s);
    EXPECT_EQ(host.alives.size(), before + 2);
}

TEST(SimulatedHead, TheMotorRestsAtTheCentreAfterAMinuteAndATriggerWakesIt) {
    Host host(dst());
    host.prepare(capturedCommand());
    host.scan(20);
    host.runFor(3s);
    EXPECT_TRUE(host.alives.back().what.offCentre());
    EXPECT_TRUE(host.alives.back().what.motorOn());
    host.runFor(61s);
    EXPECT_FALSE(host.alives.back().what.motorOn());
    EXPECT_EQ(host.alives.back().what.transducer, 3200);
    const std::size_t before = host.lines.size();
    host.scan(before + 1);
    EXPECT_NEAR(host.lines[before].what.bearing, 3200, 16);
}

TEST(SimulatedHead, OnTwoWiresWhatIsSentWhileItSendsIsLost) {
    Host host(twoWires());
    host.prepare(capturedCommand());
    host.send(seanet::encodeSendData(0));
    host.runFor(100ms);  // the line is on its way
    host.send(seanet::encodeSendVersion());
    host.runFor(1s);
    EXPECT_EQ(host.lines.size(), 1u);
    EXPECT_FALSE(host.version.has_value());
    EXPECT_EQ(host.head.ignored().at("collision_bytes"), 14u);
}

TEST(SimulatedHead, AnswersOnlyToItsNode) {
    auto options = dst();
    options.node = 4;
    Host host(options);
    host.runUntil(5s);
    host.send(seanet::encodeSendVersion(2));
    host.runFor(500ms);
    EXPECT_FALSE(host.version.has_value());
    host.send(seanet::encodeSendVersion(4));
    host.runFor(500ms);
    EXPECT_EQ(host.version->node, 4);
}

TEST(SimulatedHead, RefusesParametersThatMakeNoLine) {
    Host host(dst());
    host.runUntil(5s);
    for (const auto member : {&seanet::HeadCommand::bins, &seanet::HeadCommand::ad_interval}) {
        auto command = capturedCommand();
        command.*member = 0;
        host.send(seanet::encodeHeadCommand(command));
    }
    host.send(seanet::encodeGains({}));
    host.send(seanet::encodeSendData(0));
    host.runFor(2s);
    EXPECT_TRUE(host.lines.empty());
    EXPECT_EQ(host.head.ignored().at("bad_parameters"), 2u);
}

TEST(SimulatedHead, DamagedCommandsNeverBreakIt) {
    for (std::uint64_t trial = 0; trial < 60; ++trial) {
        SimulatedHeadOptions options = trial % 2 ? dfs() : dst();
        options.half_duplex = trial % 3 == 0;
        options.boot_s = 0;
        options.centring_s = 0;
        Host host(options);
        RandomStream random(7, trial, 0);
        for (int i = 0; i < 200; ++i) {
            // Where the lengths stay right a damaged command is a whole frame with any parameters.
            auto bytes = i % 3 ? seanet::encodeSendData(random.bits()) : seanet::encodeHeadCommand(capturedCommand());
            const std::size_t last = bytes.size() - 1;
            for (int n = 0; n < 4; ++n) {
                const std::size_t at = random.bits() % bytes.size();
                if (at > 8 && at < last) bytes[at] = static_cast<std::uint8_t>(random.bits());
            }
            if (i % 7 == 0) bytes.resize(random.bits() % bytes.size());
            host.send(bytes);
            host.runFor(Microseconds(random.bits() % 200'000));
        }
        for (const auto& line : host.lines) {
            EXPECT_LT(line.what.bearing, 6400);
            EXPECT_FALSE(line.what.data.empty());
        }
    }
}

}  // namespace
}  // namespace echotrail
