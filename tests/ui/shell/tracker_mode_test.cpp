#include "app/console/live_connection.hpp"
#include "app/io/console_server.hpp"
#include "app/io/recording_shelf.hpp"
#include "core/recording/log_reader.hpp"
#include "core/recording/log_writer.hpp"
#include "core/runtime/link_moment.hpp"
#include "qt_environment.hpp"
#include "tests/core/link/sample_values.hpp"
#include "ui/main_window/main_window.hpp"
#include "ui/main_window/message_strip.hpp"
#include "ui/main_window/stale_banner.hpp"
#include "ui/main_window/status_chip.hpp"
#include "ui/panels/connection/connection_panel.hpp"
#include "ui/panels/connection/head_controls.hpp"
#include "ui/panels/recordings/recordings_window.hpp"

#include <gtest/gtest.h>

#include <QAction>
#include <QHeaderView>
#include <QProcess>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>

namespace echotrail {
namespace {

using test::await;

Timestamp clockNow() { return std::chrono::time_point_cast<Microseconds>(std::chrono::system_clock::now()); }

/// A tracker with one track, in this process.
struct Tracker {
    explicit Tracker(const std::string& where = "tcp://127.0.0.1:0", RecordingShelf* shelf = nullptr)
        : server({"vehicle", "test"}, namedValues({}), clockNow,
                 [this](const LinkRequest& request) { return answer(request); }) {
        if (shelf) server.serveRecordings([shelf](const LinkRecordRequest& request) { return shelf->answer(request); });
        address = server.listen(parseLinkAddress(where).value()).value();
        server.publish(test::sampleHealth());
        for (std::uint64_t i = 0; i < 40; ++i) {
            LinkMoment moment = test::sampleMoment(i, 0.05 * static_cast<double>(i));
            moment.beam->ping.time = moment.beam->update.time = clockNow();
            moment.beam->ping.bearing = Bearing::degrees(-30.0 + 1.8 * static_cast<double>(i % 20));
            server.publish(std::move(moment));
        }
        server.flush();
    }
    Result<std::optional<std::vector<NamedValue>>> answer(const LinkRequest& request) {
        last = request;
        const auto* wanted = std::get_if<LinkSetParameters>(&request.content);
        if (!wanted) return std::optional<std::vector<NamedValue>>();
        if (auto set = setNamedValues(params, wanted->values); !set) return Error{set.error()};
        return std::optional(namedValues(params));
    }
    QString text() const { return QString::fromStdString(toText(address)); }

    ScanningSonarPipeline::Params params;
    std::optional<LinkRequest> last;
    ConsoleServer server;
    LinkAddress address;
};

class TrackerMode : public testing::Test {
protected:
    TrackerMode() {
        window_.resize(1600, 1000);
        window_.show();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window_));
    }
    bool follows(const QString& address) {
        window_.openTracker(address);
        return await([&] { return window_.bridge().scene() && chip("TRACKER").contains("up"); });
    }
    QString chip(const QString& label) {
        for (const auto* each : window_.findChildren<StatusChip*>())
            if (each->isVisible() && each->accessibleName().startsWith(label + " ")) return each->accessibleName();
        return {};
    }
    MainWindow window_{{.remember = false, .live = liveAccess()}};
};

TEST_F(TrackerMode, TheWindowShowsWhatTheTrackerSees) {
    Tracker tracker;
    ASSERT_TRUE(follows(tracker.text()));
    EXPECT_TRUE(window_.bridge().isTracker());
    EXPECT_EQ(window_.bridge().scene()->tracks.size(), 1U);
    EXPECT_FALSE(window_.bridge().scene()->fan.empty());
    EXPECT_TRUE(await([&] { return chip("CONTROL").contains("yours"); })) << chip("CONTROL").toStdString();
    EXPECT_TRUE(chip("SONAR").contains("scanning")) << chip("SONAR").toStdString();
    EXPECT_TRUE(chip("LINK").isEmpty()) << "that is of a head at this computer";
    EXPECT_TRUE(window_.stale().text().isEmpty());
}

TEST_F(TrackerMode, AnEditGoesToTheTrackerAndAnothersComesBackIntoTheForm) {
    Tracker tracker;
    ASSERT_TRUE(follows(tracker.text()));
    ASSERT_TRUE(await([&] { return chip("CONTROL").contains("yours"); }));
    Q_EMIT window_.connection().controls().edited("range_m", "20");
    ASSERT_TRUE(await([&] { return tracker.params.head.range_m == 20.0; }));
    window_.bridge().designate(15.0, 0.1);
    ASSERT_TRUE(await([&] { return tracker.last && std::holds_alternative<LinkDesignate>(tracker.last->content); }));
    window_.bridge().close();
    EXPECT_EQ(window_.bridge().params().head.range_m, 50.0) << "this console's own again";
}

TEST_F(TrackerMode, ALostLinkLooksLostAndHealsByItself) {
    auto tracker = std::make_unique<Tracker>();
    const QString address = tracker->text();
    ASSERT_TRUE(follows(address));
    tracker.reset();
    ASSERT_TRUE(await([&] { return window_.stale().text().contains("LINK LOST"); }));
    EXPECT_TRUE(chip("TRACKER").contains("down")) << chip("TRACKER").toStdString();
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
    EXPECT_EQ(window_.bridge().scene()->tracks.size(), 1U) << "what was known can still be read";
    tracker = std::make_unique<Tracker>(address.toStdString());
    ASSERT_TRUE(await([&] { return chip("TRACKER").contains("up") && window_.stale().text().isEmpty(); }));
}

TEST_F(TrackerMode, RecordingsAboardAreListedAndFetchedBesideThePicture) {
    const QTemporaryDir aboard;
    const std::string folder = aboard.path().toStdString();
    {
        auto log = LogWriter::create(folder + "/dive.echotrail", {.program_version = "test", .started = clockNow()});
        ASSERT_TRUE(log) << log.error();
        for (std::uint64_t number = 0; number < 50; ++number)
            ASSERT_TRUE((*log)->add({number, EventKind::SonarBytes, clockNow(), Microseconds(number), {1, 2, 3}}));
        ASSERT_TRUE((*log)->close());
    }
    RecordingShelf shelf(folder, "");
    Tracker tracker("tcp://127.0.0.1:0", &shelf);
    ASSERT_TRUE(follows(tracker.text()));
    window_.findChild<QAction*>("recordings_aboard")->trigger();
    auto* recordings = window_.findChild<RecordingsWindow*>();
    ASSERT_NE(recordings, nullptr);
    EXPECT_FALSE(recordings->isModal());
    ASSERT_TRUE(await([&] { return recordings->list().topLevelItemCount() == 1; }));
    EXPECT_FALSE(recordings->fetchButton().isEnabled()) << "none is selected";
    recordings->list().setCurrentItem(recordings->list().topLevelItem(0));
    ASSERT_TRUE(recordings->fetchButton().isEnabled());
    recordings->fetchButton().click();
    ASSERT_TRUE(await([&] { return recordings->progress().startsWith("Whole: "); }))
        << recordings->progress().toStdString();
    const std::string copy = recordings->progress().mid(7).toStdString();
    const auto log = LogReader::open(copy);
    ASSERT_TRUE(log) << log.error();
    EXPECT_EQ((*log)->events(), 50U);
    EXPECT_FALSE(recordings->cancelButton().isEnabled());
}

TEST(TrackerProgram, ATargetOfTheCommandLineReachesTheTrackerOnceItTakesOrders) {
    Tracker tracker;
    QProcess console;
    console.start(ECHOTRAIL_CONSOLE,
                  {"--headless", "--connect", tracker.text(), "--no-record", "--target", "31,-9", "--exit-at", "60"});
    ASSERT_TRUE(await([&] { return tracker.last.has_value(); }));
    const auto* designation = std::get_if<LinkDesignate>(&tracker.last->content);
    ASSERT_NE(designation, nullptr);
    EXPECT_EQ(designation->range_m, 31.0);
    EXPECT_NEAR(designation->from_bow.inDegrees(), -9.0, 1e-9);
    tracker.last.reset();
    EXPECT_FALSE(QTest::qWaitFor([&] { return tracker.last.has_value(); }, 1'000)) << "once is enough";
    console.terminate();
    EXPECT_TRUE(console.waitForFinished(60'000));
}

TEST(RecordingsAboard, ALongNameLeavesSizeAndTimeInSightAndTroubleIsSaid) {
    PipelineBridge bridge;
    RecordingsWindow window(bridge);
    window.show();
    LiveState state;
    state.tracker = TrackerState{};
    state.tracker->link.up = true;
    Q_EMIT bridge.liveChanged(state);
    EXPECT_EQ(window.progress(), "None has been listed so far.");
    const Timestamp written{std::chrono::seconds(1'767'262'500)};
    state.tracker->recordings = {{QString(200, 'n'), 5'200'000'000, written, false}};
    Q_EMIT bridge.liveChanged(state);
    EXPECT_EQ(window.progress(), "");
    const QTreeWidgetItem* item = window.list().topLevelItem(0);
    EXPECT_EQ(item->text(2), "2026-01-01 10:15");
    QCoreApplication::processEvents();
    EXPECT_LE(window.list().header()->length(), window.list().viewport()->width()) << "nothing to scroll to";
    state.tracker->fetched = RecordingCopy{};
    state.tracker->fetched->name = "dive";
    state.tracker->fetched->rows = 31;
    state.tracker->fetched->there = 100;
    Q_EMIT bridge.liveChanged(state);
    EXPECT_TRUE(window.progress().startsWith("dive: 31 %")) << window.progress().toStdString();
    state.tracker->fetched->error = "no space left";
    Q_EMIT bridge.liveChanged(state);
    EXPECT_EQ(window.progress(), "Not fetched: no space left");
}

TEST_F(TrackerMode, WhatIsNoAddressIsRefused) {
    for (const char* address : {"", "vehicle", "serial:///dev/ttyUSB0", "udp://127.0.0.1:7000", "tcp://127.0.0.1:0"}) {
        window_.openTracker(address);
        EXPECT_FALSE(window_.bridge().isOpen()) << address;
        EXPECT_TRUE(window_.messages().text().startsWith("Not connected")) << address;
    }
}

}  // namespace
}  // namespace echotrail
