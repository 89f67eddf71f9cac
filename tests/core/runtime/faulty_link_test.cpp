#include "core/pipelines/scanning_sonar_pipeline.hpp"
#include "core/recording/ping_feed.hpp"
#include "core/seanet/head_session.hpp"
#include "core/simulation/link_faults.hpp"
#include "core/simulation/ping_model.hpp"
#include "core/simulation/simulated_head.hpp"
#include "core/simulation/simulated_source.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace echotrail {
namespace {

using namespace std::chrono_literals;
using Bytes = std::vector<std::uint8_t>;

/// Everything at once, so often that the head is ready for a few sweeps at a time.
constexpr LinkFaultParams everything{.corrupted_bytes = 2e-5,
                                     .lost_bytes = 2e-5,
                                     .doubled_bytes = 2e-5,
                                     .split_reads = 0.2,
                                     .joined_reads = 0.2,
                                     .garbage_rate = 0.3,
                                     .stall_rate = 0.05,
                                     .stall_s = 2.0,
                                     .disconnect_rate = 0.02,
                                     .disconnect_s = 3.0,
                                     .reboot_rate = 0.02};

/// From the head being ready to its next trouble, in pings that reached the tracker.
struct Ready {
    int pings = 0;
    int pings_to_look = -1;  ///< until an echo of the target was used again; −1: not yet
};

/// A head that hears a scenario, its session over a link with faults, and the tracker: all in simulated time.
class FaultyRun {
public:
    FaultyRun(const LinkFaultParams& faults, std::uint64_t seed)
        : scenario_(findScenario("deep").value()),
          head_({.boot_s = 0.5, .centring_s = 1.0},
                [this, seed](const HeadSetup& setup, Microseconds at, std::uint64_t number) {
                    if (first_ < 0us) first_ = at;
                    return simulateEcho(scenario_, seed, setup, std::chrono::duration<double>(at - first_).count(),
                                        number);
                }),
          to_host_(faults, seed),
          to_head_(faults, seed + 1) {
        head_.powerUp(0us);
        session.linkUp(0us);
        post(EventKind::SonarLink, bytesOf("up"));
    }

    void runUntil(Microseconds end) {
        while (now_ < end) {
            Microseconds next = end;
            for (const auto& due : {head_.deadline(), session.deadline(), to_host_.deadline(), to_head_.deadline()})
                next = std::min(next, due.value_or(end));
            now_ = std::max(now_ + 1us, next);
            head_.tick(now_);
            for (const TimedBytes& piece : head_.takeOutput(now_)) to_host_.send(now_, piece.bytes);
            passThrough();
            if (session.deadline() && *session.deadline() <= now_) session.tick(now_);
            while (const auto frame = session.takeOutput()) to_head_.send(now_, *frame);
            followReadiness();
            track();
        }
    }

    seanet::HeadSession session{HeadSettings{}};
    PingFeed feed{1490.0, 1.0};
    std::vector<Ready> ready;
    int looks_at_target = 0;

private:
    static Bytes bytesOf(std::string_view text) { return {text.begin(), text.end()}; }
    void post(EventKind kind, const Bytes& payload) {
        feed.take({number_++, kind, simulation_start + now_, now_, payload});
    }
    void passThrough() {
        for (const LinkHappening& happening : to_host_.takeOutput(now_)) {
            switch (happening.kind) {
                case LinkHappening::Kind::Read:
                    post(EventKind::SonarBytes, happening.bytes);
                    session.received(now_, happening.bytes);
                    break;
                case LinkHappening::Kind::Down:
                    post(EventKind::SonarLink, bytesOf("down"));
                    session.linkDown(now_);
                    break;
                case LinkHappening::Kind::Up:
                    post(EventKind::SonarLink, bytesOf("up"));
                    session.linkUp(now_);
                    break;
                case LinkHappening::Kind::Reboot:
                    head_.powerUp(now_);
                    break;
            }
        }
        for (const LinkHappening& happening : to_head_.takeOutput(now_))
            if (happening.kind == LinkHappening::Kind::Read) head_.received(now_, happening.bytes);
    }
    void followReadiness() {
        const bool polls = session.status().state == seanet::HeadState::Polling;
        if (polls && !polled_) ready.emplace_back();
        polled_ = polls;
    }
    Eigen::Vector2d targetAt(Timestamp time) const {
        const double since_s = secondsBetween(simulation_start + first_, time);
        return targetMotion(scenario_.targets.front(), since_s).position_m;
    }
    void track() {
        while (const auto ping = feed.next()) {
            const Update& update = pipeline_.process(*ping, feed.navigation());
            const bool seen = std::ranges::any_of(update.looks, [this](const TrackLook& look) {
                return look.seen && (look.position_m - targetAt(look.time)).norm() < 3.0;
            });
            looks_at_target += seen;
            if (!polled_ || ready.empty()) continue;
            ++ready.back().pings;
            if (seen && ready.back().pings_to_look < 0) ready.back().pings_to_look = ready.back().pings;
        }
    }

    Scenario scenario_;
    Microseconds first_{-1};
    SimulatedHead head_;
    LinkFaults to_host_, to_head_;
    ScanningSonarPipeline pipeline_{{}, 1};
    Microseconds now_{};
    std::uint64_t number_ = 0;
    bool polled_ = false;
};

TEST(FaultyLink, WithEveryFaultAtOnceTheTrackerSeesItsTargetWithinTwoSweepsOfEveryReadiness) {
    constexpr int pings_per_sweep = 51;
    int interruptions = 0, resumed = 0;
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        FaultyRun run(everything, seed);
        run.runUntil(120s);
        const SourceCounts counts = run.feed.counts();
        EXPECT_FALSE(counts.rejected.empty()) << "what was damaged is counted";
        EXPECT_GT(counts.skipped_bytes, 0u);
        EXPECT_GT(run.session.status().timeouts, 0u);
        EXPECT_GT(run.looks_at_target, 5);
        interruptions += static_cast<int>(run.ready.size()) - 1;
        for (std::size_t i = 0; i < run.ready.size(); ++i) {
            const Ready& ready = run.ready[i];
            if (ready.pings < 2 * pings_per_sweep && ready.pings_to_look < 0) continue;  // broken again before
            EXPECT_GT(ready.pings_to_look, 0) << "seed " << seed << ", readiness " << i;
            EXPECT_LE(ready.pings_to_look, 2 * pings_per_sweep) << "seed " << seed << ", readiness " << i;
            ++resumed;
        }
    }
    EXPECT_GE(interruptions, 4);
    EXPECT_GE(resumed, 4) << "else nothing was held to anything";
}

}  // namespace
}  // namespace echotrail
