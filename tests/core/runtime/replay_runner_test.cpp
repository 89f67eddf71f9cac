#include "core/runtime/replay_runner.hpp"

#include "core/runtime/denormals.hpp"
#include "sector_scan.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <thread>

namespace echotrail {
namespace {

using test::ScanSource;
using test::sectorScan;

constexpr std::uint64_t pings = 200;
constexpr std::uint64_t seed = 7;

/// Every track in one line of numbers: equal text means equal tracks to the last bit.
std::string fingerprint(const std::vector<Track>& tracks) {
    std::string text;
    for (const Track& track : tracks) {
        text += std::to_string(track.id) + "/" + std::string(toText(track.state)) + "/" +
                std::to_string(track.estimate.time.time_since_epoch().count()) + (track.target ? "*" : "");
        for (int i = 0; i < 4; ++i)
            text += "," + ParameterInfo::toText(track.estimate.mean(i)) + "±" +
                    ParameterInfo::toText(track.estimate.covariance(i, i));
    }
    return text;
}

/// The tracks after `count` pings of a run without any runner.
std::string straightRun(std::uint64_t count, bool finish = false) {
    flushDenormals();
    ScanSource source(sectorScan(pings));
    ScanningSonarPipeline pipeline({}, seed);
    for (std::uint64_t i = 0; i < count; ++i) pipeline.process(*source.next(), source.navigation());
    if (finish) pipeline.finish();
    return fingerprint(pipeline.tracks());
}

std::unique_ptr<PingSource> scanSource() { return std::make_unique<ScanSource>(sectorScan(pings)); }

/// Waits for what another thread will surely do; a failure is a hang, not a slow machine.
void await(const std::function<bool()>& done) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!done()) {
        ASSERT_LT(std::chrono::steady_clock::now(), deadline) << "the runner hangs";
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

/// The scene once the runner rests at `position`.
Scene sceneAt(ReplayRunner& runner, std::uint64_t position) {
    Scene scene;
    await([&] {
        if (auto next = runner.scenes().take()) scene = std::move(*next);
        const ReplayStatus status = runner.status();
        const bool rests = status.state == ReplayState::Paused || status.state == ReplayState::Ended;
        return rests && status.goal == position && scene.position == position;
    });
    return scene;
}

TEST(ReplayRunner, PlaysToTheEndWithTheTracksOfAStraightRun) {
    ReplayRunner runner(scanSource(), {}, seed);
    runner.setSpeed(ReplayRunner::max_speed);
    runner.play();
    await([&] { return runner.status().state == ReplayState::Ended; });
    const Scene scene = sceneAt(runner, pings);
    EXPECT_TRUE(scene.at_end);
    EXPECT_FALSE(scene.tracks.empty()) << "the comparison below would compare nothing";
    EXPECT_EQ(scene.ping.sequence, pings - 1);
    EXPECT_EQ(fingerprint(scene.tracks), straightRun(pings, true));
}

TEST(ReplayRunner, PausingSteppingAndSeekingShowTheTracksOfAStraightRun) {
    ReplayRunner runner(scanSource(), {}, seed);
    runner.seek(90);
    EXPECT_EQ(fingerprint(sceneAt(runner, 90).tracks), straightRun(90));
    runner.stepPings(1);
    EXPECT_EQ(fingerprint(sceneAt(runner, 91).tracks), straightRun(91));
    runner.stepPings(-3);
    EXPECT_EQ(fingerprint(sceneAt(runner, 88).tracks), straightRun(88));
    runner.setSpeed(ReplayRunner::max_speed);
    runner.play();
    runner.pause();
    runner.seek(150);
    EXPECT_EQ(fingerprint(sceneAt(runner, 150).tracks), straightRun(150));
    runner.seek(0);
    EXPECT_EQ(sceneAt(runner, 0).tracks.size(), 0U);
    runner.seek(1000);
    EXPECT_EQ(fingerprint(sceneAt(runner, pings).tracks), straightRun(pings, true));
}

TEST(ReplayRunner, StepsAddUpWhileASeekIsUnderWay) {
    ReplayRunner runner(scanSource(), {}, seed);
    runner.seek(100);
    for (int i = 0; i < 5; ++i) runner.stepPings(1);
    EXPECT_EQ(sceneAt(runner, 105).ping.sequence, 104U);
}

TEST(ReplayRunner, SeeksToTheMomentAsked) {
    ReplayRunner runner(scanSource(), {}, seed);
    runner.seekTime(Timestamp(std::chrono::milliseconds(1000'000 + 50 * 60 + 20)));
    EXPECT_EQ(sceneAt(runner, 61).ping.sequence, 60U);
}

TEST(ReplayRunner, PlayAtTheEndStartsAgain) {
    ReplayRunner runner(scanSource(), {}, seed);
    runner.setSpeed(ReplayRunner::max_speed);
    runner.seek(pings);
    sceneAt(runner, pings);
    runner.setSpeed(0.1);
    runner.play();
    await([&] { return runner.status().state == ReplayState::Playing && runner.status().position < 5; });
}

TEST(ReplayRunner, ALoopIsPlayedAgainAndAgain) {
    ReplayRunner runner(scanSource(), {}, seed);
    runner.setLoop(PingSpan{20, 60});
    runner.setSpeed(40.0);
    runner.seek(20);
    runner.play();
    int rounds = 0;
    std::uint64_t last = 0;
    await([&] {
        if (const auto scene = runner.scenes().take()) {
            EXPECT_LE(scene->position, 60U);
            if (scene->position < last) ++rounds;
            last = scene->position;
        }
        return rounds >= 3;
    });
}

TEST(ReplayRunner, ParametersTakeEffectAtOnceWhilePausedAndCarryTheirRevision) {
    ReplayRunner runner(scanSource(), {}, seed);
    runner.seek(80);
    sceneAt(runner, 80);
    ScanningSonarPipeline::Params params;
    params.head.mount_heading_deg = 30.0;
    runner.setParams(params, 5);
    await([&] { return runner.status().revision == 5; });
    ScanSource source(sectorScan(pings));
    ScanningSonarPipeline pipeline(params, seed);
    for (int i = 0; i < 80; ++i) pipeline.process(*source.next(), source.navigation());
    EXPECT_EQ(fingerprint(sceneAt(runner, 80).tracks), fingerprint(pipeline.tracks()));
}

TEST(ReplayRunner, TheTimelineCoversTheWholeRecordingBeforePlay) {
    ReplayRunner runner(scanSource(), {}, seed);
    Timeline timeline;
    await([&] {
        if (auto next = runner.timelines().take()) timeline = std::move(*next);
        return timeline.analysed == pings;
    });
    EXPECT_EQ(timeline.pings(), pings);
    EXPECT_EQ(timeline.ping_times->front(), sectorScan(1)[0].time);
    EXPECT_TRUE(timeline.gaps.empty());
}

TEST(ReplayRunner, ADesignationIsMetAgainAfterASeekBack) {
    ReplayRunner runner(scanSource(), {}, seed);
    runner.seek(100);
    sceneAt(runner, 100);
    runner.designate(15.0, Bearing::degrees(4));
    await([&] { return runner.status().designated; });
    runner.seek(50);
    sceneAt(runner, 50);
    EXPECT_FALSE(runner.status().designated);
    runner.seek(120);
    sceneAt(runner, 120);
    EXPECT_TRUE(runner.status().designated);
    runner.clearDesignation();
    await([&] { return !runner.status().designated; });
}

TEST(ReplayRunner, ADroppedTrackIsGoneFromThereOnAndComesBackWhenTakenBack) {
    ReplayRunner runner(scanSource(), {}, seed);
    runner.seek(100);
    const Scene before = sceneAt(runner, 100);
    ASSERT_EQ(before.tracks.size(), 1u);
    const Track& track = before.tracks.front();
    const Eigen::Vector2d place = track.estimate.mean.head<2>();  // the vehicle stands still at the origin
    runner.drop(track.id, place.norm(), Bearing::radians(std::atan2(place.y(), place.x())));
    runner.seek(110);
    EXPECT_TRUE(sceneAt(runner, 110).tracks.empty());
    runner.seek(50);
    EXPECT_FALSE(sceneAt(runner, 50).tracks.empty()) << "it was dropped later";
    runner.seek(120);
    EXPECT_TRUE(sceneAt(runner, 120).tracks.empty());
    runner.restore(track.id);
    runner.seek(125);
    EXPECT_EQ(sceneAt(runner, 125).tracks.size(), 1u);
}

TEST(ReplayRunner, EndsPromptlyInEveryState) {
    { const ReplayRunner loading(scanSource(), {}, seed); }
    const std::vector<std::function<void(ReplayRunner&)>> states{
        [](ReplayRunner& runner) { sceneAt(runner, 0); }, [](ReplayRunner& runner) { runner.play(); },
        [](ReplayRunner& runner) {
            runner.setSpeed(0.001);
            runner.play();
            await([&] { return runner.status().position > 0; });
        },
        [](ReplayRunner& runner) { runner.seek(pings); },
        [](ReplayRunner& runner) {
            runner.seek(pings);
            runner.seek(10);
            runner.setParams({}, 1);
        }};
    for (const auto& state : states) {
        ReplayRunner runner(scanSource(), {}, seed);
        state(runner);
    }
}

TEST(ReplayRunner, AnEmptyRecordingIsAtItsEnd) {
    ReplayRunner runner(std::make_unique<ScanSource>(std::vector<Ping>{}), {}, seed);
    runner.play();
    await([&] { return runner.status().state == ReplayState::Ended; });
    EXPECT_EQ(runner.status().total, 0U);
}

TEST(ReplayRunner, AFailingSourceBecomesALineInTheStatus) {
    ReplayRunner runner(std::make_unique<test::VanishingSource>(sectorScan(pings)), {}, seed);
    await([&] { return runner.status().state == ReplayState::Failed; });
    EXPECT_EQ(runner.status().error, "replay stopped: drive removed");
    runner.play();
}

}  // namespace
}  // namespace echotrail
