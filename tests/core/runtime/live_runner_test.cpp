#include "core/runtime/live_runner.hpp"

#include "core/recording/echotrail_log.hpp"
#include "core/recording/update_text.hpp"
#include "core/seanet/head_data.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

namespace echotrail {
namespace {

/// A line of a head, as it sends it: a bright patch at so many bins, at places 23 to 25 of 0 to 50, on a dark ground.
std::vector<std::uint8_t> lineAt(int place, bool clockwise, int bin) {
    seanet::HeadData line;
    line.device_type = 2;
    line.head_control = clockwise ? 0x2305 : 0x2301;
    line.range_scale = 500;
    line.ad_interval = 130;
    line.left_limit = 2400;
    line.right_limit = 4000;
    line.step = 32;
    line.bearing = static_cast<std::uint16_t>(2400 + 32 * place);
    line.data.assign(800, 20);
    for (int b = bin; b < bin + 12; ++b)
        if (place >= 23 && place <= 25) line.data[static_cast<std::size_t>(b)] = 160;
    return seanet::encodeHeadData(line);
}

/// A scan to and fro: the patch begins at 20 m and comes nearer.
std::vector<std::vector<std::uint8_t>> scan(int sweeps) {
    std::vector<std::vector<std::uint8_t>> frames;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        for (int i = 0; i <= 50; ++i) {
            const bool clockwise = sweep % 2 == 0;
            frames.push_back(lineAt(clockwise ? i : 50 - i, clockwise, 320 - 4 * sweep));
        }
    }
    return frames;
}

std::vector<std::uint8_t> bytesOf(std::string_view text) { return {text.begin(), text.end()}; }

class Live : public testing::Test {
protected:
    void SetUp() override {
        path_ =
            testing::TempDir() + "live_" + testing::UnitTest::GetInstance()->current_test_info()->name() + ".echotrail";
        std::filesystem::remove(path_);
    }
    void TearDown() override { std::filesystem::remove(path_); }
    std::unique_ptr<LogWriter> log(std::uint64_t seed, const LiveRunner::Params& params) {
        auto writer = LogWriter::create(path_, {"test", "head", parameterText(params), seed, Timestamp{}});
        EXPECT_TRUE(writer) << writer.error();
        return *std::move(writer);
    }
    /// The looks of the recording, run again.
    std::vector<std::string> again() {
        auto source = EchotrailLog::open(path_, {});
        EXPECT_TRUE(source) << source.error();
        LiveRunner::Params params;
        EXPECT_TRUE(applyRecordedParameters(params, (*source)->recordedRun()->parameters));
        ScanningSonarPipeline pipeline(params, (*source)->recordedRun()->seed);
        std::vector<std::string> looks;
        const auto collect = [&](const Update& update) {
            for (const TrackLook& look : update.looks) looks.push_back(lookText(look));
        };
        while (const auto ping = (*source)->next()) {
            for (const RunControl& control : (*source)->takeControls()) {
                if (control.kind == RunControl::Kind::Parameters) {
                    EXPECT_TRUE(applyRecordedParameters(params, control.parameters));
                    pipeline.setParams(params);
                } else {
                    pipeline.command(control);
                }
            }
            collect(pipeline.process(*ping, (*source)->navigation()));
        }
        collect(pipeline.finish());
        return looks;
    }
    std::string path_;
};

/// A run under a clock of the test's own: what is posted is taken in before the clock goes on.
class Paced {
public:
    Paced(const LiveRunner::Params& params, std::unique_ptr<LogWriter> log, LiveRunner::Listener listener)
        : runner(params, 5, std::move(log), std::move(listener), [this] { return Microseconds(now_us_.load()); }) {}
    void post(EventKind kind, std::vector<std::uint8_t> payload) {
        runner.post(kind, std::move(payload));
        settle(1);
    }
    /// Until so many more events are taken in.
    void settle(std::uint64_t events) {
        taken_ += events;
        while (runner.status().events < taken_) std::this_thread::yield();
    }
    void wait(std::int64_t us) { now_us_ += us; }

private:
    std::atomic<std::int64_t> now_us_ = 0;
    std::uint64_t taken_ = 1;  // the parameters at the beginning

public:
    LiveRunner runner;
};

TEST_F(Live, ItsRecordingGivesTheSameLooksBitForBit) {
    std::vector<std::string> live;
    const LiveRunner::Params params;
    {
        Paced run(params, log(5, params), [&](const Update& update, Timestamp, const ScanningSonarPipeline&) {
            for (const TrackLook& look : update.looks) live.push_back(lookText(look));
        });
        run.settle(0);
        run.runner.designate(20.0, Bearing::degrees(0.0));
        run.settle(1);
        int sent = 0;
        for (const auto& frame : scan(8)) {
            run.wait(80'000);
            run.post(EventKind::SonarBytes, {frame.begin(), frame.begin() + 200});
            run.wait(20'000);
            if (sent % 40 == 7) run.post(EventKind::NavigationBytes, bytesOf("$HEHDT,010.0,T*2D\r\n"));
            if (sent == 90) {
                auto changed = params;
                changed.regions.screen.seed_excess_db += 1.0;
                run.runner.setParams(changed);
                run.settle(1);
            }
            if (sent == 150) {
                run.post(EventKind::SonarLink, bytesOf("down"));
                run.post(EventKind::SonarLink, bytesOf("up"));
            } else {
                run.post(EventKind::SonarBytes, {frame.begin() + 200, frame.end()});
            }
            ++sent;
        }
        run.runner.finish();
        run.runner.closeLog();
        const LiveStatus status = run.runner.status();
        EXPECT_EQ(status.pings, 407u);
        EXPECT_EQ(status.skipped, 0u);
        EXPECT_EQ(status.counts.rejected.at("cut_frame"), 1u);
        EXPECT_FALSE(status.recorder.recording);
        EXPECT_EQ(status.recorder.error, "");
    }
    EXPECT_GT(live.size(), 4u);
    EXPECT_EQ(again(), live);

    const auto reader = LogReader::open(path_);
    ASSERT_TRUE(reader);
    EXPECT_EQ((*reader)->summary(), "{\"pings\":407}");
    std::vector<std::string> recorded;
    while (const auto result = (*reader)->nextResult())
        if (result->kind == UpdateKind::Track) recorded.push_back(result->text);
    EXPECT_EQ(recorded, live);
}

TEST_F(Live, AHeadThatFollowsTheTargetLooksMoreOftenAndItsRecordingGivesTheSameLooksBitForBit) {
    LiveRunner::Params params;
    params.follow.follow_target = true;
    std::vector<std::string> live;
    int narrow = 0;
    {
        Paced run(params, log(5, params), [&](const Update& update, Timestamp, const ScanningSonarPipeline&) {
            for (const TrackLook& look : update.looks) live.push_back(lookText(look));
        });
        run.settle(0);
        run.runner.designate(20.0, Bearing::degrees(0.0));
        run.settle(1);
        bool clockwise = true;
        int place = 0;
        for (int sent = 0; sent < 400; ++sent) {
            run.wait(100'000);
            run.post(EventKind::SonarBytes, lineAt(place, clockwise, 320));
            const ScanSector sector = run.runner.sector().value_or(ScanSector{});
            narrow += sector.width_deg < 45.0;
            EXPECT_TRUE(contains({}, sector));
            const int first = static_cast<int>(std::lround((sector.centre_deg - sector.width_deg / 2 + 45.0) / 1.8)),
                      last = first + static_cast<int>(std::lround(sector.width_deg / 1.8));
            place = std::clamp(place + (clockwise ? 1 : -1), first, last);
            if (place == first) clockwise = true;
            if (place == last) clockwise = false;
        }
        run.runner.finish();
        run.runner.closeLog();
        EXPECT_EQ(run.runner.status().pings, 400u);
    }
    EXPECT_GT(narrow, 100);
    EXPECT_GT(live.size(), 12u) << "8 sweeps of the whole sector would give as many looks";
    EXPECT_EQ(again(), live);
}

TEST_F(Live, WhatWasDroppedAndTakenBackIsSoInItsRecordingToo) {
    std::vector<std::string> live;
    const LiveRunner::Params params;
    std::atomic<int> tracks = 0;
    {
        Paced run(params, log(5, params),
                  [&](const Update& update, Timestamp, const ScanningSonarPipeline& pipeline) {
                      for (const TrackLook& look : update.looks) live.push_back(lookText(look));
                      tracks = static_cast<int>(pipeline.tracks().size());
                  });
        run.settle(0);
        const auto frames = scan(12);
        const auto sweeps = [&](int from, int to) {
            for (int i = 51 * from; i < 51 * to; ++i) {
                run.wait(100'000);
                run.post(EventKind::SonarBytes, frames[static_cast<std::size_t>(i)]);
            }
        };
        sweeps(0, 4);
        ASSERT_EQ(tracks, 1);
        run.runner.drop(1, 19.5, Bearing::degrees(-1.0));
        run.settle(1);
        sweeps(4, 8);
        EXPECT_EQ(tracks, 0);
        run.runner.restore(1);
        run.settle(1);
        sweeps(8, 12);
        EXPECT_EQ(tracks, 1);
    }
    EXPECT_GT(live.size(), 4u);
    EXPECT_LT(live.size(), 12u) << "not of the sweeps in between";
    EXPECT_EQ(again(), live);
}

TEST_F(Live, WhatTheTrackerCouldNotTakeInTimeIsSkippedInTheReplayToo) {
    std::vector<std::string> live;
    const LiveRunner::Params params;
    std::atomic<bool> stuck = false;
    {
        Paced run(params, log(5, params), [&](const Update& update, Timestamp, const ScanningSonarPipeline&) {
            while (stuck) std::this_thread::yield();
            for (const TrackLook& look : update.looks) live.push_back(lookText(look));
        });
        run.settle(0);
        int sent = 0;
        for (const auto& frame : scan(8)) {
            run.wait(100'000);
            if (sent == 200) {  // the tracker stands still for 5 s, while ten pings come
                stuck = true;
                for (int i = 0; i < 10; ++i) run.runner.post(EventKind::SonarBytes, frame);
                run.wait(5'000'000);
                stuck = false;
                run.settle(10);
            } else {
                run.post(EventKind::SonarBytes, frame);
            }
            ++sent;
        }
        run.runner.finish();
        run.runner.closeLog();
        EXPECT_GE(run.runner.status().skipped, 5u);
        EXPECT_LE(run.runner.status().skipped, 10u);
        EXPECT_EQ(run.runner.status().pings + run.runner.status().skipped, 417u);
    }
    EXPECT_EQ(again(), live);
}

TEST_F(Live, WithoutALogItTracksAllTheSame) {
    LiveRunner runner({}, 1, nullptr);
    for (const auto& frame : scan(3)) runner.post(EventKind::SonarBytes, frame);
    runner.finish();
    EXPECT_EQ(runner.status().pings, 153u);
    EXPECT_FALSE(runner.status().recorder.recording);
    EXPECT_TRUE(runner.scenes().take());
}

TEST_F(Live, ScenesCarryTheEnhancedPictureWhileItIsAskedFor) {
    Paced run({}, nullptr, {});
    const auto frames = scan(1);
    const auto sceneAfter = [&](std::size_t first) {
        (void)run.runner.scenes().take();
        for (std::size_t i = first; i < first + 4; ++i) run.post(EventKind::SonarBytes, frames[i]);
        return run.runner.scenes().take();
    };
    EXPECT_TRUE(sceneAfter(0)->enhanced.empty());
    run.runner.setEnhanced(true);
    const auto asked = sceneAfter(4);
    ASSERT_TRUE(asked);
    EXPECT_EQ(asked->enhanced.levels.size(), asked->fan.levels.size());
    EXPECT_FALSE(asked->fan.empty());
    run.runner.setEnhanced(false);
    EXPECT_TRUE(sceneAfter(8)->enhanced.empty());
}

TEST_F(Live, ScenesKnowWhereOnEarthTheyAreOnceThereIsAFix) {
    Paced run({}, nullptr, {});
    const auto frames = scan(1);
    const auto sceneAfter = [&](std::size_t first, const char* fix) {
        (void)run.runner.scenes().take();
        for (std::size_t i = first; i < first + 20; ++i) {
            run.wait(100'000);
            run.post(EventKind::NavigationBytes, bytesOf("$HEHDT,010.0,T*2E\r\n"));
            if (*fix) run.post(EventKind::NavigationBytes, bytesOf(fix));
            run.post(EventKind::SonarBytes, frames[i]);
        }
        return run.runner.scenes().take();
    };
    const auto without = sceneAfter(0, "");
    ASSERT_TRUE(without);
    EXPECT_FALSE(without->plane);
    const auto with = sceneAfter(20, "$GPGGA,000000.00,6024.0000,N,00500.0000,E,1,08,1.0,0.0,M,0.0,M,,*50\r\n");
    ASSERT_TRUE(with && with->plane);
    const Pose& pose = with->latest.pose;
    const GeographicPosition here = with->plane->toGeographic({pose.north_m, pose.east_m});
    EXPECT_NEAR(degreesFromRadians(here.latitude_rad), 60.4, 1e-7);
    EXPECT_NEAR(degreesFromRadians(here.longitude_rad), 5.0, 1e-7);
}

}  // namespace
}  // namespace echotrail
