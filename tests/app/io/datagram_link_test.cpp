#include "app/io/console_server.hpp"
#include "app/io/tracker_link.hpp"
#include "core/runtime/link_moment.hpp"
#include "tests/app/io/event_loop.hpp"
#include "tests/core/link/sample_values.hpp"

#include <gtest/gtest.h>

#include <QUdpSocket>
#include <chrono>

namespace echotrail {
namespace {

Timestamp clockNow() { return std::chrono::time_point_cast<Microseconds>(std::chrono::system_clock::now()); }

/// A tracker that pings fifty times a second, with datagrams.
struct Tracker {
    explicit Tracker(bool datagrams = true) {
        if (datagrams) server.serveDatagrams();
        address = server.listen(parseLinkAddress("tcp://127.0.0.1:0").value()).value();
        QObject::connect(&pings, &QTimer::timeout, &pings, [this] {
            LinkMoment moment = test::sampleMoment(number++, 0.0);
            moment.time = moment.beam->ping.time = moment.beam->update.time = clockNow();
            server.publish(moment);
            server.flush();
        });
        pings.start(20);
    }
    ConsoleServer server{{"vehicle", "test"}, namedValues({}), clockNow, [](const LinkRequest&) {
                             return std::optional<std::vector<NamedValue>>();
                         }};
    LinkAddress address;
    QTimer pings;
    std::uint64_t number = 0;
};

TEST(DatagramLink, PicturesComeByUdpTracksAndCommandsByTcp) {
    Tracker tracker;
    TrackerLink console(tracker.address, {"shore", "test"});
    console.open();
    ASSERT_TRUE(becomes([&] { return console.state().client.datagrams > 100; }));
    EXPECT_TRUE(becomes([&] { return console.state().client.holdsControl(); }));
    EXPECT_GT(tracker.server.counts().datagrams, 100U);
    EXPECT_EQ(console.state().client.malformed, 0U);
    EXPECT_EQ(tracker.server.datagramsRefused(), 0U);
    ASSERT_TRUE(becomes([&] { return console.scenes().take().has_value(); }));
}

TEST(DatagramLink, WithoutThemAllComesByTcp) {
    Tracker tracker(false);
    TrackerLink console(tracker.address, {"shore", "test"});
    console.open();
    ASSERT_TRUE(becomes([&] { return console.state().client.messages > 200; }));
    EXPECT_EQ(console.state().client.datagrams, 0U);
    EXPECT_TRUE(console.scenes().take().has_value());
}

TEST(DatagramLink, StrangersDatagramsAreCountedAndHaveNoEffect) {
    Tracker tracker;
    TrackerLink console(tracker.address, {"shore", "test"});
    console.open();
    ASSERT_TRUE(becomes([&] { return console.state().client.datagrams > 10; }));
    QUdpSocket stranger;
    ASSERT_TRUE(stranger.bind(QHostAddress::LocalHost));
    DatagramSeal seal(*DatagramKey::make(), DatagramSeal::Side::Console);
    for (int i = 0; i < 60; ++i)
        stranger.writeDatagram(i % 2 ? seal.seal("report") : QByteArray(i + 1, 'x'), QHostAddress::LocalHost,
                               tracker.address.port);
    ASSERT_TRUE(becomes([&] { return tracker.server.datagramsRefused() == 60; }));
    EXPECT_FALSE(stranger.hasPendingDatagrams()) << "nobody is answered";
    const auto before = console.state().client.datagrams;
    EXPECT_TRUE(becomes([&] { return console.state().client.datagrams > before + 50; }));
    EXPECT_EQ(tracker.server.counts().malformed, 0U);
}

TEST(DatagramLink, AConsoleThatComesBackHasAKeyOfItsOwn) {
    Tracker tracker;
    for (int round = 0; round < 3; ++round) {
        TrackerLink console(tracker.address, {"shore", "test"});
        console.open();
        ASSERT_TRUE(becomes([&] { return console.state().client.datagrams > 20; })) << round;
    }
}

}  // namespace
}  // namespace echotrail
