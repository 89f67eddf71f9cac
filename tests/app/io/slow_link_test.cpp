#include "app/io/console_server.hpp"
#include "app/io/recording_shelf.hpp"
#include "app/io/tracker_link.hpp"
#include "core/recording/log_writer.hpp"
#include "core/runtime/link_moment.hpp"
#include "tests/app/io/event_loop.hpp"
#include "tests/app/io/slow_way.hpp"
#include "tests/core/link/sample_values.hpp"

#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTemporaryDir>
#include <chrono>
#include <memory>
#include <set>
#include <vector>

namespace echotrail {
namespace {

Timestamp clockNow() { return std::chrono::time_point_cast<Microseconds>(std::chrono::system_clock::now()); }

LinkAddress at(std::uint16_t port) {
    LinkAddress address = parseLinkAddress("tcp://127.0.0.1:0").value();
    address.port = port;
    return address;
}

/// A tracker that pings twenty times a second, and knows what each console is spared.
struct Tracker {
    explicit Tracker(std::uint16_t port = 0, RecordingShelf* shelf = nullptr)
        : server({"vehicle", "test"}, namedValues({}), clockNow, [this](const LinkRequest& request) {
              requests.push_back(request);
              return std::optional<std::vector<NamedValue>>();
          }) {
        if (shelf) server.serveRecordings([shelf](const LinkRecordRequest& request) { return shelf->answer(request); });
        address = server.listen(at(port)).value();
        QObject::connect(&pings, &QTimer::timeout, &pings, [this] { ping(); });
    }
    void ping() {
        LinkMoment moment = test::sampleMoment(number++, 0.0);
        moment.time = moment.beam->ping.time = moment.beam->update.time = moment.tracks[0].estimate.time = clockNow();
        if (number % 10 == 0) {
            moment.looks[0].time = moment.time;
        } else {  // the beam is elsewhere
            moment.looks.clear();
            moment.tracks = last_tracks;
        }
        last_tracks = moment.tracks;
        server.publish(moment);
        server.flush();
        if (server.consoles() > 0) levels.push_back(server.levelOf(1));
    }
    std::vector<LinkRequest> requests;
    std::vector<Track> last_tracks;
    std::vector<SendQueue::Level> levels;
    ConsoleServer server;
    LinkAddress address;
    QTimer pings;
    std::uint64_t number = 0;
};

/// A console that notes everything it hears.
struct Console {
    explicit Console(const LinkAddress& address) : client({{"shore", "test"}, true, 0}), channel(makeChannel(address)) {
        clock.start();
        const auto now = [this] { return Microseconds(clock.nsecsElapsed() / 1000); };
        QObject::connect(channel.get(), &ByteChannel::wentUp, [=, this] { client.linkUp(now()); });
        QObject::connect(channel.get(), &ByteChannel::wentDown, [this] { client.linkDown(); });
        QObject::connect(channel.get(), &ByteChannel::received, [=, this](const QByteArray& bytes) {
            client.received(
                now(), {reinterpret_cast<const std::uint8_t*>(bytes.data()), static_cast<std::size_t>(bytes.size())});
            while (auto event = client.next()) take(*event);
        });
        QObject::connect(&tick, &QTimer::timeout, [=, this] {
            client.tick(now());
            const std::string out = client.takeOutput();
            if (!out.empty()) channel->send(QByteArray::fromStdString(out));
        });
        tick.start(20);
        channel->open();
    }
    void take(const LinkEvent& event) {
        if (const auto* tracks = std::get_if<LinkTracks>(&event))
            for (const TrackLook& look : tracks->looks) {
                looks.push_back(look.time);
                oldest_s = std::max(oldest_s, secondsBetween(look.time, clockNow()));
            }
        if (const auto* reply = std::get_if<LinkReply>(&event)) replies.push_back(*reply);
    }
    QElapsedTimer clock;
    LinkClient client;
    std::unique_ptr<ByteChannel> channel;
    QTimer tick;
    std::vector<Timestamp> looks;
    std::vector<LinkReply> replies;
    double oldest_s = 0.0;
};

TEST(SlowLink, TracksComeInOrderOfTimeAndThePictureIsSparedInTheDeclaredOrder) {
    Tracker tracker;
    SlowWay radio(tracker.address.port,
                  {.delay_ms = 300, .stall_every_ms = 2'000, .stall_ms = 1'000, .bytes_per_second = 8'000});
    Console console(at(radio.port()));
    ASSERT_TRUE(becomes([&] { return console.client.status().snapshots > 0; }));
    tracker.pings.start(50);
    ASSERT_TRUE(becomes([&] { return console.looks.size() >= 24 && radio.stalls() >= 4; }));

    EXPECT_TRUE(std::is_sorted(console.looks.begin(), console.looks.end()));
    EXPECT_EQ(console.client.status().malformed, 0U);
    EXPECT_EQ(console.client.status().joins, 1U) << "the link has held";
    ASSERT_FALSE(tracker.levels.empty());
    EXPECT_EQ(tracker.levels.front(), SendQueue::Everything);
    EXPECT_GE(*std::max_element(tracker.levels.begin(), tracker.levels.end()), SendQueue::NoParticles);
    for (std::size_t i = 1; i < tracker.levels.size(); ++i)
        EXPECT_LE(tracker.levels[i] - tracker.levels[i - 1], 1) << "no step is left out";
    // What is under way before the tracker notices: some kilobytes, at eight in a second, and two stalls.
    EXPECT_LT(console.oldest_s, 8.0);
    EXPECT_EQ(tracker.server.counts().resynchronised, 0U);

    const std::uint32_t asked = console.client.designate(20.0, Bearing::degrees(5.0));
    ASSERT_NE(asked, 0U);
    ASSERT_TRUE(becomes([&] { return !console.replies.empty(); }));
    EXPECT_EQ(console.replies[0].request, asked);
    EXPECT_TRUE(console.replies[0].done) << console.replies[0].reason;
    EXPECT_EQ(tracker.requests.size(), 1U);
}

TEST(SlowLink, ACopyOfTheRunIsNotInTheWayOfTracks) {
    const QTemporaryDir folder;
    const std::string path = folder.path().toStdString() + "/run.echotrail";
    auto log = LogWriter::create(path, {.program_version = "test", .started = clockNow()}).value();
    for (std::uint64_t number = 0; number < 3'000; ++number)
        ASSERT_TRUE(log->add({number, EventKind::SonarBytes, clockNow(), Microseconds(number),
                              std::vector<std::uint8_t>(400, static_cast<std::uint8_t>(number))}));
    ASSERT_TRUE(log->commit());
    RecordingShelf shelf(folder.path().toStdString(), path);
    Tracker tracker(0, &shelf);
    SlowWay radio(tracker.address.port,
                  {.delay_ms = 300, .stall_every_ms = 2'000, .stall_ms = 1'000, .bytes_per_second = 8'000});
    TrackerLink console(at(radio.port()), {"shore", "test"}, folder.path().toStdString() + "/ashore");
    console.open();
    ASSERT_TRUE(becomes([&] { return console.state().client.snapshots > 0; }));
    tracker.pings.start(50);
    Microseconds latest{0};
    ASSERT_TRUE(becomes([&] {
        const TrackerLinkState state = console.state();
        latest = std::max(latest, state.client.latency.value_or(Microseconds{0}));
        return state.record && state.record->rows.rows > 10 && tracker.number > 400;
    })) << console.state().record->rows.rows;
    // A beam, which goes after tracks, is some seven seconds old at most, as it is without a copy.
    EXPECT_LT(latest, Microseconds{10'000'000});
    EXPECT_EQ(console.state().client.joins, 1U);
    EXPECT_LT(console.state().record->rows.rows, console.state().record->rows.there) << "it waits its turn";
}

TEST(SlowLink, ATrackerThatIsKilledAndStartedTwentyTimesIsFoundAgain) {
    auto tracker = std::make_unique<Tracker>();
    const std::uint16_t port = tracker->address.port;
    TrackerLink console(tracker->address, {"shore", "test"});
    console.open();
    for (int round = 0; round < 20; ++round) {
        ASSERT_TRUE(becomes([&] { return console.state().up && console.state().client.holdsControl(); })) << round;
        tracker->ping();
        std::optional<Scene> scene;
        ASSERT_TRUE(becomes([&] { return (scene = console.scenes().take()) && scene->position == 1; })) << round;
        tracker.reset();
        ASSERT_TRUE(becomes([&] { return !console.state().up; })) << round;
        tracker = std::make_unique<Tracker>(port);
    }
}

TEST(SlowLink, AfterALongTimeWithoutAnyWayThereIsOneConnectionAgain) {
    QTcpServer nonsense;
    ASSERT_TRUE(nonsense.listen(QHostAddress::LocalHost));
    const std::uint16_t port = nonsense.serverPort();
    TrackerLink console(at(port), {"shore", "test"});
    console.open();
    ASSERT_TRUE(becomes([&] { return nonsense.hasPendingConnections(); }));
    nonsense.nextPendingConnection()->write(QByteArray(64, '\xff'));
    ASSERT_TRUE(becomes([&] { return !console.state().reason.empty(); })) << "the console gives it up by itself";
    nonsense.close();
    QElapsedTimer gone;
    gone.start();
    ASSERT_TRUE(becomes([&] { return gone.hasExpired(2'500); })) << "many turns of its clock, and some attempts";
    const Tracker tracker(port);
    ASSERT_TRUE(becomes([&] { return console.state().up; }));
    gone.restart();
    ASSERT_TRUE(becomes([&] { return gone.hasExpired(1'500); }));
    EXPECT_TRUE(console.state().up);
    EXPECT_EQ(console.state().client.joins, 1U);
}

TEST(SlowLink, AConsoleThatIsKilledAndStartedTwentyTimesKnowsTheSameAgain) {
    Tracker tracker;
    for (int i = 0; i < 20; ++i) tracker.ping();
    std::vector<TrackLook> history;
    for (int round = 0; round < 20; ++round) {
        SlowWay cable(tracker.address.port, {});
        TrackerLink console(at(cable.port()), {"shore", "test"});
        console.open();
        std::optional<Scene> scene;
        ASSERT_TRUE(becomes([&] { return console.state().up && (scene = console.scenes().take()); })) << round;
        ASSERT_EQ(scene->tracks.size(), 1U);
        if (round == 0) history = scene->tracks[0].history;
        EXPECT_EQ(scene->tracks[0].history.size(), history.size());
        EXPECT_TRUE(becomes([&] { return console.state().client.holdsControl(); })) << "the last one's went with it";
        cable.cut();
        ASSERT_TRUE(becomes([&] { return !console.state().up; }));
    }
    EXPECT_FALSE(history.empty());
}

}  // namespace
}  // namespace echotrail
