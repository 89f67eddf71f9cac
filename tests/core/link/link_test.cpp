#include "tests/core/link/link_pair.hpp"

#include <gtest/gtest.h>

namespace echotrail {
namespace {

using namespace test;

/// The tracks as a console knows them, put together from what it heard.
std::map<int, Track> tracksOf(const Console& console) {
    std::map<int, Track> tracks;
    for (const LinkEvent& event : console.events) {
        if (const auto* snapshot = std::get_if<LinkSnapshot>(&event)) {
            tracks.clear();
            for (const Track& track : snapshot->tracks) tracks[track.id] = track;
        }
        if (const auto* change = std::get_if<LinkTracks>(&event)) {
            for (Track track : change->tracks) {
                track.history = tracks[track.id].history;
                tracks[track.id] = track;
            }
            for (const TrackLook& look : change->looks) tracks[look.track].history.push_back(look);
            for (const int id : change->gone) tracks.erase(id);
        }
    }
    return tracks;
}

TEST(Link, WhoComesLateKnowsEverythingAtOnce) {
    Wire wire;
    for (std::uint64_t i = 0; i < 30; ++i) wire.ping(i, 2);
    wire.server.publish(sampleHealth(), wire.now());
    wire.server.publish(LinkLog{wire.now(), LinkLog::Weight::Warning, "disk low"}, wire.now());
    Console late("shore");
    wire.plug(late);
    wire.carry({&late});
    ASSERT_EQ(late.client.status().state, LinkClientStatus::State::Joined);
    const auto snapshots = late.heard<LinkSnapshot>();
    ASSERT_EQ(snapshots.size(), 1U);
    EXPECT_EQ(snapshots[0].parameters, (LinkParameters{1, sampleParameters()}));
    EXPECT_EQ(snapshots[0].tracks.size(), 2U);
    EXPECT_EQ(snapshots[0].tracks[0].history.size(), 2U);
    EXPECT_EQ(snapshots[0].health.head, sampleHealth().head);
    ASSERT_EQ(snapshots[0].log.size(), 1U);
    EXPECT_EQ(snapshots[0].log[0].text, "disk low");
    EXPECT_EQ(snapshots[0].first_ping, at(0.0));
    EXPECT_EQ(late.heard<LinkBeam>().size(), 30U) << "all, for there were no more than three sweeps";
    EXPECT_EQ(late.client.status().gaps, 0U);
}

TEST(Link, ThePictureOfWhoComesLateIsThisSweepAndTheLastTwo) {
    Wire wire;
    for (std::uint64_t i = 0; i < 110; ++i) wire.ping(i);
    Console late("shore");
    wire.plug(late);
    wire.carry({&late});
    const auto beams = late.heard<LinkBeam>();
    ASSERT_EQ(beams.size(), 50U) << "of sweeps of 20 pings";
    EXPECT_EQ(beams.front().update.sweep, 3U);
    EXPECT_TRUE(beams.front().update.sweep_ended);
    for (std::size_t i = 1; i < beams.size(); ++i) EXPECT_EQ(beams[i].ping.sequence, beams[i - 1].ping.sequence + 1);
}

TEST(Link, StreamsArriveWholeAndInOrder) {
    Wire wire;
    Console console("bridge");
    wire.plug(console);
    wire.carry({&console});
    for (std::uint64_t i = 0; i < 50; ++i) {
        wire.ping(i);
        wire.run(0.05, {&console});
    }
    const auto beams = console.heard<LinkBeam>();
    ASSERT_EQ(beams.size(), 50U);
    EXPECT_EQ(beams[20].ping, sampleMoment(20, 2.0).beam->ping);
    EXPECT_EQ(console.heard<LinkRegions>().size(), 50U);
    EXPECT_EQ(console.heard<LinkTracks>().size(), 50U);
    EXPECT_EQ(console.heard<LinkClouds>().size(), 50U);
    EXPECT_EQ(console.client.status().gaps, 0U);
    EXPECT_EQ(console.client.status().malformed, 0U);
}

TEST(Link, WhatHasNotChangedOfTheTracksIsNotSentAgain) {
    Wire wire;
    Console console("bridge");
    wire.plug(console);
    wire.ping(0, 3);
    wire.carry({&console});
    LinkMoment same = sampleMoment(1, 1.0, 3);
    same.looks.clear();
    same.tracks[1].misses = 4;
    same.tracks[2].region_of_interest.north_m += 1.0;  // the vehicle has moved
    wire.server.publish(same, wire.now());
    wire.carry({&console});
    auto heard = console.heard<LinkTracks>();
    ASSERT_EQ(heard.size(), 1U);
    ASSERT_EQ(heard[0].tracks.size(), 1U);
    EXPECT_EQ(heard[0].tracks[0].id, 2);
    same.tracks.pop_back();
    wire.server.publish(same, wire.now());
    wire.carry({&console});
    heard = console.heard<LinkTracks>();
    ASSERT_EQ(heard.size(), 2U);
    EXPECT_EQ(heard[1].gone, std::vector<int>{3});
    EXPECT_TRUE(heard[1].tracks.empty());
}

TEST(Link, AfterABreakTheConsoleComesBackToTheSameState) {
    Wire wire;
    Console steady("bridge"), broken("shore", false);
    wire.plug(steady);
    wire.plug(broken);
    std::uint64_t ping = 0;
    const auto scan = [&](int pings, int tracks) {
        for (int i = 0; i < pings; ++i) {
            wire.ping(ping++, tracks);
            wire.run(0.05, {&steady, &broken});
        }
    };
    for (int round = 0; round < 20; ++round) {
        scan(7, 1 + round % 4);
        wire.pull(broken);
        scan(5, 2 + round % 3);
        wire.server.publishParameters({{"range_m", 10.0 + round}}, wire.now());
        wire.plug(broken);
        scan(3, 2 + round % 3);
        const auto expected = tracksOf(steady), found = tracksOf(broken);
        ASSERT_EQ(found.size(), expected.size()) << round;
        for (const auto& [id, track] : expected) {
            EXPECT_EQ(found.at(id).estimate.mean, track.estimate.mean);
            EXPECT_EQ(found.at(id).estimate.time, track.estimate.time);
            EXPECT_EQ(found.at(id).history.back().time, track.history.back().time);
        }
        EXPECT_EQ(broken.client.status().parameters, steady.client.status().parameters);
        EXPECT_EQ(broken.client.status().control, steady.client.status().control);
    }
    EXPECT_EQ(broken.client.status().joins, 21U);
    EXPECT_EQ(steady.client.status().gaps, 0U);
}

TEST(Link, ParametersAreChangedByWhoHoldsControlAndToldToAll) {
    Wire wire;
    Console bridge("bridge"), shore("shore");
    wire.plug(bridge);
    wire.carry({&bridge});
    wire.plug(shore);
    wire.carry({&bridge, &shore});
    ASSERT_TRUE(bridge.client.status().holdsControl());
    EXPECT_FALSE(shore.client.status().holdsControl());

    const auto watched = shore.client.setParameters({{"range_m", 20.0}});
    const auto commanded = bridge.client.setParameters({{"range_m", 30.0}});
    wire.carry({&bridge, &shore});
    ASSERT_NE(shore.replyTo(watched), nullptr);
    EXPECT_FALSE(shore.replyTo(watched)->done);
    EXPECT_EQ(shore.replyTo(watched)->reason, "bridge holds control");
    const auto request = wire.server.nextRequest(wire.now());
    ASSERT_TRUE(request);
    EXPECT_EQ(request->name, "bridge");
    EXPECT_EQ(std::get<LinkSetParameters>(request->content).values, (std::vector<NamedValue>{{"range_m", 30.0}}));
    wire.server.publishParameters({{"range_m", 30.0}}, wire.now());
    wire.server.answer(*request, {}, wire.now());
    EXPECT_FALSE(wire.server.nextRequest(wire.now()));
    wire.carry({&bridge, &shore});
    EXPECT_TRUE(bridge.replyTo(commanded)->done);
    for (const Console* console : {&bridge, &shore})
        EXPECT_EQ(console->client.status().parameters, (LinkParameters{2, {{"range_m", 30.0}}}));
}

TEST(Link, ParametersChangedFromAnOldRevisionAreRefused) {
    Wire wire;
    Console bridge("bridge");
    wire.plug(bridge);
    wire.carry({&bridge});
    const auto first = bridge.client.setParameters({{"range_m", 30.0}});
    const auto second = bridge.client.setParameters({{"range_m", 40.0}});  // made before the first was answered
    wire.carry({&bridge});
    const auto request = wire.server.nextRequest(wire.now());
    ASSERT_TRUE(request);
    wire.server.publishParameters({{"range_m", 30.0}}, wire.now());
    wire.server.answer(*request, {}, wire.now());
    EXPECT_FALSE(wire.server.nextRequest(wire.now()));
    wire.carry({&bridge});
    EXPECT_TRUE(bridge.replyTo(first)->done);
    EXPECT_FALSE(bridge.replyTo(second)->done);
}

TEST(Link, TheOtherRequestsReachTheRun) {
    Wire wire;
    Console bridge("bridge"), shore("shore");
    wire.plug(bridge);
    wire.carry({&bridge});
    wire.plug(shore);
    wire.carry({&shore});
    bridge.client.designate(25.0, Bearing::degrees(-10.0));
    bridge.client.clearDesignation();
    bridge.client.drop(7, 30.0, Bearing::degrees(4.0));
    bridge.client.restore(7);
    const auto nonsense = bridge.client.drop(0, 30.0, {});
    const auto remark = shore.client.annotate("a seal\nor two");
    wire.carry({&bridge, &shore});
    const auto pick = wire.server.nextRequest(wire.now());
    ASSERT_TRUE(pick && std::holds_alternative<LinkDesignate>(pick->content));
    EXPECT_EQ(std::get<LinkDesignate>(pick->content).range_m, 25.0);
    EXPECT_EQ(std::get<LinkDesignate>(pick->content).from_bow, Bearing::degrees(-10.0));
    const auto clear = wire.server.nextRequest(wire.now());
    ASSERT_TRUE(clear && std::holds_alternative<LinkClearDesignation>(clear->content));
    const auto drop = wire.server.nextRequest(wire.now());
    ASSERT_TRUE(drop && std::holds_alternative<LinkDrop>(drop->content));
    EXPECT_EQ(std::get<LinkDrop>(drop->content).track, 7);
    EXPECT_EQ(std::get<LinkDrop>(drop->content).range_m, 30.0);
    EXPECT_EQ(std::get<LinkDrop>(drop->content).from_bow, Bearing::degrees(4.0));
    const auto back = wire.server.nextRequest(wire.now());
    ASSERT_TRUE(back && std::holds_alternative<LinkRestore>(back->content));
    EXPECT_EQ(std::get<LinkRestore>(back->content).track, 7);
    EXPECT_FALSE(bridge.replyTo(nonsense)->done) << "tracks count from 1";
    const auto note = wire.server.nextRequest(wire.now());
    ASSERT_TRUE(note && std::holds_alternative<LinkAnnotate>(note->content)) << "everybody may remark";
    EXPECT_EQ(std::get<LinkAnnotate>(note->content).text, "a seal or two");
    wire.server.answer(*note, Error{"nothing is recorded"}, wire.now());
    wire.carry({&shore});
    EXPECT_EQ(shore.replyTo(remark)->reason, "nothing is recorded");
}

TEST(Link, ControlIsAskedForHandedOverAndTakenAfterATime) {
    Wire wire;
    Console bridge("bridge"), shore("shore", false);
    const std::vector<Console*> both{&bridge, &shore};
    wire.plug(bridge);
    wire.carry(both);
    wire.plug(shore);
    wire.carry(both);
    shore.client.control(ControlAction::Ask);
    wire.carry(both);
    EXPECT_EQ(bridge.client.status().control.asking_name, "shore") << "the holder is told";
    bridge.client.control(ControlAction::Give);
    wire.carry(both);
    EXPECT_TRUE(shore.client.status().holdsControl());
    EXPECT_FALSE(bridge.client.status().holdsControl());

    bridge.client.control(ControlAction::Ask);
    wire.carry(both);
    const auto early = bridge.client.control(ControlAction::Take);
    wire.carry(both);
    EXPECT_FALSE(bridge.replyTo(early)->done);
    wire.run(16.0, both);
    bridge.client.control(ControlAction::Take);
    wire.carry(both);
    EXPECT_TRUE(bridge.client.status().holdsControl());
    wire.pull(bridge);
    wire.carry(both);
    EXPECT_EQ(shore.client.status().control.holder, 0U) << "nobody had asked";
}

TEST(Link, AConsoleThatReadsNothingDelaysNobodyAndIsDropped) {
    Wire wire;
    Console good("bridge"), stuck("shore", false);
    wire.plug(good);
    wire.plug(stuck);
    wire.carry({&good, &stuck});
    stuck.reads = 0;
    std::size_t most = 0;
    std::uint64_t ping = 0;
    while (stuck.number != 0 && ping < 1000) {
        wire.ping(ping++, 5);
        most = std::max(most, wire.server.waitingBytes(stuck.number));
        wire.run(0.05, {&good, &stuck});
    }
    EXPECT_EQ(stuck.number, 0U);
    EXPECT_NEAR(static_cast<double>(ping) * 0.05, 10.0, 0.5) << "seconds";
    EXPECT_LT(most, 9U << 20U);
    EXPECT_EQ(good.heard<LinkBeam>().size(), ping);
    EXPECT_EQ(good.client.status().gaps, 0U);
    EXPECT_EQ(wire.server.counts().dropped.at("reads nothing"), 1U);
}

TEST(Link, OnASlowWayTracksKeepComingAndThePictureGetsCoarser) {
    Wire wire;
    Console slow("radio", true, 8'000);  // bytes per second
    wire.plug(slow);
    std::uint64_t ping = 0;
    for (; ping < 600; ++ping) {
        LinkMoment moment = sampleMoment(ping, 1e-6 * static_cast<double>(wire.now_us));
        if (ping % 10 != 0) moment = {.time = moment.time, .beam = moment.beam, .tracks = sampleMoment(0, 0.5).tracks};
        wire.server.publish(moment, wire.now());
        wire.run(0.05, {&slow}, 0.025);
    }
    EXPECT_GE(slow.heard<LinkTracks>().size(), 60U);
    EXPECT_GT(wire.server.levelOf(slow.number, wire.now()), SendQueue::Everything);
    const auto beams = slow.heard<LinkBeam>();
    EXPECT_GT(beams.size(), 100U);
    EXPECT_LT(beams.back().ping.levels.size(), beams.front().ping.levels.size());
    Timestamp last{};
    for (const LinkTracks& tracks : slow.heard<LinkTracks>())
        for (const TrackLook& look : tracks.looks) {
            EXPECT_GE(look.time, last);
            last = look.time;
        }
    EXPECT_LT(slow.client.status().bytes, 8'000U * 33U);
}

TEST(Link, WhatWasThrownAwayIsToldAfresh) {
    Wire wire;
    Console console("bridge");
    wire.plug(console);
    wire.carry({&console});
    console.reads = 0;
    for (std::uint64_t i = 0; wire.server.counts().resynchronised == 0 && i < 20'000; ++i) wire.ping(i, 20);
    EXPECT_EQ(wire.server.counts().resynchronised, 1U);
    console.reads = 1 << 24;
    wire.run(2.0, {&console});
    EXPECT_EQ(console.client.status().snapshots, 2U);
    EXPECT_EQ(console.heard<LinkSnapshot>().back().tracks.size(), 20U);
}

TEST(Link, GapsAreCountedAndShownAsGaps) {
    Wire wire;
    Console console("bridge");
    wire.plug(console);
    wire.carry({&console});
    wire.ping(0);
    wire.carry({&console});
    console.reads = 0;
    for (std::uint64_t i = 1; i < 60; ++i) {  // the picture is worth nothing after two seconds
        wire.ping(i);
        wire.run(0.05, {&console});
    }
    console.reads = 1 << 24;
    wire.run(0.1, {&console});
    EXPECT_GT(console.client.status().gaps, 0U);
    const auto beams = console.heard<LinkBeam>();
    const auto after =
        std::find_if(beams.begin(), beams.end(), [](const auto& beam) { return beam.ping.sequence > 0; });
    ASSERT_NE(after, beams.end());
    EXPECT_TRUE(after->update.broke_off);
}

TEST(Link, AgesAndLatencyFollowTheTrackersClock) {
    Wire wire;
    Console console("bridge");
    wire.plug(console);
    wire.carry({&console});
    EXPECT_EQ(console.client.trackerTime(wire.monotonic()), wire.now()) << "the wire takes no time";
    EXPECT_EQ(console.client.status().round_trip, Microseconds(0));
    wire.ping(0);
    wire.now_us += 300'000;
    wire.carry({&console});
    EXPECT_EQ(console.client.status().latency, Microseconds(300'000));
    wire.now_us += 2'000'000;
    EXPECT_DOUBLE_EQ(*console.client.linkAge(wire.monotonic()), 2.0);
}

TEST(Link, ATrackerThatSaysNothingIsLeft) {
    LinkClient client(LinkClient::Options{.identity = {"bridge", "test"}});
    client.linkUp(Microseconds(0));
    client.tick(Microseconds(9'000'000));
    EXPECT_FALSE(client.wantsToClose());
    client.tick(Microseconds(11'000'000));
    EXPECT_TRUE(client.wantsToClose());
}

TEST(Link, WhatWasAskedWhenTheLinkBrokeIsAnsweredWithThat) {
    Wire wire;
    Console console("bridge");
    wire.plug(console);
    wire.carry({&console});
    const auto request = console.client.setParameters({{"range_m", 30.0}});
    wire.pull(console);
    ASSERT_NE(console.replyTo(request), nullptr);
    EXPECT_FALSE(console.replyTo(request)->done);
    EXPECT_EQ(console.client.setParameters({{"range_m", 30.0}}), 0U) << "there is no link";
}

TEST(Link, AnotherVersionIsRefusedInWords) {
    Wire wire;
    Console console("bridge");
    wire.plug(console);
    console.client.takeOutput();
    // The hello of a program that speaks versions 7 to 9 only: fields 1 and 2 of field 2.
    const std::string hello = linkFrame(std::string("\x12\x04\x08\x07\x10\x09", 6));
    wire.server.received(console.number, wire.now(), bytesOf(hello));
    wire.carry({&console});
    EXPECT_EQ(console.number, 0U);
    EXPECT_NE(console.client.status().refusal.find("(1 to 1)"), std::string::npos) << console.client.status().refusal;
}

}  // namespace
}  // namespace echotrail
