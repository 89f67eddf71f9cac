#include "core/simulation/link_faults.hpp"

#include "core/seanet/head_session.hpp"
#include "core/simulation/simulated_head.hpp"

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

/// A host's session and a head, with a faulty link each way or a good one.
class Conversation {
public:
    Conversation(const SimulatedHeadOptions& options, const LinkFaultParams& faults, std::uint64_t seed)
        : head_(options, [](const HeadSetup& setup, Microseconds,
                            std::uint64_t) { return Bytes(static_cast<std::size_t>(setup.bins), 64); }),
          to_host_(faults, seed),
          to_head_(faults, seed + 1) {
        head_.powerUp(0us);
        session.linkUp(0us);
    }
    void runUntil(Microseconds end, bool faulty) {
        faulty_ = faulty;
        for (;;) {
            Microseconds next = end;
            for (const auto& due : {head_.deadline(), session.deadline()}) next = due ? std::min(next, *due) : next;
            if (faulty)
                for (const auto& due : {to_host_.deadline(), to_head_.deadline()})
                    next = std::min(next, due.value_or(end));
            now_ = std::max(now_, next);
            head_.tick(now_);
            for (const TimedBytes& piece : head_.takeOutput(now_)) {
                if (faulty) to_host_.send(now_, piece.bytes);
                if (!faulty) session.received(now_, piece.bytes);
            }
            if (faulty) passThrough();
            if (session.deadline() && *session.deadline() <= now_) session.tick(now_);
            say();
            if (now_ >= end) return;
        }
    }

    seanet::HeadSession session{HeadSettings{.range_m = 20.0}};

private:
    void passThrough() {
        for (const LinkHappening& happening : to_host_.takeOutput(now_)) {
            if (happening.kind == Kind::Read) session.received(now_, happening.bytes);
            if (happening.kind == Kind::Down) session.linkDown(now_);
            if (happening.kind == Kind::Up) session.linkUp(now_);
            if (happening.kind == Kind::Reboot) head_.powerUp(now_);
        }
        for (const LinkHappening& happening : to_head_.takeOutput(now_))
            if (happening.kind == Kind::Read) head_.received(now_, happening.bytes);
    }
    void say() {
        while (const auto frame = session.takeOutput()) {
            if (faulty_) to_head_.send(now_, *frame);
            if (!faulty_) head_.received(now_, *frame);
        }
    }

    SimulatedHead head_;
    LinkFaults to_host_, to_head_;
    Microseconds now_{};
    bool faulty_ = false;
};

const SimulatedHeadOptions heads[] = {{.model = HeadModel::Dfs},
                                      {.model = HeadModel::Dst},
                                      {.model = HeadModel::Dfs, .half_duplex = true},
                                      {.model = HeadModel::Dst, .half_duplex = true}};

TEST(LinkFaults, OnAGoodLinkASessionScansWithEveryHead) {
    for (const SimulatedHeadOptions& head : heads) {
        Conversation conversation(head, {}, 1);
        conversation.runUntil(30s, true);
        const seanet::HeadStatus& status = conversation.session.status();
        EXPECT_EQ(status.state, seanet::HeadState::Polling);
        EXPECT_EQ(status.half_duplex, head.half_duplex);
        EXPECT_EQ(status.difference, "");
        EXPECT_EQ(status.timeouts + status.rejected + status.head_resets, 0u) << status.head;
        EXPECT_GT(status.pings, 200u);
        conversation.session.setSettings(30s, {.range_m = 60.0, .sector_width_deg = 40.0, .bits = 4});
        conversation.runUntil(35s, true);
        EXPECT_NEAR(status.confirmed.value().range_m, 60.0, 0.1);
        EXPECT_EQ(status.difference, "");
    }
}

TEST(LinkFaults, ASessionScansAgainWhateverTheLinkDidBefore) {
    for (std::uint64_t seed = 0; seed < 6; ++seed)
        for (const SimulatedHeadOptions& head : heads) {
            Conversation conversation(head, everything, seed);
            conversation.runUntil(180s, true);
            const std::uint64_t before = conversation.session.status().pings;
            EXPECT_GT(before, 0u);
            if (conversation.session.status().state == seanet::HeadState::NoLink) conversation.session.linkUp(180s);
            conversation.runUntil(240s, false);
            const seanet::HeadStatus& status = conversation.session.status();
            EXPECT_EQ(status.state, seanet::HeadState::Polling) << "seed " << seed << ' ' << status.advice;
            EXPECT_GT(status.pings, before + 100);
            EXPECT_EQ(status.difference, "");
        }
}

}  // namespace
}  // namespace echotrail
