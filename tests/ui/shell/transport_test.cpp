#include "qt_environment.hpp"
#include "ui/panels/transport/moment.hpp"
#include "ui/panels/transport/timeline_view.hpp"
#include "ui/panels/transport/transport_panel.hpp"
#include "ui/style/palette.hpp"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QTest>

namespace echotrail {
namespace {

using test::await;

const Timestamp start{std::chrono::seconds(1'274'601'600)};  // 2010-05-23T08:00:00Z

TEST(Moment, IsReadAsSecondsAsClockOrAsUtc) {
    const auto later = [](double seconds) { return start + microsecondsFromSeconds(seconds); };
    EXPECT_EQ(momentFromText("12.5", start), later(12.5));
    EXPECT_EQ(momentFromText(" 12.5 s ", start), later(12.5));
    EXPECT_EQ(momentFromText("1:02.5", start), later(62.5));
    EXPECT_EQ(momentFromText("1:00:00", start), later(3600));
    EXPECT_EQ(momentFromText("2010-05-23T08:00:12.950Z", start), later(12.95));
    EXPECT_EQ(momentFromText("2010-05-23 08:00:12.950", start), later(12.95));
    for (const char* wrong : {"", "soon", "-3", "1:2:3:4", "2010-13-23T08:00:00Z", "nan", "1e300"})
        EXPECT_FALSE(momentFromText(wrong, start)) << wrong;
}

TEST(Moment, ElapsedTimeNeverRunsAhead) {
    EXPECT_EQ(elapsedText(0.0), "00:00:00.0");
    EXPECT_EQ(elapsedText(83.59), "00:01:23.5");
    EXPECT_EQ(elapsedText(3723.0), "01:02:03.0");
}

TEST(TimeAxis, HasRoundSteps) {
    EXPECT_EQ(timeAxisStep(45.0, 10), 5.0);
    EXPECT_EQ(timeAxisStep(312.4, 11), 30.0);
    EXPECT_EQ(timeAxisStep(86400.0 * 30, 10), 86400.0 * 3);
}

class TimelineViewTest : public testing::Test {
protected:
    TimelineViewTest() {
        std::vector<Timestamp> times;
        for (int i = 0; i < 101; ++i) times.push_back(start + i * std::chrono::milliseconds(100));
        timeline_.ping_times = std::make_shared<const std::vector<Timestamp>>(times);
        timeline_.sweep_starts = {20, 40, 60, 80};
        timeline_.confirmed = {{30, 70}};
        timeline_.gaps = {{50, 51}};
        timeline_.analysed = 101;
        view_.resize(1000, 120);
        view_.setTimeline(timeline_);
        view_.show();
    }
    Timeline timeline_;
    TimelineView view_;
};

TEST_F(TimelineViewTest, PlacesAndPositionsAgree) {
    for (const std::uint64_t position : {1U, 17U, 50U, 100U, 101U})
        EXPECT_EQ(view_.positionAt(view_.xOf(position) + 0.01), position);
    EXPECT_EQ(view_.positionAt(-50.0), 1U);
    EXPECT_EQ(view_.positionAt(5000.0), 101U);
}

TEST_F(TimelineViewTest, ClickAndDragSeek) {
    std::vector<quint64> sought;
    QObject::connect(&view_, &TimelineView::seekRequested, [&](quint64 position) { sought.push_back(position); });
    const int x = static_cast<int>(view_.xOf(50)) + 1;
    QTest::mousePress(&view_, Qt::LeftButton, {}, {x, 40});
    QTest::mouseMove(&view_, {x + 200, 40});
    QTest::mouseRelease(&view_, Qt::LeftButton, {}, {x + 200, 40});
    ASSERT_FALSE(sought.empty());
    EXPECT_NEAR(static_cast<double>(sought.front()), 50.0, 1.0);
}

TEST_F(TimelineViewTest, TheTrackedLaneIsFilledOnlyWhereATrackWasConfirmed) {
    const QImage picture = view_.grab().toImage();
    const auto column = [&](std::uint64_t position) {
        std::vector<QRgb> pixels;
        for (int y = 0; y < picture.height(); ++y)
            pixels.push_back(picture.pixel(static_cast<int>(view_.xOf(position)) + 2, y));
        return pixels;
    };
    EXPECT_NE(column(35), column(25));
    EXPECT_EQ(column(25), column(75));
}

TEST_F(TimelineViewTest, ARunThatLastsIsLookedAtOnly) {
    std::vector<quint64> sought;
    QObject::connect(&view_, &TimelineView::seekRequested, [&](quint64 position) { sought.push_back(position); });
    view_.setLive(true);
    QTest::mouseClick(&view_, Qt::LeftButton, {}, {static_cast<int>(view_.xOf(50)), 40});
    EXPECT_TRUE(sought.empty());
    view_.setLive(false);
    QTest::mouseClick(&view_, Qt::LeftButton, {}, {static_cast<int>(view_.xOf(50)), 40});
    EXPECT_EQ(sought.size(), 1U);
}

TEST_F(TimelineViewTest, WhileNothingComesTheLineGrowsOnBeyondItsLastPing) {
    view_.setLive(true);
    const double end = view_.xOf(101), middle = view_.xOf(50);
    view_.setSilence(10.0);  // as long as all before
    EXPECT_NEAR(view_.xOf(101) - view_.xOf(1), (end - view_.xOf(1)) / 2.0, 1.0);
    EXPECT_LT(view_.xOf(50), middle);
    const auto warned = [&] {
        const QImage picture = view_.grab().toImage();
        const QRgb warning = currentPalette().warning.rgb();
        int pixels = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = static_cast<int>(view_.xOf(101)) + 5; x < picture.width(); ++x)
                pixels += picture.pixel(x, y) == warning;
        return pixels;
    };
    EXPECT_GT(warned(), 100);
    view_.setSilence(0.0);
    EXPECT_EQ(warned(), 0);
    EXPECT_EQ(view_.xOf(101), end);
}

TEST_F(TimelineViewTest, WhatWasFetchedLooksOtherThanWhatWasSeenAndThanAGap) {
    view_.setLive(true);
    const QImage seen = view_.grab().toImage();
    timeline_.recalled = {{50, 90}};
    view_.setTimeline(timeline_);
    const QImage fetched = view_.grab().toImage();
    timeline_.gaps = {{50, 90}};
    timeline_.recalled = {};
    view_.setTimeline(timeline_);
    const QImage missing = view_.grab().toImage();
    EXPECT_NE(seen, fetched);
    EXPECT_NE(seen, missing);
    EXPECT_NE(fetched, missing);
}

TEST(TransportPanel, ShowsWhereReplayStandsAndSpeedsGoUpAndDown) {
    PipelineBridge bridge;
    TransportPanel panel(bridge);
    panel.resize(1200, 200);
    panel.show();
    bridge.open("scan", test::scanOpener(100));
    ASSERT_TRUE(await([&] { return bridge.timeline().pings() == 100; }));
    ASSERT_TRUE(await([&] { return bridge.status().state == ReplayState::Paused; }));
    const int x = static_cast<int>(panel.timeline().xOf(60)) + 1;
    QTest::mouseClick(&panel.timeline(), Qt::LeftButton, {}, {x, 30});
    ASSERT_TRUE(await([&] { return bridge.scene() && bridge.scene()->position == 60; }));
    panel.changeSpeed(1);
    EXPECT_EQ(bridge.speed(), 2.0);
    panel.changeSpeed(100);
    EXPECT_EQ(bridge.speed(), ReplayRunner::max_speed);
    panel.changeSpeed(-100);
    EXPECT_EQ(bridge.speed(), 0.1);
}

}  // namespace
}  // namespace echotrail
