#include "app/io/head_link.hpp"

#include "core/recording/echotrail_log.hpp"
#include "core/recording/log_reader.hpp"
#include "tests/app/io/event_loop.hpp"
#include "tests/app/io/simulated_peer.hpp"

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <cmath>

namespace echotrail {
namespace {

using seanet::HeadState;

/// A runner and its links to a head, in this thread.
struct LiveRun {
    explicit LiveRun(const std::string& sonar, const std::string& navigation = {},
                     std::unique_ptr<LogWriter> log = nullptr, const LiveRunner::Params& params = {})
        : runner(params, 0, std::move(log)), link(parseLiveAddresses(sonar, navigation).value(), params.head, runner) {
        QObject::connect(&link, &HeadLink::noted, [this](const QString& text) { notes += text; });
        link.open();
    }
    HeadState head() const { return link.state().head.state; }

    LiveRunner runner;
    HeadLink link;
    QStringList notes;
};

TEST(HeadLink, BringsAHeadToScanningAndItsPingsToTheTracker) {
    SimulatedPeer peer;
    LiveRun run(peer.address());
    ASSERT_TRUE(becomes([&] { return run.runner.status().pings >= 5; }));
    const HeadLinkState state = run.link.state();
    EXPECT_TRUE(state.sonar.up);
    EXPECT_EQ(state.head.state, HeadState::Polling);
    EXPECT_FALSE(state.head.head.empty()) << "it said what it is";
    EXPECT_TRUE(state.head.confirmed.has_value());
    EXPECT_TRUE(state.head.difference.empty()) << state.head.difference;
    EXPECT_TRUE(state.sonar.last_bytes.has_value());
    EXPECT_FALSE(state.navigation.has_value());
    EXPECT_TRUE(becomes([&] { return run.runner.scenes().take().has_value(); }));
}

TEST(HeadLink, AChangeOfSettingsIsConfirmedByTheHeadItself) {
    SimulatedPeer peer;
    LiveRun run(peer.address());
    ASSERT_TRUE(becomes([&] { return run.link.state().head.confirmed.has_value(); }));
    HeadSettings wanted;
    wanted.range_m = 20.0;
    wanted.sector_width_deg = 60.0;
    run.link.setSettings(wanted);
    EXPECT_EQ(run.link.state().head.commanded.range_m, 20.0);
    ASSERT_TRUE(becomes([&] {
        const auto confirmed = run.link.state().head.confirmed;
        return confirmed && confirmed->range_m == 20.0;
    }));
    EXPECT_TRUE(becomes([&] { return run.link.state().head.difference.empty(); }));
}

TEST(HeadLink, WhereTheHeadFollowsItScansAboutTheTargetAndNeverBeyondTheOperatorsSector) {
    // An object ahead, and nothing else.
    SimulatedPeer peer("tcp://127.0.0.1:0", SimulatedPeer::quick(), [](const HeadSetup& setup) {
        return std::abs(setup.bearing.inDegrees()) < 2.0;
    });
    LiveRunner::Params params;
    params.head.range_m = 10.0;
    params.head.sector_width_deg = 50.0;
    params.follow = {.follow_target = true, .follow_least_width_deg = 10.0};
    params.tracker.life.confirm_looks = 2;
    LiveRun run(peer.address(), {}, nullptr, params);
    run.runner.designate(5.0, Bearing::degrees(0.0));
    ASSERT_TRUE(becomes([&] { return run.runner.sector().has_value(); })) << "it is confirmed, and followed";
    ASSERT_TRUE(becomes([&] {
        const auto head = run.link.state().head;
        return head.confirmed && head.confirmed->sector_width_deg < 45.0 && head.difference.empty();
    })) << "the head itself says so";
    EXPECT_TRUE(contains(scanSector(params.head), scanSector(run.link.state().head.commanded)));

    params.head.sector_centre_deg = 90.0;  // the target is outside of it
    run.runner.setParams(params);
    run.link.setSettings(params.head);
    EXPECT_EQ(scanSector(run.link.state().head.commanded), scanSector(params.head)) << "at once";
    ASSERT_TRUE(becomes([&] { return !run.runner.sector(); }));
}

TEST(HeadLink, ABrokenLinkIsSaidMadeAgainAndScanningGoesOn) {
    SimulatedPeer peer;
    LiveRun run(peer.address());
    ASSERT_TRUE(becomes([&] { return run.head() == HeadState::Polling; }));
    peer.server().drop();
    ASSERT_TRUE(becomes([&] { return !run.link.state().sonar.up; }));
    EXPECT_FALSE(run.link.state().sonar.reason.empty());
    EXPECT_EQ(run.head(), HeadState::NoLink);
    ASSERT_TRUE(becomes([&] { return run.head() == HeadState::Polling; }));
    const auto pings = run.runner.status().pings;
    EXPECT_TRUE(becomes([&] { return run.runner.status().pings > pings; }));
    EXPECT_EQ(run.link.state().sonar.counts.times_up, 2U);
    EXPECT_EQ(run.notes.filter(": connected").size(), 2);
}

TEST(HeadLink, NothingAtTheAddressIsAReasonNotAnError) {
    std::string nowhere;
    {
        Listener gone("tcp://127.0.0.1:0");
        nowhere = gone.address();
    }
    LiveRun run(nowhere);
    ASSERT_TRUE(becomes([&] { return !run.link.state().sonar.reason.empty(); }));
    EXPECT_FALSE(run.link.state().sonar.up);
    EXPECT_EQ(run.head(), HeadState::NoLink);
}

TEST(HeadLink, AnotherDeviceOnTheLineMovesNothingAndGivesAdvice) {
    Listener device("tcp://127.0.0.1:0");
    LiveRun run(device.address());
    ASSERT_TRUE(becomes([&] { return device.ups == 1; }));
    ASSERT_TRUE(becomes([&] {
        device.server->send("$GPGGA,,,,,,0,,,,,,,,*66\r\n" + everyByte());
        return run.head() == HeadState::WrongDevice || run.head() == HeadState::Silent;
    }));
    EXPECT_FALSE(run.link.state().head.advice.empty());
    EXPECT_EQ(run.runner.status().pings, 0U);
}

TEST(HeadLink, AClosedLinkIsStillAndOpensAgain) {
    SimulatedPeer peer;
    LiveRun run(peer.address());
    ASSERT_TRUE(becomes([&] { return run.head() == HeadState::Polling; }));
    run.link.close();
    EXPECT_FALSE(run.link.state().sonar.up);
    EXPECT_EQ(run.head(), HeadState::NoLink);
    run.link.setSettings({.range_m = 30.0});
    run.link.open();
    ASSERT_TRUE(becomes([&] { return run.head() == HeadState::Polling; }));
    EXPECT_EQ(run.link.state().head.commanded.range_m, 30.0);
}

TEST(HeadLink, NavigationReachesTheTrackerWithItsOwnLinkState) {
    SimulatedPeer peer;
    Listener compass("tcp://127.0.0.1:0");
    LiveRun run(peer.address(), compass.address());
    EXPECT_TRUE(run.link.state().navigation.has_value());
    ASSERT_TRUE(becomes([&] { return run.link.state().navigation->up && compass.ups == 1; }));
    compass.server->send("$HEHDT,123.4,T*2B\r\n");
    ASSERT_TRUE(becomes([&] { return run.runner.status().navigation.heading.has_value(); }));
    EXPECT_NEAR(run.runner.status().navigation.heading->inDegrees(), 123.4, 1e-6);
    EXPECT_TRUE(run.link.state().navigation->last_bytes.has_value());
}

TEST(HeadLink, AHeadSimulatedHereIsAHeadLikeAnyOtherWithNavigation) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("run.echotrail").toStdString();
    {
        LiveRun run("simulation://demo?seed=7", {}, LogWriter::create(path, {}).value());
        EXPECT_TRUE(run.link.state().navigation.has_value()) << "it brings its own";
        ASSERT_TRUE(becomes([&] { return run.runner.status().pings >= 5; }));
        EXPECT_TRUE(run.link.state().sonar.up);
        EXPECT_TRUE(run.link.state().head.confirmed.has_value());
        EXPECT_TRUE(run.runner.status().navigation.heading.has_value());
        EXPECT_EQ(run.runner.status().navigation.position_kind, "GGA");
        EXPECT_EQ(run.runner.status().without_pose, 0U);
        run.link.close();
        EXPECT_FALSE(run.link.state().sonar.up);
    }
    std::map<EventKind, int> seen;
    const auto log = LogReader::open(path).value();
    while (const auto event = log->next()) ++seen[event->kind];
    for (const EventKind kind : {EventKind::SonarLink, EventKind::SonarBytes, EventKind::SentBytes,
                                 EventKind::NavigationLink, EventKind::NavigationBytes})
        EXPECT_GT(seen[kind], 0);
}

TEST(HeadLink, BothDirectionsAndTheLinkAreInTheLog) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("run.echotrail").toStdString();
    SimulatedPeer peer;
    {
        LiveRun run(peer.address(), {}, LogWriter::create(path, {}).value());
        ASSERT_TRUE(becomes([&] { return run.runner.status().pings >= 3; }));
        run.link.close();
    }
    const auto log = LogReader::open(path).value();
    std::map<EventKind, int> seen;
    std::string last_link;
    while (const auto event = log->next()) {
        ++seen[event->kind];
        if (event->kind == EventKind::SonarLink) last_link.assign(event->payload.begin(), event->payload.end());
    }
    // Our own end is no broken link: what it cut of a frame is counted, but was not lost on the way.
    EXPECT_EQ(seen[EventKind::SonarLink], 1);
    EXPECT_EQ(last_link, "up");
    const auto source = EchotrailLog::open(path, {}).value();
    while (source->next()) {
    }
    EXPECT_EQ(source->counts().lost_records, 0u);
    EXPECT_TRUE(source->counts().rejected.empty());
    EXPECT_GT(seen[EventKind::SonarBytes], 0);
    EXPECT_GT(seen[EventKind::SentBytes], 0);
}

}  // namespace
}  // namespace echotrail
