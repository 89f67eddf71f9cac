#include "core/link/datagram_way.hpp"
#include "core/link/link.pb.h"
#include "core/link/replay_window.hpp"
#include "tests/core/link/link_pair.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

namespace echotrail::test {
namespace {

const LinkDatagrams offer{7'000, 42, std::string(link_limits::datagram_key_bytes, 'k')};

/// A console that takes datagrams, and a way for them that loses all but every so-manyth.
struct Ashore {
    explicit Ashore(Wire& to, std::uint64_t bytes_per_second = 0) : wire(to), console("shore") {
        console.client = LinkClient({{"shore", "test"}, true, bytes_per_second, true});
        console.number = *wire.server.connected(wire.now(), offer);
        console.client.linkUp(wire.monotonic());
        wire.carry({&console});
    }
    void carryDatagrams() {
        if (const auto up = console.client.datagramToSend(wire.monotonic()); up && way_up)
            wire.server.receivedDatagram(console.number, wire.now(), bytesOf(*up));
        for (const std::string& text : wire.server.takeDatagrams(console.number)) {
            ++number;
            texts.push_back(text);
            if (loses > 0 && number % loses == 0) continue;
            if (way_down) console.client.receivedDatagram(wire.monotonic(), number, bytesOf(text));
        }
        Wire::takeEvents(console);
    }
    void run(double seconds, bool pings = true) {
        for (int left = static_cast<int>(std::lround(seconds / 0.05)); left > 0; --left) {
            if (pings) wire.ping(pinged++);
            wire.run(0.05, {&console});
            carryDatagrams();
        }
    }
    Wire& wire;
    Console console;
    std::uint64_t number = 0, pinged = 0, loses = 0;
    bool way_up = true, way_down = true;
    std::vector<std::string> texts;
};

TEST(LinkDatagrams, StreamsGoByThemAsSoonAsTheyAreKnownToArrive) {
    Wire wire;
    Ashore ashore(wire);
    ASSERT_TRUE(ashore.console.client.status().welcome.datagrams);
    EXPECT_EQ(ashore.console.client.status().welcome.datagrams->key, offer.key);
    ashore.run(1.0);
    const std::uint64_t before = ashore.console.client.status().datagrams;
    const std::size_t beams = ashore.console.heard<LinkBeam>().size();
    ashore.run(1.0);
    EXPECT_GE(ashore.console.client.status().datagrams, before + 20U) << "each beam, and echoes";
    EXPECT_EQ(ashore.console.heard<LinkBeam>().size(), beams + 20U);
    EXPECT_EQ(ashore.console.heard<LinkTracks>().size(), 40U) << "by TCP";
    EXPECT_EQ(ashore.console.client.status().gaps, 0U);
    EXPECT_EQ(ashore.console.client.status().malformed, 0U);
    for (const std::string& text : ashore.texts) EXPECT_LE(text.size(), link_limits::longest_datagram_text);
}

TEST(LinkDatagrams, WhereTheyDoNotArriveAllComesByTcp) {
    for (const bool up : {true, false}) {
        Wire wire;
        Ashore ashore(wire);
        (up ? ashore.way_down : ashore.way_up) = false;
        ashore.run(3.0);
        EXPECT_EQ(ashore.console.heard<LinkBeam>().size(), 60U);
        EXPECT_EQ(ashore.console.client.status().datagrams, 0U);
    }
}

TEST(LinkDatagrams, AWayThatBreaksIsLeftAndTakenAgain) {
    Wire wire;
    Ashore ashore(wire);
    ashore.run(1.0);
    ashore.way_down = false;
    ashore.run(2.5);
    ashore.console.events.clear();
    ashore.run(1.0);
    EXPECT_EQ(ashore.console.heard<LinkBeam>().size(), 20U) << "by TCP";
    ashore.way_down = true;
    ashore.run(1.0);
    const auto before = ashore.console.client.status().datagrams;
    ashore.run(1.0);
    EXPECT_GE(ashore.console.client.status().datagrams, before + 20U);
}

TEST(LinkDatagrams, LossIsAReasonToSendLess) {
    Wire wire;
    Ashore ashore(wire);
    ashore.run(1.0);
    EXPECT_EQ(wire.server.levelOf(ashore.console.number, wire.now()), SendQueue::Everything);
    ashore.loses = 3;
    ashore.run(6.0);
    EXPECT_GT(wire.server.levelOf(ashore.console.number, wire.now()), SendQueue::Everything);
    EXPECT_GT(ashore.console.client.status().gaps, 0U);
    EXPECT_EQ(ashore.console.heard<LinkTracks>().size(), 140U) << "none of them";
    ashore.loses = 0;
    ashore.run(60.0);
    EXPECT_EQ(wire.server.levelOf(ashore.console.number, wire.now()), SendQueue::Everything);
}

/// A console told of loss every half second for so long.
SendQueue::Level levelAfter(std::uint64_t lost_of_ten, double seconds) {
    DatagramWay way;
    std::uint64_t newest = 0, received = 0;
    for (double t = 0.0; t < seconds; t += 0.5) {
        newest += 10;
        received += 10 - lost_of_ten;
        way.report(newest, received, at(t));
    }
    return way.level();
}

TEST(LinkDatagrams, LossByChanceCostsDetailOnly) {
    EXPECT_EQ(levelAfter(1, 60.0), SendQueue::Everything);
    EXPECT_EQ(levelAfter(2, 60.0), SendQueue::QuarterDetail);
    EXPECT_EQ(levelAfter(4, 60.0), SendQueue::QuarterDetail);
    EXPECT_EQ(levelAfter(6, 60.0), SendQueue::NoPicture);
}

TEST(LinkDatagrams, ChanceAloneTakesNoPictureAway) {
    DatagramWay way;
    std::mt19937 chance(1);
    std::bernoulli_distribution arrives(0.8);
    std::uint64_t newest = 0, received = 0;
    for (double t = 0.0; t < 600.0; t += 0.25) {  // five in each report: two of them lost is nothing rare
        for (int i = 0; i < 5; ++i, ++newest) received += arrives(chance);
        way.report(newest, received, at(t));
        ASSERT_LE(way.level(), SendQueue::NoParticles) << "at " << t << " s";
    }
    EXPECT_GE(way.level(), SendQueue::HalfDetail);
}

TEST(LinkDatagrams, WhatWasLeftOutComesBackWhenLessIsLost) {
    DatagramWay way;
    std::uint64_t newest = 0, received = 0;
    const auto run = [&](std::uint64_t lost_of_ten, double from, double to) {
        for (double t = from; t < to; t += 0.5) {
            newest += 10;
            received += 10 - lost_of_ten;
            way.report(newest, received, at(t));
        }
        return way.level();
    };
    EXPECT_EQ(run(6, 0.0, 60.0), SendQueue::NoPicture);
    EXPECT_EQ(run(2, 60.0, 120.0), SendQueue::QuarterDetail) << "some loss is no reason to go without";
    EXPECT_EQ(run(0, 120.0, 180.0), SendQueue::Everything);
}

TEST(LinkDatagrams, TheyKeepToTheLimitOfTheConsole) {
    Wire wire;
    Ashore ashore(wire, 20'000);
    ashore.run(20.0);
    ashore.texts.clear();
    ashore.run(10.0);
    std::size_t bytes = 0;
    for (const std::string& text : ashore.texts) bytes += text.size();
    EXPECT_LT(bytes, 220'000U);
    EXPECT_GT(bytes, 1'000U) << "something goes";
    EXPECT_GT(wire.server.levelOf(ashore.console.number, wire.now()), SendQueue::Everything);
}

TEST(LinkDatagrams, OnlyTheNewestWaitAndOnlyStreamsAreBelieved) {
    DatagramWay way;
    const auto frame = [](std::size_t bytes, char c) { return std::make_shared<const std::string>(bytes, c); };
    EXPECT_FALSE(way.works(at(0.0)));
    EXPECT_FALSE(DatagramWay::fits(frame(link_limits::longest_datagram_text + link_frame_head + 1, 'x')));
    for (int i = 0; i < 200; ++i) way.add(frame(100, static_cast<char>('a' + i % 26)));
    const auto texts = way.take();
    ASSERT_EQ(texts.size(), link_limits::most_datagrams);
    EXPECT_EQ(texts.back()[0], 'a' + 199 % 26);
    way.report(3, 4, at(0.0));
    EXPECT_FALSE(way.works(at(0.0))) << "more than were sent";
    way.report(10, 10, at(0.0));
    EXPECT_TRUE(way.works(at(1.0)));
    EXPECT_FALSE(way.works(at(3.0)));

    Wire wire;
    Ashore ashore(wire);
    wire::ToConsole message;
    message.mutable_refusal()->set_reason("go");
    ashore.console.client.receivedDatagram(wire.monotonic(), 1, bytesOf(message.SerializeAsString()));
    EXPECT_FALSE(ashore.console.client.wantsToClose());
    EXPECT_EQ(ashore.console.client.status().malformed, 1U);
    wire::ToTracker command;
    command.mutable_clear_designation();
    wire.server.receivedDatagram(ashore.console.number, wire.now(), bytesOf(command.SerializeAsString()));
    EXPECT_FALSE(wire.server.nextRequest(wire.now())) << "nobody commands by them";
    EXPECT_EQ(wire.server.counts().malformed, 1U);
}

TEST(ReplayWindow, TakesEachNumberOnceAndNoneThatIsTooOld) {
    ReplayWindow window;
    EXPECT_FALSE(window.accept(0));
    std::set<std::uint64_t> taken;
    // Steps to and fro, small and beyond the window, against a set that forgets nothing.
    std::uint64_t state = 1, newest = 0;
    for (int i = 0; i < 20'000; ++i) {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        const std::uint64_t step = (state >> 33) % 100;
        const std::uint64_t back = (state >> 40) % (step == 0 ? 5'000 : 1'200);
        const std::uint64_t number = step == 1 ? newest + 2'000 : newest + 3 > back ? newest + 3 - back : 1;
        const bool too_old = newest >= ReplayWindow::width && number <= newest - ReplayWindow::width;
        ASSERT_EQ(window.accept(number), !too_old && !taken.contains(number)) << number << " after " << newest;
        taken.insert(number);
        newest = std::max(newest, number);
    }
}

}  // namespace
}  // namespace echotrail::test
