#include "core/simulation/simulated_head.hpp"

#include "core/base/random.hpp"
#include "core/seanet/head_configuration.hpp"
#include "core/seanet/messages.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace echotrail {
namespace {

using namespace std::chrono_literals;
using seanet::MessageId;

std::vector<std::uint8_t> rampEcho(const HeadSetup& head, Microseconds, std::uint64_t) {
    std::vector<std::uint8_t> levels(static_cast<std::size_t>(head.bins));
    for (std::size_t i = 0; i < levels.size(); ++i) levels[i] = static_cast<std::uint8_t>(i);
    return levels;
}

template <class T>
struct Timed {
    Microseconds at{};
    T what;
};

/// The other end of the wire: sends what it is told to, keeps what comes, and may ask for the next line on each line.
class Host {
public:
    explicit Host(const SimulatedHeadOptions& options, EchoFunction echo = rampEcho) : head(options, std::move(echo)) {
        head.powerUp(0us);
    }
    void runUntil(Microseconds end) {
        for (;;) {
            const auto next = head.deadline();
            const bool later = !next || *next > end;
            if (!later) now = std::max(now, *next);
            if (later) now = end;
            head.tick(now);
            for (const TimedBytes& piece : head.takeOutput(now)) take(piece);
            if (later) return;
        }
    }
    void runFor(Microseconds time) { runUntil(now + time); }
    void send(const seanet::FrameBytes& bytes) { head.received(now, bytes); }
    /// Up to where it is centred and has its parameters.
    void prepare(const seanet::HeadCommand& command) {
        runUntil(5s);
        send(seanet::encodeHeadCommand(command));
        runFor(800ms);
    }
    seanet::HeadIdentity identify() {
        send(seanet::encodeSendVersion());
        runFor(100ms);
        send(seanet::encodeSendBBUser());
        runFor(100ms);
        return {.version = version, .block = block, .device_type = 0, .node = seanet::default_head_node};
    }
    void scan(std::size_t count) {
        polling = true;
        send(seanet::encodeSendData(0));
        while (lines.size() < count && now < 1000s) runFor(10ms);
        polling = false;
    }
    std::vector<int> bearings() const {
        std::vector<int> all;
        for (const auto& line : lines) all.push_back(line.what.bearing);
        return all;
    }

    SimulatedHead head;
    Microseconds now{};
    bool polling = false;
    std::vector<Timed<seanet::Alive>> alives;
    std::vector<Timed<seanet::HeadData>> lines;
    std::optional<seanet::VersionData> version;
    std::optional<seanet::BBUserData> block;
    std::vector<int> ids;                            ///< of all that came
    std::map<std::size_t, std::size_t> frame_sizes;  ///< by id

private:
    void take(const TimedBytes& piece) {
        EXPECT_LE(piece.at, now);
        parser_.take(piece.bytes, [&](const seanet::Frame& frame) {
            ids.push_back(frame.id());
            frame_sizes[frame.id()] = frame.bytes.size();
            if (frame.id() == 2) {
                lines.push_back({now, seanet::decodeHeadData(frame.payload()).value()});
                if (polling) send(seanet::encodeSendData(0));
                return;
            }
            const auto message = seanet::decodeMessage(frame);
            if (const auto* alive = std::get_if<seanet::Alive>(&message)) alives.push_back({now, *alive});
            if (const auto* told = std::get_if<seanet::VersionData>(&message)) version = *told;
            if (const auto* told = std::get_if<seanet::BBUserData>(&message)) block = *told;
        });
    }
    seanet::FrameParser parser_;
};

SimulatedHeadOptions dfs() { return {.model = HeadModel::Dfs}; }
SimulatedHeadOptions dst() { return {.model = HeadModel::Dst}; }
SimulatedHeadOptions twoWires() { return {.model = HeadModel::Dst, .half_duplex = true}; }

/// The parameters of the capture of a SeaKing DST at 50 m.
seanet::HeadCommand capturedCommand() {
    seanet::HeadCommand command;
    command.head_control = 0x2381;
    command.range_scale = 500;
    command.left_limit = 1778;
    command.right_limit = 4622;
    command.ad_span = 81;
    command.ad_low = 40;
    command.gain = {84, 105};
    command.step = 32;
    command.ad_interval = 133;
    command.bins = 794;
    return command;
}

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

TEST(SimulatedHead, OneTriggerGivesOneLineOnTwoWiresAndTwoOnFour) {
    Host half(twoWires());
    half.prepare(capturedCommand());
    half.send(seanet::encodeSendData(0));
    half.runFor(500ms);
    EXPECT_EQ(half.lines.size(), 1u);

    Host full(dst());
    full.prepare(capturedCommand());
    full.send(seanet::encodeSendData(0));
    full.runFor(500ms);
    EXPECT_EQ(full.lines.size(), 2u);
    for (int i = 0; i < 5; ++i) full.send(seanet::encodeSendData(0));
    full.runFor(1s);
    EXPECT_EQ(full.lines.size(), 4u);
    EXPECT_EQ(full.head.ignored().at("trigger_too_many"), 4u);
}

/// Mean time from line to line.
Microseconds periodOf(const Host& host) {
    return (host.lines.back().at - host.lines[2].at) / static_cast<int>(host.lines.size() - 3);
}

TEST(SimulatedHead, PingsAsFastAsWaterMotorAndLineAllow) {
    Host full(dst());
    full.prepare(capturedCommand());
    full.scan(40);
    // Captured: 78.4 ms. Water 67.6 ms, motor 8 ms, head 3 ms.
    EXPECT_NEAR(static_cast<double>(periodOf(full).count()), 78'400, 400);

    Host half(twoWires());
    half.prepare(capturedCommand());
    half.scan(40);
    EXPECT_NEAR(static_cast<double>(periodOf(half).count()), 78'600 + 72'800, 500);

    auto slow = dst();
    slow.baud = 9600;
    Host line_bound(slow);
    line_bound.prepare(capturedCommand());
    line_bound.scan(10);
    EXPECT_NEAR(static_cast<double>(periodOf(line_bound).count()), 839 * 10 / 9600.0 * 1e6, 100);
}

TEST(SimulatedHead, TheDigitalModelReachesBothLimitsOnceAndCountsItsStepsFromTheRightOne) {
    Host host(dst());
    host.prepare(capturedCommand());
    host.scan(250);
    const auto at = [&](int bearing) {
        return std::ranges::find(host.lines, bearing, [](const auto& l) { return l.what.bearing; });
    };
    const auto right = at(4622), left = at(1778);
    ASSERT_TRUE(right != host.lines.end() && left != host.lines.end());
    EXPECT_EQ(right->what.sweep_code, 2);
    EXPECT_EQ(left->what.sweep_code, 1);
    EXPECT_FALSE(right->what.clockwise());
    EXPECT_TRUE(left->what.clockwise());
    EXPECT_EQ((right + 1)->what.bearing, 4590);
    EXPECT_EQ((left - 1)->what.bearing, 1806);
    EXPECT_EQ((left + 1)->what.bearing, 1806);
}

TEST(SimulatedHead, TheOldModelKeepsToMultiplesOfItsStepAndGivesTwoLinesAtEachEnd) {
    Host host(dfs());
    auto command = capturedCommand();
    command.left_limit = 2400;
    command.right_limit = 4000;
    command.step = 64;
    host.prepare(command);
    host.scan(110);
    const auto bearings = host.bearings();
    EXPECT_EQ(*std::ranges::min_element(bearings), 2368);
    EXPECT_EQ(*std::ranges::max_element(bearings), 3968);
    const auto end = std::ranges::adjacent_find(host.lines, {}, [](const auto& l) { return l.what.bearing; });
    ASSERT_NE(end, host.lines.end());
    EXPECT_EQ(end->what.bearing, 3968);
    EXPECT_TRUE(end->what.clockwise());
    EXPECT_FALSE((end + 1)->what.clockwise());
    EXPECT_EQ((end + 2)->what.bearing, 3904);
    for (const auto& line : host.lines) EXPECT_EQ(line.what.sweep_code, 0);
}

TEST(SimulatedHead, GoesRoundAndRoundAndTurnsBackWhenToldTo) {
    Host host(dst());
    auto command = capturedCommand();
    command.head_control |= 0x0006;
    command.step = 255;
    command.bins = 40;
    host.prepare(command);
    host.scan(30);
    for (std::size_t i = 1; i < 30; ++i)
        EXPECT_EQ(host.lines[i].what.bearing, (host.lines[i - 1].what.bearing + 255) % 6400);
    host.lines.clear();
    host.runFor(1s);
    host.send(seanet::encodeReverseScan());
    host.scan(4);
    const std::size_t last = host.lines.size() - 1;
    EXPECT_FALSE(host.lines[last].what.clockwise());
    EXPECT_EQ(host.lines[last].what.bearing, (host.lines[last - 1].what.bearing + 6400 - 255) % 6400);
}

TEST(SimulatedHead, FourBitLinesHoldTheWindowWithTheNearerBinInTheHighHalf) {
    Host host(dst());
    auto command = capturedCommand();
    command.head_control &= 0xFFFE;
    command.bins = 255;  // odd: it gives one more
    command.ad_low = 60;
    command.ad_span = 150;
    host.prepare(command);
    host.scan(1);
    const auto& line = host.lines.at(0).what;
    ASSERT_EQ(line.data.size(), 128u);
    EXPECT_EQ(line.data[30], 0x00);         // levels 60 and 61
    EXPECT_EQ(line.data[40], 0x22);         // 80 and 81
    EXPECT_EQ(line.data[42] & 0xF0, 0x20);  // 84: 2.4
    EXPECT_EQ(line.data[42] & 0x0F, 0x03);  // 85: 2.5
    EXPECT_EQ(line.data[110], 0xFF);        // beyond the window
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
