#include "app/console/live_connection.hpp"
#include "core/recording/log_reader.hpp"
#include "qt_environment.hpp"
#include "tests/app/io/simulated_peer.hpp"
#include "ui/main_window/main_window.hpp"
#include "ui/main_window/message_strip.hpp"
#include "ui/main_window/status_chip.hpp"
#include "ui/panels/connection/connection_panel.hpp"
#include "ui/panels/connection/head_controls.hpp"
#include "ui/panels/parameters/parameter_panel.hpp"
#include "ui/views/fan_view.hpp"

#include <gtest/gtest.h>
#include <malloc.h>

#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

namespace echotrail {
namespace {

using seanet::HeadState;
using test::await;

qsizetype entries(const QString& folder) { return QDir(folder).entryList(QDir::AllEntries | QDir::System).size(); }
qsizetype threads() { return entries("/proc/self/task"); }
qsizetype openFiles() { return entries("/proc/self/fd"); }
/// Bytes that are allocated, whatever the allocator keeps for later.
std::size_t heapInUse() {
    const struct mallinfo2 now = mallinfo2();
    return now.uordblks + now.hblkhd;
}

/// A console with real links, and its recordings in a folder of the test's own.
class LiveMode : public testing::Test {
protected:
    LiveMode() {
        before_ = qgetenv("XDG_DATA_HOME");
        qputenv("XDG_DATA_HOME", folder_.path().toUtf8());
        window_.resize(1600, 1000);
        window_.show();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window_));
    }
    ~LiveMode() override { qputenv("XDG_DATA_HOME", before_); }
    void connectTo(const std::string& address, bool record = false) {
        window_.connection().connectTo(QString::fromStdString(address), {}, record);
    }
    const LiveState& state() { return window_.bridge().liveState(); }
    bool pingsCome() {
        return await([this] { return state().run.pings > 0 && window_.bridge().scene() != nullptr; });
    }
    QString chip(const QString& label) {
        for (const auto* each : window_.findChildren<StatusChip*>())
            if (each->isVisible() && each->accessibleName().startsWith(label + " ")) return each->accessibleName();
        return {};
    }

    QTemporaryDir folder_;
    QByteArray before_;  ///< where data went before
    MainWindow window_{{.remember = false, .live = liveAccess()}};
};

TEST_F(LiveMode, AHeadComesAliveAndTheWindowSaysSo) {
    SimulatedPeer peer;
    connectTo(peer.address());
    EXPECT_TRUE(window_.bridge().isLive());
    ASSERT_TRUE(pingsCome());
    ASSERT_TRUE(await([&] { return state().head.confirmed.has_value(); }));
    EXPECT_TRUE(chip("LINK").contains("up")) << chip("LINK").toStdString();
    EXPECT_TRUE(chip("SONAR").contains("scanning")) << chip("SONAR").toStdString();
    EXPECT_TRUE(chip("HDG").contains("no navigation")) << chip("HDG").toStdString();
    EXPECT_TRUE(chip("REC").contains("off")) << chip("REC").toStdString();
    EXPECT_TRUE(chip("FILE").isEmpty()) << "that is of recordings";
    QStringList said;
    for (const auto* label : window_.connection().findChildren<QLabel*>()) said << label->text();
    EXPECT_TRUE(said.contains("scanning"));
    EXPECT_TRUE(said.contains(QString::fromStdString(state().head.head)));
    EXPECT_TRUE(said.contains("50 m")) << "the range, as the head says it";
}

TEST_F(LiveMode, ARangeTypedInThePanelReachesTheHeadAndIsConfirmed) {
    SimulatedPeer peer;
    connectTo(peer.address());
    ASSERT_TRUE(pingsCome());
    Q_EMIT window_.connection().controls().edited("range_m", "20");
    EXPECT_EQ(window_.bridge().params().head.range_m, 20.0);
    ASSERT_TRUE(await([&] { return state().head.confirmed && state().head.confirmed->range_m == 20.0; }));
    window_.parameters().model().undoStack().undo();
    EXPECT_TRUE(await([&] { return state().head.confirmed->range_m == 50.0; })) << "it can be undone like any other";
}

TEST_F(LiveMode, AValueOutsideTheLimitsIsRefusedWithTheReason) {
    auto* range = window_.connection().controls().findChild<QLineEdit*>();
    ASSERT_NE(range, nullptr);
    ASSERT_EQ(range->text(), "50");
    window_.findChild<QDockWidget*>("connection")->raise();
    range->setFocus();
    range->setText("9000");
    QTest::keyClick(range, Qt::Key_Return);
    EXPECT_EQ(window_.bridge().params().head.range_m, 50.0);
    EXPECT_EQ(range->text(), "50") << "what is in force";
    EXPECT_TRUE(window_.messages().text().contains("450")) << window_.messages().text().toStdString();
}

TEST_F(LiveMode, NothingThereIsSaidWhereTheOperatorLooksAndTriedAgain) {
    std::string nowhere;
    {
        SimulatedPeer gone;
        nowhere = gone.address();
    }
    connectTo(nowhere);
    ASSERT_TRUE(await([&] { return !state().sonar.reason.isEmpty(); }));
    EXPECT_TRUE(chip("LINK").contains("down"));
    EXPECT_TRUE(window_.bridge().isLive());
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
    bool said = false;
    for (const auto* label : window_.connection().findChildren<QLabel*>())
        said |= label->text().contains("trying again");
    EXPECT_TRUE(said);
}

TEST_F(LiveMode, TheHeadingShowsWithItsAgeAndGrowsStale) {
    SimulatedPeer peer;
    const auto compass = ByteServer::listen(parseLinkAddress("tcp://127.0.0.1:0").value()).value();
    bool heard = false;
    QObject::connect(compass.get(), &ByteServer::peerUp, [&heard] { heard = true; });
    PipelineBridge::Params params;
    params.navigation.longest_navigation_gap_s = 0.2;
    window_.setParams(params);
    window_.connection().connectTo(QString::fromStdString(peer.address()), QString::fromStdString(compass->address()),
                                   false);
    EXPECT_TRUE(chip("HDG").contains("waiting")) << chip("HDG").toStdString();
    ASSERT_TRUE(await([&] { return heard; }));
    compass->send("$HEHDT,123.4,T*2B\r\n");
    ASSERT_TRUE(await([&] { return chip("HDG").contains("123.4°T"); }));
    EXPECT_TRUE(await([&] { return chip("HDG").contains("stale"); }));
}

TEST_F(LiveMode, ABrokenLinkIsShownAndHealsByItself) {
    SimulatedPeer peer;
    connectTo(peer.address());
    ASSERT_TRUE(pingsCome());
    // The link is made again soon, so being down may be over before it is looked at: cut it until it is seen.
    int cuts = 0;
    ASSERT_TRUE(await([&] {
        if (cuts++ % 20 == 0) peer.server().drop();
        return chip("LINK").contains("down");
    }));
    ASSERT_TRUE(await([&] { return chip("LINK").contains("up") && chip("SONAR").contains("scanning"); }));
    EXPECT_TRUE(window_.bridge().isLive());
}

TEST_F(LiveMode, AnAddressThatIsNoneLeavesWhatWasOpen) {
    window_.bridge().open("scan", test::scanOpener(60));
    ASSERT_TRUE(await([&] { return window_.bridge().isOpen(); }));
    for (const char* address : {"", "tcp://", "tcp://host:99999", "harbour.V4LOG", "serial://"}) {
        connectTo(address);
        EXPECT_FALSE(window_.bridge().isLive()) << address;
        EXPECT_TRUE(window_.bridge().isOpen());
        EXPECT_TRUE(window_.messages().text().startsWith("Not connected")) << address;
    }
}

TEST_F(LiveMode, EverythingIsRecordedAndTheLogIsWholeAfterDisconnecting) {
    SimulatedPeer peer;
    connectTo(peer.address(), true);
    ASSERT_TRUE(pingsCome());
    ASSERT_TRUE(await([&] { return state().run.recorder.recording; }));
    const std::string path = state().run.recorder.path;
    EXPECT_TRUE(QString::fromStdString(path).startsWith(folder_.path()));
    EXPECT_TRUE(chip("REC").contains("free")) << chip("REC").toStdString();
    window_.bridge().close();
    EXPECT_FALSE(window_.bridge().isOpen());
    const auto log = LogReader::open(path);
    ASSERT_TRUE(log) << log.error();
    EXPECT_GT((*log)->events(), 5U);
    window_.openRecording(QString::fromStdString(path));
    ASSERT_TRUE(await([&] { return window_.bridge().isOpen() && window_.bridge().scene(); }));
    EXPECT_TRUE(chip("FILE").contains(QString::fromStdString(window_.bridge().info().name)));
    EXPECT_TRUE(chip("REC").isEmpty()) << "that is of a live head";
}

TEST_F(LiveMode, TheSectorsEdgesMoveOnTheFanAndTheHeadConfirmsThem) {
    SimulatedPeer peer;
    connectTo(peer.address());
    ASSERT_TRUE(pingsCome());
    FanView& fan = window_.fan();
    fan.editSector();
    for (int i = 0; i < 10; ++i) QTest::keyClick(&fan, Qt::Key_Left);
    EXPECT_EQ(window_.bridge().params().head.sector_width_deg, 90.0) << "not before Enter";
    QTest::keyClick(&fan, Qt::Key_Return);
    EXPECT_EQ(window_.bridge().params().head.sector_width_deg, 72.0);
    EXPECT_EQ(window_.bridge().params().head.sector_centre_deg, -9.0);
    EXPECT_TRUE(await([&] {
        const auto& confirmed = state().head.confirmed;
        return confirmed && std::abs(confirmed->sector_width_deg - 72.0) < 0.1 &&
               std::abs(confirmed->sector_centre_deg + 9.0) < 0.1;
    }));
    window_.parameters().model().undoStack().undo();
    EXPECT_EQ(window_.bridge().params().head.sector_width_deg, 90.0) << "both in one step";
    EXPECT_EQ(window_.bridge().params().head.sector_centre_deg, 0.0);
}

TEST_F(LiveMode, TheHeadFollowsTheTargetWithinTheSectorThatIsSetOnTheFan) {
    SimulatedPeer peer("tcp://127.0.0.1:0", SimulatedPeer::quick(),
                       [](const HeadSetup& setup) { return std::abs(setup.bearing.inDegrees()) < 2.0; });
    connectTo(peer.address());
    ASSERT_TRUE(pingsCome());
    const auto change = [this](const auto& edit) {
        PipelineBridge::Params params = window_.bridge().params();
        edit(params);
        window_.parameters().model().change(parameterValues(params), "test");
    };
    change([](auto& params) {
        params.head.range_m = 10.0;
        params.head.sector_width_deg = 54.0;
    });
    window_.bridge().designate(5.0, 0.0);
    ASSERT_TRUE(await([&] { return !window_.bridge().scene()->tracks.empty(); }));
    change([](auto& params) { params.follow.follow_target = true; });
    const auto scans = [this] { return state().head.confirmed ? state().head.confirmed->sector_width_deg : 0.0; };
    ASSERT_TRUE(await([&] { return scans() > 0.0 && scans() < 40.0 && state().head.difference.empty(); }));
    EXPECT_EQ(window_.bridge().params().head.sector_width_deg, 54.0) << "the operator's stays as it is";

    FanView& fan = window_.fan();
    fan.editSector();
    for (int i = 0; i < 10; ++i) QTest::keyClick(&fan, Qt::Key_Left);
    QTest::keyClick(&fan, Qt::Key_Return);
    const ScanSector limit = scanSector(window_.bridge().params().head);
    EXPECT_EQ(limit.width_deg, 36.0);
    EXPECT_TRUE(await([&] {
        return state().head.confirmed && state().head.difference.empty() &&
               contains(limit, scanSector(*state().head.confirmed)) && scans() < 30.0;
    }));
    change([](auto& params) { params.follow.follow_target = false; });
    EXPECT_TRUE(await([&] { return std::abs(scans() - 36.0) < 0.1 && state().head.difference.empty(); }));
}

TEST_F(LiveMode, AHeadSimulatedHereIsChosenFromTheMenuAndBringsItsNavigation) {
    EXPECT_FALSE(window_.bridge().simulatedHeads().isEmpty());
    window_.connection().connectTo("simulation://demo", {}, true);
    ASSERT_TRUE(pingsCome());
    EXPECT_TRUE(window_.windowTitle().contains("simulation://demo"));
    EXPECT_TRUE(await([&] { return chip("HDG").contains("°T"); })) << chip("HDG").toStdString();
    const std::string path = state().run.recorder.path;
    window_.bridge().close();
    EXPECT_TRUE(LogReader::open(path)) << "recorded like any other";
}

TEST_F(LiveMode, TheEnhancedPictureIsThereWhileLiveToo) {
    SimulatedPeer peer;
    connectTo(peer.address());
    ASSERT_TRUE(pingsCome());
    EXPECT_TRUE(window_.bridge().scene()->enhanced.empty());
    Layers layers = window_.fan().layers();
    layers.enhanced = true;
    window_.fan().setLayers(layers);
    EXPECT_TRUE(await([&] { return !window_.bridge().scene()->enhanced.empty(); }));
}

TEST_F(LiveMode, TwentyRoundsOfLiveRecordingAndSimulationLeaveNoThreadNoFileAndNoHeapBehind) {
    SimulatedPeer peer;
    const auto replays = [&] { return window_.bridge().isOpen() && !window_.bridge().isLive(); };
    const auto round = [&](bool record) {
        connectTo(peer.address(), record);
        ASSERT_TRUE(await([&] { return state().sonar.up; }));
        window_.bridge().open("scan", test::scanOpener(60));
        ASSERT_TRUE(await([&] { return replays() && window_.bridge().scene() != nullptr; }));
        window_.connection().connectTo("simulation://demo", {}, record);
        ASSERT_TRUE(await([&] { return state().sonar.up && state().navigation && state().navigation->up; }));
        window_.openDemonstration();
        ASSERT_TRUE(await([&] { return replays() && window_.bridge().scene() != nullptr; }));
    };
    const auto rest = [&] {
        window_.bridge().close();
        QTest::qWait(200);  // for the other end to notice
    };
    round(true);  // what is made once and kept
    rest();
    const qsizetype threads_before = threads();
    const qsizetype files_before = openFiles();
    const std::size_t heap_before = heapInUse();
    for (int i = 0; i < 20; ++i) ASSERT_NO_FATAL_FAILURE(round(i % 2 == 0));
    rest();
    constexpr std::size_t pictures = 16U << 20U;  // one takes 4 MB, and some may be on their way; a round paints twenty
    EXPECT_LT(heapInUse(), heap_before + pictures);
    EXPECT_TRUE(await([&] { return threads() <= threads_before; })) << threads() << " for " << threads_before;
    EXPECT_TRUE(await([&] { return openFiles() <= files_before; })) << openFiles() << " for " << files_before;
}

}  // namespace
}  // namespace echotrail
