#include "core/runtime/remote_scene.hpp"

#include "core/link/link_client.hpp"
#include "core/link/link_server.hpp"
#include "core/runtime/link_moment.hpp"
#include "sector_scan.hpp"

#include <gtest/gtest.h>

#include <climits>

namespace echotrail {
namespace {

/// A tracker on a simulated scan, serving; and what it would show itself.
class Aboard {
public:
    explicit Aboard(std::uint64_t run = 1)
        : server({"vehicle", "test"}, run, namedValues({})), pipeline_({}, 3), scan_(test::sectorScan(400)) {}

    void ping() {
        const Ping& ping = scan_[next_++];
        const Update update = pipeline_.process(ping, {});
        builder_.add(ping, update, 0.0);
        now = ping.time;
        server.publish(linkMoment(ping, update, pipeline_, scan_[0].time, false), now);
        scene = builder_.build(pipeline_, ping, update);
    }
    void designate() { pipeline_.designate(15.0, Bearing::degrees(4.0)); }

    LinkServer server;
    Timestamp now{};
    Scene scene;

private:
    ScanningSonarPipeline pipeline_;
    std::vector<Ping> scan_;
    SceneBuilder builder_;
    std::size_t next_ = 0;
};

class Ashore {
public:
    void connect(Aboard& aboard) {
        console_ = aboard.server.connected(aboard.now).value();
        client_.linkUp(now());
        carry(aboard);
    }
    void disconnect(Aboard& aboard) {
        aboard.server.disconnected(console_, aboard.now);
        client_.linkDown();
    }
    void carry(Aboard& aboard) {
        ++turns_;
        client_.tick(now());
        const std::string up = client_.takeOutput();
        aboard.server.received(console_, aboard.now, {reinterpret_cast<const std::uint8_t*>(up.data()), up.size()});
        std::string down;
        aboard.server.takeOutput(console_, aboard.now, down, 1 << 24);
        client_.received(now(), {reinterpret_cast<const std::uint8_t*>(down.data()), down.size()});
        while (const auto event = client_.next()) remote.take(*event);
    }
    RemoteScene remote;

private:
    Microseconds now() const { return Microseconds(turns_ * 50'000); }
    LinkClient client_{LinkClient::Options{.identity = {"shore", "test"}}};
    std::uint32_t console_ = 0;
    int turns_ = 0;
};

/// How many pixels differ.
int differences(const cv::Mat& a, const cv::Mat& b) {
    return a.size() == b.size() ? cv::countNonZero(a != b) : INT_MAX;
}

void expectSame(const Scene& remote, const Scene& aboard) {
    EXPECT_EQ(remote.position, aboard.ping.sequence + 1);
    EXPECT_EQ(remote.ping, aboard.ping);
    EXPECT_EQ(remote.sweep_s, aboard.sweep_s);
    EXPECT_EQ(remote.sector_left, aboard.sector_left);
    EXPECT_EQ(remote.sector_right, aboard.sector_right);
    EXPECT_EQ(differences(remote.fan.levels, aboard.fan.levels), 0);
    EXPECT_EQ(differences(remote.fan.beam_time_ms, aboard.fan.beam_time_ms), 0);
    ASSERT_EQ(remote.regions.size(), aboard.regions.size());
    for (std::size_t i = 0; i < remote.regions.size(); ++i) {
        EXPECT_EQ(remote.regions[i].id, aboard.regions[i].id);
        EXPECT_EQ(remote.regions[i].outline_m, aboard.regions[i].outline_m);
    }
    ASSERT_EQ(remote.tracks.size(), aboard.tracks.size());
    for (std::size_t i = 0; i < remote.tracks.size(); ++i) {
        EXPECT_EQ(remote.tracks[i].id, aboard.tracks[i].id);
        EXPECT_EQ(remote.tracks[i].state, aboard.tracks[i].state);
        EXPECT_EQ(remote.tracks[i].target, aboard.tracks[i].target);
        EXPECT_EQ(remote.tracks[i].estimate.mean, aboard.tracks[i].estimate.mean);
        EXPECT_EQ(remote.tracks[i].history.size(), aboard.tracks[i].history.size());
    }
}

TEST(RemoteScene, AshoreIsSeenWhatIsSeenAboard) {
    Aboard aboard;
    Ashore ashore;
    ashore.connect(aboard);
    for (int i = 0; i < 200; ++i) {
        if (i == 60) aboard.designate();
        aboard.ping();
        ashore.carry(aboard);
    }
    ASSERT_FALSE(aboard.scene.tracks.empty());
    const Scene scene = ashore.remote.build(false);
    expectSame(scene, aboard.scene);
    EXPECT_GT(scene.tracks[0].particles.position_m.size(), 100U);
    EXPECT_TRUE(scene.tracks[0].target);
    EXPECT_FALSE(ashore.remote.changed());
    EXPECT_TRUE(scene.enhanced.empty());
    EXPECT_FALSE(ashore.remote.build(true).enhanced.empty());
}

TEST(RemoteScene, WhoComesLateSeesTheSame) {
    Aboard aboard;
    for (int i = 0; i < 150; ++i) aboard.ping();
    Ashore ashore;
    ashore.connect(aboard);
    expectSame(ashore.remote.build(false), aboard.scene);
}

TEST(RemoteScene, AfterABreakItIsTheSameAgain) {
    Aboard aboard;
    Ashore ashore;
    ashore.connect(aboard);
    for (int i = 0; i < 60; ++i) {
        aboard.ping();
        ashore.carry(aboard);
    }
    ashore.disconnect(aboard);
    for (int i = 0; i < 100; ++i) aboard.ping();
    ashore.connect(aboard);
    for (int i = 0; i < 50; ++i) {
        aboard.ping();
        ashore.carry(aboard);
    }
    expectSame(ashore.remote.build(false), aboard.scene);
}

TEST(RemoteScene, NothingOfAnotherRunIsKept) {
    Aboard first(1);
    Ashore ashore;
    ashore.connect(first);
    for (int i = 0; i < 150; ++i) {
        first.ping();
        ashore.carry(first);
    }
    ASSERT_FALSE(ashore.remote.build(false).tracks.empty());
    ashore.disconnect(first);
    Aboard second(2);
    ashore.connect(second);
    EXPECT_FALSE(ashore.remote.lastPing());
    second.ping();
    ashore.carry(second);
    EXPECT_TRUE(ashore.remote.build(false).tracks.empty());
    EXPECT_EQ(ashore.remote.build(false).position, 1U);
}

TEST(RemoteScene, ParametersAreSetAllOrNone) {
    ScanningSonarPipeline::Params params;
    EXPECT_FALSE(setNamedValues(params, {{"range_m", 30.0}, {"no_such_thing", 1.0}}));
    EXPECT_FALSE(setNamedValues(params, {{"range_m", 30.0}, {"sector_width_deg", 4000.0}}));
    EXPECT_EQ(params.head.range_m, 50.0);
    EXPECT_TRUE(setNamedValues(params, {{"range_m", 30.0}, {"channel", std::string("low")}}));
    EXPECT_EQ(params.head.range_m, 30.0);
    EXPECT_EQ(namedValues(params).size(), describeParameters<ScanningSonarPipeline::Params>().size());
}

}  // namespace
}  // namespace echotrail
