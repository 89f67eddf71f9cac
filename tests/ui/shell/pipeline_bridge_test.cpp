#include "ui/bridge/pipeline_bridge.hpp"

#include "qt_environment.hpp"

#include <gtest/gtest.h>

#include <QFileInfo>
#include <atomic>
#include <stdexcept>
#include <thread>

namespace echotrail {
namespace {

using test::await;
using test::scanOpener;

PipelineBridge::Params withParticles(int particles) {
    PipelineBridge::Params params;
    EXPECT_TRUE(setParameter(params, "particles", particles));
    return params;
}

/// A run with 500 particles, and from its 50th ping on with 700.
class RecordedScan : public test::ScanSource {
public:
    RecordedScan() : ScanSource(test::sectorScan(100)) {}
    std::optional<RecordedRun> recordedRun() const override {
        return RecordedRun{9, parameterText(withParticles(500))};
    }
    std::optional<Ping> next() override {
        auto ping = ScanSource::next();
        if (ping && ping->sequence == 50)
            controls_.push_back(
                {.kind = RunControl::Kind::Parameters, .parameters = parameterText(withParticles(700))});
        return ping;
    }
    void rewind() override {
        controls_.clear();
        ScanSource::rewind();
    }
    std::vector<RunControl> takeControls() override { return std::exchange(controls_, {}); }

private:
    std::vector<RunControl> controls_;
};

class PipelineBridgeTest : public testing::Test {
protected:
    PipelineBridgeTest() {
        QObject::connect(&bridge_, &PipelineBridge::opened, [this] { ++opened_; });
        QObject::connect(&bridge_, &PipelineBridge::openFailed,
                         [this](const QString&, const QString& reason) { failure_ = reason; });
    }
    void openRecordedRun() {
        bridge_.open("run", []() -> SourceOpener::Outcome {
            return std::unique_ptr<PingSource>(std::make_unique<RecordedScan>());
        });
        ASSERT_TRUE(await([&] { return bridge_.timeline().analysed == 100 && rests(); }));
    }
    /// The particles of the parameters that the forms show.
    int particles() const { return std::get<int>(parameter(bridge_.params(), "particles").value()); }
    bool rests() const {
        return bridge_.status().state == ReplayState::Paused && bridge_.status().goal == bridge_.status().position;
    }

    PipelineBridge bridge_;
    int opened_ = 0;
    QString failure_;
};

TEST_F(PipelineBridgeTest, OpensInTheBackgroundAndShowsScenes) {
    bridge_.open("scan", scanOpener(100));
    EXPECT_TRUE(bridge_.isOpening());
    EXPECT_EQ(opened_, 0);
    ASSERT_TRUE(await([&] { return opened_ == 1; }));
    bridge_.seekPosition(50);
    ASSERT_TRUE(await([&] { return bridge_.scene() && bridge_.scene()->position == 50; }));
    EXPECT_EQ(bridge_.timeline().pings(), 100U);
}

TEST_F(PipelineBridgeTest, AFailureSaysWhyAndKeepsWhatWasOpen) {
    bridge_.open("scan", scanOpener(100));
    ASSERT_TRUE(await([&] { return opened_ == 1; }));
    bridge_.open("broken", []() -> SourceOpener::Outcome { return Error{"not a recording"}; });
    ASSERT_TRUE(await([&] { return !failure_.isEmpty(); }));
    EXPECT_EQ(failure_, "not a recording");
    EXPECT_TRUE(bridge_.isOpen());
    bridge_.open("worse", []() -> SourceOpener::Outcome { throw std::runtime_error("disk gone"); });
    ASSERT_TRUE(await([&] { return failure_ == "disk gone"; }));
}

TEST_F(PipelineBridgeTest, ACancelledOpeningNeverArrives) {
    auto gate = std::make_shared<std::atomic<bool>>(false);
    bridge_.open("slow", [gate]() -> SourceOpener::Outcome {
        while (!*gate) std::this_thread::yield();
        return std::unique_ptr<PingSource>(std::make_unique<test::ScanSource>(test::sectorScan(10)));
    });
    bridge_.cancelOpening();
    *gate = true;
    bridge_.open("scan", scanOpener(100));
    ASSERT_TRUE(await([&] { return opened_ == 1 && bridge_.timeline().pings() > 0; }));
    EXPECT_EQ(bridge_.timeline().pings(), 100U);
}

TEST_F(PipelineBridgeTest, SkippedSecondsAddUp) {
    bridge_.open("scan", scanOpener(400));
    ASSERT_TRUE(await([&] { return bridge_.timeline().pings() == 400 && rests(); }));
    bridge_.seekSeconds(5.0);
    ASSERT_TRUE(await([&] { return rests() && bridge_.status().position == 101; }));
    bridge_.skipSeconds(5.0);
    ASSERT_TRUE(await([&] { return rests() && bridge_.status().position == 201; }));
    bridge_.skipSeconds(-100.0);
    ASSERT_TRUE(await([&] { return rests() && bridge_.status().position == 1; }));
}

TEST_F(PipelineBridgeTest, ARealRecordingIsOpenedAndItsTargetFollowedToTheEnd) {
    const QString path = ECHOTRAIL_SHARED_DATA "/seanet/seaking_dfs_v4log/seaking_dfs_first312.V4LOG";
    if (!QFileInfo::exists(path)) GTEST_SKIP() << "needs the shared recordings";
    bridge_.openRecording(path);
    ASSERT_TRUE(await([&] { return opened_ == 1; }));
    ASSERT_TRUE(await([&] { return bridge_.timeline().analysed == 312; }));
    const auto& confirmed = bridge_.timeline().confirmed;
    ASSERT_FALSE(confirmed.empty());
    EXPECT_EQ(confirmed.back().end, 312U);
    bridge_.seekPosition(312);
    ASSERT_TRUE(await([&] { return bridge_.scene() && bridge_.scene()->at_end; }));
    EXPECT_FALSE(bridge_.scene()->tracks.empty());
    EXPECT_FALSE(bridge_.scene()->fan.empty());
}

TEST_F(PipelineBridgeTest, ARecordedRunBringsItsParametersAsTheyWereAtEachPingAndTakesThemAway) {
    bridge_.setParams(withParticles(1000));
    openRecordedRun();
    EXPECT_TRUE(bridge_.isAsRecorded());
    EXPECT_EQ(particles(), 500);
    bridge_.seekPosition(80);
    ASSERT_TRUE(await([&] { return rests() && bridge_.status().position == 80; }));
    EXPECT_TRUE(await([&] { return particles() == 700; }));
    bridge_.seekPosition(10);
    EXPECT_TRUE(await([&] { return particles() == 500; }));
    bridge_.close();
    EXPECT_EQ(particles(), 1000);
}

TEST_F(PipelineBridgeTest, WhatIsSetWhileLookingAtARecordedRunCountsAndStays) {
    openRecordedRun();
    bridge_.setParams(withParticles(300));
    EXPECT_FALSE(bridge_.isAsRecorded());
    bridge_.seekPosition(80);
    ASSERT_TRUE(await([&] { return rests() && bridge_.status().position == 80; }));
    EXPECT_EQ(particles(), 300);
    bridge_.close();
    EXPECT_EQ(particles(), 300);
}

TEST_F(PipelineBridgeTest, WhatTheCommandLineSetsCountsOverARecordedRun) {
    bridge_.setParams(withParticles(1000));
    bridge_.setOverridesRecorded(true);
    openRecordedRun();
    EXPECT_FALSE(bridge_.isAsRecorded());
    EXPECT_EQ(particles(), 1000);
}

TEST_F(PipelineBridgeTest, ClosingLeavesNothingBehind) {
    bridge_.open("scan", scanOpener(100));
    ASSERT_TRUE(await([&] { return opened_ == 1; }));
    bridge_.play();
    bridge_.close();
    EXPECT_FALSE(bridge_.isOpen());
    EXPECT_EQ(bridge_.timeline().pings(), 0U);
    bridge_.play();
    bridge_.poll();
    EXPECT_FALSE(bridge_.isOpen());
}

}  // namespace
}  // namespace echotrail
