#include "simulated_head_host.hpp"

namespace echotrail {
namespace {

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

}  // namespace
}  // namespace echotrail
