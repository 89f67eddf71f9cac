#include "app/io/console_server.hpp"

#include "app/io/tracker_link.hpp"
#include "core/runtime/link_moment.hpp"
#include "tests/app/io/event_loop.hpp"
#include "tests/core/link/sample_values.hpp"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QTcpSocket>
#include <chrono>
#include <vector>

namespace echotrail {
namespace {

Timestamp clockNow() { return std::chrono::time_point_cast<Microseconds>(std::chrono::system_clock::now()); }

LinkAddress here() { return parseLinkAddress("tcp://127.0.0.1:0").value(); }

/// A tracker that does what it is asked for.
struct Served {
    explicit Served(const LinkAddress& where = here())
        : server({"vehicle", "test"}, namedValues({}), clockNow,
                 [this](const LinkRequest& request) { return answer(request); }) {
        address = server.listen(where).value();
    }
    Result<std::optional<std::vector<NamedValue>>> answer(const LinkRequest& request) {
        requests.push_back(request);
        const auto* wanted = std::get_if<LinkSetParameters>(&request.content);
        if (!wanted) return std::optional<std::vector<NamedValue>>();
        if (auto set = setNamedValues(params, wanted->values); !set) return Error{set.error()};
        return std::optional(namedValues(params));
    }
    void ping(std::uint64_t number) {
        LinkMoment moment = test::sampleMoment(number, 0.0);
        moment.beam->ping.time = moment.beam->update.time = clockNow();
        server.publish(moment);
        server.flush();
    }

    ScanningSonarPipeline::Params params;
    std::vector<LinkRequest> requests;
    ConsoleServer server;
    LinkAddress address;
};

struct Follower {
    explicit Follower(const LinkAddress& address) : link(address, {"shore", "test"}) { link.open(); }
    bool joined() {
        return becomes([this] { return link.state().up && link.state().client.snapshots > 0; });
    }
    std::string notices() {
        std::string all;
        while (const auto notice = link.takeNotice()) all += notice->text + "\n";
        return all;
    }
    TrackerLink link;
};

TEST(ConsoleServer, ServesThisMachineOnlyButByTls) {
    for (const char* good : {"tcp://127.0.0.1:0", "tcp://localhost:0", "tcp://[::1]:7000", "tcp://127.5.5.5:1",
                             "tls://0.0.0.0:0", "tls://192.168.1.5:7000", "tls://[::]:1"})
        EXPECT_TRUE(checkServable(parseLinkAddress(good).value())) << good;
    for (const char* bad : {"tcp://0.0.0.0:0", "tcp://192.168.1.5:7000", "tcp://[::]:7000", "tcp://vehicle:7000",
                            "udp://127.0.0.1:7000", "pty", "tls://vehicle:7000"}) {
        const auto refused = checkServable(parseLinkAddress(bad).value());
        ASSERT_FALSE(refused) << bad;
        EXPECT_EQ(refused.error().find('\n'), std::string::npos);
    }
    ConsoleServer server({"vehicle", "test"}, {}, clockNow, {});
    EXPECT_FALSE(server.listen(parseLinkAddress("tcp://0.0.0.0:0").value())) << "not even when it was not asked before";
}

TEST(ConsoleServer, APortThatIsTakenIsRefusedInOneLine) {
    Served first;
    ConsoleServer second({"vehicle", "test"}, {}, clockNow, {});
    const auto refused = second.listen(first.address);
    ASSERT_FALSE(refused);
    EXPECT_TRUE(refused.error().starts_with("cannot serve consoles on " + toText(first.address))) << refused.error();
}

TEST(ConsoleServer, AConsoleJoinsSeesAndCommands) {
    Served tracker;
    Follower console(tracker.address);
    ASSERT_TRUE(console.joined());
    EXPECT_TRUE(becomes([&] { return console.link.state().client.holdsControl(); }));
    tracker.ping(0);
    std::optional<Scene> scene;
    ASSERT_TRUE(becomes([&] { return (scene = console.link.scenes().take()) && !scene->tracks.empty(); }));
    EXPECT_EQ(scene->tracks.size(), 1U);
    ASSERT_TRUE(becomes([&] { return console.link.state().tracker_time.has_value(); }));
    EXPECT_LT(std::abs(secondsBetween(*console.link.state().tracker_time, clockNow())), 0.5);

    ASSERT_TRUE(becomes([&] { return console.link.takeParams().has_value(); })) << "those in force, when it joins";
    auto params = console.link.state().params;
    params.head.range_m = 30.0;
    console.link.setParams(params);
    params.head.gain_percent = 55.0;
    console.link.setParams(params);  // while the first is on its way
    ASSERT_TRUE(becomes([&] { return console.link.state().params.head.gain_percent == 55.0; }));
    EXPECT_EQ(tracker.params.head.range_m, 30.0);
    EXPECT_EQ(console.notices().find("not changed"), std::string::npos);
    console.link.designate(20.0, Bearing::degrees(5.0));
    ASSERT_TRUE(becomes([&] { return tracker.requests.size() == 3; }));
    EXPECT_EQ(std::get<LinkDesignate>(tracker.requests[2].content).range_m, 20.0);
}

TEST(ConsoleServer, WhoOnlyWatchesIsToldSoAndShownWhatIsInForce) {
    Served tracker;
    Follower commander(tracker.address);
    ASSERT_TRUE(commander.joined());
    Follower watcher(tracker.address);
    ASSERT_TRUE(watcher.joined());
    ASSERT_TRUE(becomes([&] { return watcher.link.takeParams().has_value(); }));
    auto params = watcher.link.state().params;
    params.head.range_m = 20.0;
    watcher.link.setParams(params);
    std::optional<RemoteScene::Params> echo;
    ASSERT_TRUE(becomes([&] { return (echo = watcher.link.takeParams()).has_value(); }));
    EXPECT_EQ(echo->head.range_m, 50.0);
    EXPECT_NE(watcher.notices().find("holds control"), std::string::npos);
    EXPECT_TRUE(tracker.requests.empty());

    watcher.link.control(ControlAction::Ask);
    std::string told;
    ASSERT_TRUE(becomes([&] { return (told += commander.notices()).find("asks for control") != std::string::npos; }));
    commander.link.control(ControlAction::Give);
    ASSERT_TRUE(becomes([&] { return watcher.link.state().client.holdsControl(); }));
}

TEST(ConsoleServer, AConsoleComesBackByItselfWhenTheTrackerDoes) {
    auto tracker = std::make_unique<Served>();
    const LinkAddress address = tracker->address;
    Follower console(address);
    ASSERT_TRUE(console.joined());
    tracker->ping(0);
    ASSERT_TRUE(becomes([&] { return console.link.scenes().take().has_value(); }));
    for (int round = 0; round < 3; ++round) {
        tracker.reset();
        ASSERT_TRUE(becomes([&] { return !console.link.state().up; }));
        EXPECT_FALSE(console.link.state().reason.empty());
        tracker = std::make_unique<Served>(address);
        ASSERT_TRUE(becomes([&] { return console.link.state().up; })) << round;
        console.link.scenes().take();
        tracker->ping(5);
        std::optional<Scene> scene;
        ASSERT_TRUE(becomes([&] { return (scene = console.link.scenes().take()).has_value(); }));
        EXPECT_EQ(scene->position, 6U) << "another run";
    }
}

TEST(ConsoleServer, WhoReadsNothingAndWhoTalksNonsenseDoNotDisturbTheOthers) {
    Served tracker;
    std::vector<std::unique_ptr<QTcpSocket>> hostile;
    for (int i = 0; i < 8; ++i) {
        hostile.push_back(std::make_unique<QTcpSocket>());
        hostile.back()->connectToHost("127.0.0.1", tracker.address.port);
        hostile.back()->write(QByteArray(100'000, i % 2 ? '\xff' : 'G'));
    }
    // Says hello and never reads: fields 1 and 2 of field 2, version 1.
    QTcpSocket deaf;
    deaf.setReadBufferSize(1);
    deaf.connectToHost("127.0.0.1", tracker.address.port);
    deaf.write(QByteArray("\0\0\0\6\x12\4\x08\1\x10\1", 10));
    Follower good(tracker.address);
    ASSERT_TRUE(good.joined());
    ASSERT_TRUE(becomes([&] { return tracker.server.counts().malformed == 8; }));
    for (std::uint64_t i = 0; i < 300; ++i) {
        tracker.ping(i);
        ASSERT_TRUE(becomes([&] { return good.link.state().client.messages > 3 * i; }));
    }
    EXPECT_EQ(good.link.state().client.malformed, 0U);
    EXPECT_EQ(good.link.state().client.gaps, 0U);
    ASSERT_TRUE(becomes([&] { return tracker.server.consoles() <= 2; })) << "those who talk nonsense are gone";
}

TEST(ConsoleServer, AThousandConnectionsAreBorne) {
    Served tracker;
    Follower good(tracker.address);
    ASSERT_TRUE(good.joined());
    for (int i = 0; i < 20; ++i) {
        std::vector<std::unique_ptr<QTcpSocket>> many;
        for (int j = 0; j < 50; ++j) {
            many.push_back(std::make_unique<QTcpSocket>());
            many.back()->connectToHost("127.0.0.1", tracker.address.port);
        }
        QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
    }
    ASSERT_TRUE(becomes([&] { return tracker.server.consoles() == 1; }));
    tracker.ping(0);
    EXPECT_TRUE(becomes([&] { return good.link.state().last_ping.has_value(); }));
    EXPECT_TRUE(good.link.state().up);
}

}  // namespace
}  // namespace echotrail
