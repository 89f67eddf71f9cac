#include "core/simulation/link_faults.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace echotrail {
namespace {

using namespace std::chrono_literals;
using Kind = LinkHappening::Kind;
using Bytes = std::vector<std::uint8_t>;

constexpr Microseconds read_interval = 10ms;

Bytes counted(std::size_t size) {
    Bytes bytes(size);
    std::iota(bytes.begin(), bytes.end(), std::uint8_t{0});
    return bytes;
}

/// So many reads of 40 bytes, one every 10 ms, through the link, and what comes out until a minute after the last.
std::vector<LinkHappening> sent(LinkFaults& link, int reads) {
    for (int i = 0; i < reads; ++i) link.send(i * read_interval, counted(40));
    return link.takeOutput(reads * read_interval + 60s);
}

Bytes joined(const std::vector<LinkHappening>& happenings) {
    Bytes all;
    for (const auto& happening : happenings) all.insert(all.end(), happening.bytes.begin(), happening.bytes.end());
    return all;
}

Bytes undamaged(int reads) {
    Bytes all;
    for (int i = 0; i < reads; ++i) {
        const Bytes one = counted(40);
        all.insert(all.end(), one.begin(), one.end());
    }
    return all;
}

std::size_t countOf(const std::vector<LinkHappening>& happenings, Kind kind) {
    return static_cast<std::size_t>(std::ranges::count(happenings, kind, &LinkHappening::kind));
}

TEST(LinkFaults, WithoutFaultsEveryReadComesOutAsItWentIn) {
    LinkFaults link({}, 1);
    const auto out = sent(link, 50);
    ASSERT_EQ(out.size(), 50u);
    for (std::size_t i = 0; i < out.size(); ++i) {
        EXPECT_EQ(out[i].at, static_cast<int>(i) * read_interval);
        EXPECT_EQ(out[i].bytes, counted(40));
    }
    EXPECT_TRUE(link.counts().empty());
    EXPECT_FALSE(link.deadline());
}

TEST(LinkFaults, DamagesBytesAsOftenAsItIsTold) {
    LinkFaults corrupting({.corrupted_bytes = 0.05}, 2);
    const Bytes corrupted = joined(sent(corrupting, 1000)), whole = undamaged(1000);
    ASSERT_EQ(corrupted.size(), whole.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < whole.size(); ++i) different += corrupted[i] != whole[i];
    EXPECT_EQ(different, corrupting.counts().at("corrupted"));
    EXPECT_NEAR(static_cast<double>(different), 2000, 200);

    LinkFaults losing({.lost_bytes = 0.05}, 3);
    EXPECT_NEAR(static_cast<double>(joined(sent(losing, 1000)).size()), 38'000, 200);
    LinkFaults doubling({.doubled_bytes = 0.05}, 4);
    EXPECT_NEAR(static_cast<double>(joined(sent(doubling, 1000)).size()), 42'000, 200);
}

TEST(LinkFaults, SplittingAndJoiningChangeNoByte) {
    LinkFaults link({.split_reads = 0.3, .joined_reads = 0.3}, 5);
    const auto out = sent(link, 500);
    EXPECT_EQ(joined(out), undamaged(500));
    EXPECT_GT(link.counts().at("split"), 50u);
    EXPECT_GT(link.counts().at("joined"), 50u);
    EXPECT_TRUE(std::ranges::is_sorted(out, {}, &LinkHappening::at));
    EXPECT_TRUE(std::ranges::none_of(out, [](const auto& o) { return o.bytes.empty(); }));
}

TEST(LinkFaults, AReadThatNoOtherFollowsComesOutAllTheSame) {
    LinkFaults link({.joined_reads = 1.0}, 6);
    link.send(1s, counted(5));
    EXPECT_TRUE(link.takeOutput(1s).empty());
    const auto due = link.deadline();
    ASSERT_TRUE(due);
    EXPECT_LE(*due, Microseconds(1100ms));
    EXPECT_EQ(joined(link.takeOutput(*due)), counted(5));
}

TEST(LinkFaults, AStallHoldsEverythingBackAndLosesNothing) {
    LinkFaults link({.stall_rate = 0.5, .stall_s = 3.0}, 7);
    const auto out = sent(link, 3000);
    EXPECT_EQ(joined(out), undamaged(3000));
    EXPECT_GT(link.counts().at("stall"), 5u);
    Microseconds longest{};
    for (std::size_t i = 1; i < out.size(); ++i) longest = std::max(longest, out[i].at - out[i - 1].at);
    EXPECT_GT(longest, Microseconds(500ms));
    EXPECT_TRUE(std::ranges::is_sorted(out, {}, &LinkHappening::at));
}

TEST(LinkFaults, ABrokenLinkLosesWhatIsSentUntilItIsBack) {
    LinkFaults link({.stall_rate = 0.5, .disconnect_rate = 0.2, .disconnect_s = 4.0}, 8);
    const auto out = sent(link, 6000);
    EXPECT_GT(countOf(out, Kind::Down), 4u);
    EXPECT_EQ(countOf(out, Kind::Down), countOf(out, Kind::Up));
    EXPECT_EQ(joined(out).size() + link.counts().at("lost_while_down"), undamaged(6000).size());
    bool down = false;
    for (const auto& happening : out) {
        if (happening.kind == Kind::Down) {
            EXPECT_FALSE(std::exchange(down, true));
        }
        if (happening.kind == Kind::Up) {
            EXPECT_TRUE(std::exchange(down, false));
        }
        if (happening.kind == Kind::Read) {
            EXPECT_FALSE(down);
        }
    }
    EXPECT_FALSE(link.down());
}

TEST(LinkFaults, GarbageAndRebootsComeByThemselves) {
    LinkFaults link({.garbage_rate = 2.0, .reboot_rate = 0.1}, 9);
    const auto out = link.takeOutput(100s);
    EXPECT_NEAR(static_cast<double>(countOf(out, Kind::Read)), 200, 60);
    EXPECT_NEAR(static_cast<double>(countOf(out, Kind::Reboot)), 10, 9);
    for (const auto& happening : out) EXPECT_LE(happening.bytes.size(), 64u);
}

constexpr LinkFaultParams everything{.corrupted_bytes = 0.001,
                                     .lost_bytes = 0.001,
                                     .doubled_bytes = 0.001,
                                     .split_reads = 0.2,
                                     .joined_reads = 0.2,
                                     .garbage_rate = 0.5,
                                     .stall_rate = 0.2,
                                     .disconnect_rate = 0.1,
                                     .reboot_rate = 0.1};

TEST(LinkFaults, TheSameSeedDoesTheSameHoweverOftenItIsAsked) {
    LinkFaults rarely(everything, 10), often(everything, 10), other(everything, 11);
    const auto expected = sent(rarely, 2000), differing = sent(other, 2000);
    std::vector<LinkHappening> pieces;
    for (Microseconds now{}; now <= 2000 * read_interval + 60s; now += 2ms) {
        if (now % read_interval == Microseconds(0) && now < 2000 * read_interval) often.send(now, counted(40));
        for (auto& happening : often.takeOutput(now)) pieces.push_back(std::move(happening));
    }
    ASSERT_EQ(pieces.size(), expected.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        EXPECT_EQ(pieces[i].kind, expected[i].kind);
        EXPECT_EQ(pieces[i].at, expected[i].at);
        EXPECT_EQ(pieces[i].bytes, expected[i].bytes);
    }
    EXPECT_EQ(often.counts(), rarely.counts());
    EXPECT_NE(joined(differing), joined(expected));
}

TEST(LinkFaults, OneRateChangesNothingAboutTheOtherFaults) {
    const auto disconnects = [](LinkFaultParams params) {
        LinkFaults link(params, 12);
        std::vector<Microseconds> times;
        for (const auto& happening : sent(link, 3000))
            if (happening.kind == Kind::Down) times.push_back(happening.at);
        return times;
    };
    EXPECT_EQ(disconnects({.disconnect_rate = 0.2}),
              disconnects({.corrupted_bytes = 0.1, .split_reads = 0.5, .stall_rate = 1.0, .disconnect_rate = 0.2}));
}

}  // namespace
}  // namespace echotrail
