#include "core/base/random.hpp"
#include "core/link/link.pb.h"
#include "tests/core/link/link_pair.hpp"

#include <gtest/gtest.h>

namespace echotrail {
namespace {

using namespace test;

std::string framed(const wire::ToTracker& message) { return linkFrame(message.SerializeAsString()); }

std::string helloFrame() {
    wire::ToTracker message;
    message.mutable_hello()->set_oldest_version(1);
    message.mutable_hello()->set_newest_version(1);
    message.mutable_hello()->set_name("stranger");
    message.mutable_hello()->set_wants_control(true);
    return framed(message);
}

/// One of everything a console can say.
std::string everyRequest() {
    std::string stream = helloFrame();
    wire::ToTracker message;
    message.set_request(1);
    message.mutable_probe()->set_console_us(5);
    stream += framed(message);
    auto* parameter = message.mutable_set_parameters()->add_parameters();
    parameter->set_name("range_m");
    parameter->set_real(20.0);
    message.mutable_set_parameters()->set_base_revision(1);
    stream += framed(message);
    message.mutable_designate()->set_range_m(20.0);
    stream += framed(message);
    message.mutable_clear_designation();
    stream += framed(message);
    message.mutable_annotate()->set_text("a remark");
    stream += framed(message);
    message.mutable_control()->set_action(wire::ControlRequest::GIVE);
    stream += framed(message);
    message.mutable_snapshot();
    stream += framed(message);
    message.mutable_list_recordings();
    stream += framed(message);
    message.mutable_describe_recording()->set_recording("a.echotrail");
    stream += framed(message);
    message.mutable_read_rows()->set_last(9);
    stream += framed(message);
    return stream;
}

/// One of everything a tracker can say.
std::string everythingSaid() {
    Wire wire;
    Console console("bridge");
    wire.plug(console);
    std::string stream;
    wire.server.received(console.number, wire.now(), bytesOf(console.client.takeOutput()));
    wire.ping(0, 2);
    wire.server.publish(sampleHealth(), wire.now());
    wire.server.publish(LinkLog{wire.now(), LinkLog::Weight::Alarm, "text"}, wire.now());
    wire.server.publishParameters(sampleParameters(), wire.now());
    wire.server.takeOutput(console.number, wire.now(), stream, 1 << 24);
    return stream;
}

/// Feeds a tracker with whatever bytes; it must stay whole, answer the next one, and bound what it holds.
void feedServer(const std::string& bytes, std::size_t chunk = 1 << 20) {
    Wire wire;
    const auto number = wire.server.connected(wire.now());
    ASSERT_TRUE(number);
    for (std::size_t at = 0; at < bytes.size(); at += chunk)
        wire.server.received(*number, wire.now(), bytesOf(bytes.substr(at, chunk)));
    while (const auto request = wire.server.nextRequest(wire.now())) wire.server.answer(*request, {}, wire.now());
    wire.ping(0);
    EXPECT_LT(wire.server.waitingBytes(*number), 1U << 20U);
    wire.server.disconnected(*number, wire.now());
    Console good("bridge");
    wire.plug(good);
    wire.carry({&good});
    EXPECT_EQ(good.client.status().state, LinkClientStatus::State::Joined);
    EXPECT_TRUE(good.client.status().holdsControl());
}

void feedClient(const std::string& bytes) {
    LinkClient client(LinkClient::Options{.identity = {"bridge", "test"}});
    client.linkUp(Microseconds(0));
    client.received(Microseconds(1000), bytesOf(bytes));
    while (client.next()) {
    }
    client.linkDown();
    client.linkUp(Microseconds(2000));
    EXPECT_FALSE(client.wantsToClose()) << "it can be used again";
}

TEST(Hostile, EveryTruncationOfWhatAConsoleSaysIsBorne) {
    const std::string stream = everyRequest();
    for (std::size_t size = 0; size < stream.size(); ++size) feedServer(stream.substr(0, size));
}

TEST(Hostile, EveryTruncationOfWhatATrackerSaysIsBorne) {
    const std::string stream = everythingSaid();
    ASSERT_GT(stream.size(), 2000U);
    for (std::size_t size = 0; size < stream.size(); size += 1 + size / 200) feedClient(stream.substr(0, size));
}

TEST(Hostile, EveryTruncationOfEachMessageIsRefusedOrBorne) {
    FrameReader reader(1 << 24);
    const std::string stream = everythingSaid();
    reader.take(bytesOf(stream));
    std::string before;
    while (const auto message = reader.next()) {
        const std::string whole(*message);
        for (std::size_t size = 1; size < whole.size(); size += 1 + size / 100)
            feedClient(before + linkFrame(whole.substr(0, size)));
        if (before.empty()) before = linkFrame(whole);  // the welcome, without which nothing else is heard
    }
}

TEST(Hostile, RandomCorruptionIsBorneOnBothSides) {
    const std::string up = everyRequest(), down = everythingSaid();
    RandomStream random(1, 0, 0);
    const auto corrupted = [&](std::string stream) {
        const int flips = 1 + static_cast<int>(random.bits() % 8);
        for (int i = 0; i < flips; ++i)
            stream[random.bits() % stream.size()] ^= static_cast<char>(1U << random.bits() % 8);
        return stream;
    };
    for (int i = 0; i < 2000; ++i) {
        feedServer(corrupted(up), 1 + i % 97);
        feedClient(corrupted(down));
    }
}

TEST(Hostile, BytesOfSomethingElseAreRefusedAndCounted) {
    for (const std::string& bytes :
         {std::string("GET / HTTP/1.1\r\n\r\n"), std::string(100'000, '\xff'), std::string(100, '\0'),
          linkFrame("\xff\xff\xff\xff"), linkFrame(std::string("\x12\x7f", 2))}) {
        Wire wire;
        const auto number = wire.server.connected(wire.now());
        wire.server.received(*number, wire.now(), bytesOf(bytes));
        EXPECT_TRUE(wire.server.isClosing(*number));
        EXPECT_EQ(wire.server.counts().malformed, 1U);
        std::string out;
        wire.server.takeOutput(*number, wire.now(), out, 1 << 20);
        EXPECT_LT(out.size(), 200U) << "no more than the refusal";
    }
}

TEST(Hostile, WhoSaysNoHelloHearsNothingAndIsDropped) {
    Wire wire;
    const auto number = wire.server.connected(wire.now());
    wire.ping(0);
    std::string out;
    wire.server.takeOutput(*number, wire.now(), out, 1 << 20);
    EXPECT_TRUE(out.empty());
    wire.now_us += 6'000'000;
    wire.server.tick(wire.now());
    EXPECT_TRUE(wire.server.isClosing(*number));
    const auto rude = wire.server.connected(wire.now());
    wire::ToTracker message;
    message.mutable_snapshot();
    wire.server.received(*rude, wire.now(), bytesOf(framed(message)));
    EXPECT_TRUE(wire.server.isClosing(*rude));
}

TEST(Hostile, WhoFallsSilentIsDropped) {
    Wire wire;
    Console console("bridge");
    wire.plug(console);
    wire.carry({&console});
    wire.now_us += 16'000'000;
    wire.server.tick(wire.now());
    EXPECT_TRUE(wire.server.isClosing(console.number));
}

TEST(Hostile, AThousandConnectionsAreTurnedAway) {
    Wire wire;
    Console good("bridge");
    wire.plug(good);
    wire.carry({&good});
    for (int i = 0; i < 1000; ++i) wire.server.connected(wire.now());
    EXPECT_EQ(wire.server.consoles(), link_limits::most_consoles);
    EXPECT_EQ(wire.server.counts().turned_away, 1000U - (link_limits::most_consoles - 1));
    wire.ping(0);
    wire.carry({&good});
    EXPECT_EQ(good.heard<LinkBeam>().size(), 1U);
}

TEST(Hostile, ARequestThatCannotBeIsRefusedCountedAndInTheEndNotBorne) {
    Wire wire;
    const auto number = wire.server.connected(wire.now());
    wire.server.received(*number, wire.now(), bytesOf(helloFrame()));
    wire::ToTracker message;
    message.set_request(9);
    message.mutable_designate()->set_range_m(-5.0);
    for (int i = 0; i < 19; ++i) wire.server.received(*number, wire.now(), bytesOf(framed(message)));
    EXPECT_FALSE(wire.server.isClosing(*number));
    EXPECT_EQ(wire.server.counts().refused.at("unsound"), 19U);
    EXPECT_FALSE(wire.server.nextRequest(wire.now())) << "nothing of it reaches the run";
    for (int i = 0; i < 2; ++i) wire.server.received(*number, wire.now(), bytesOf(framed(message)));
    EXPECT_TRUE(wire.server.isClosing(*number));
}

TEST(Hostile, AFloodOfRequestsIsCutOff) {
    Wire wire;
    const auto number = wire.server.connected(wire.now());
    std::string flood = helloFrame();
    wire::ToTracker message;
    message.set_request(1);
    message.mutable_annotate()->set_text("x");
    for (int i = 0; i < 1000; ++i) flood += framed(message);
    wire.server.received(*number, wire.now(), bytesOf(flood));
    EXPECT_TRUE(wire.server.isClosing(*number));
    EXPECT_GT(wire.server.counts().refused.at("too_many"), 0U);
    std::size_t reached = 0;
    while (wire.server.nextRequest(wire.now())) ++reached;
    EXPECT_EQ(reached, link_limits::most_waiting_requests);
}

TEST(Hostile, TooManyParametersAndTooLongARemarkAreRefused) {
    Wire wire;
    const auto number = wire.server.connected(wire.now());
    wire.server.received(*number, wire.now(), bytesOf(helloFrame()));
    wire::ToTracker message;
    message.set_request(1);
    for (int i = 0; i < 1001; ++i) {
        auto* parameter = message.mutable_set_parameters()->add_parameters();
        parameter->set_name("a");
        parameter->set_flag(true);
    }
    wire.server.received(*number, wire.now(), bytesOf(framed(message)));
    message.mutable_annotate()->set_text(std::string(1001, 'x'));
    wire.server.received(*number, wire.now(), bytesOf(framed(message)));
    EXPECT_EQ(wire.server.counts().refused.at("unsound"), 2U);
    EXPECT_FALSE(wire.server.nextRequest(wire.now()));
}

TEST(Hostile, AConsolesNameIsMadeFitToBeShown) {
    Wire wire;
    const auto number = wire.server.connected(wire.now());
    wire::ToTracker message;
    message.mutable_hello()->set_oldest_version(1);
    message.mutable_hello()->set_newest_version(1);
    message.mutable_hello()->set_wants_control(true);
    message.mutable_hello()->set_name("evil\nname\x1b[2J" + std::string(1000, 'x'));
    wire.server.received(*number, wire.now(), bytesOf(framed(message)));
    const std::string& name = wire.server.control().holder_name;
    EXPECT_EQ(name.size(), 64U);
    EXPECT_EQ(name.find_first_of("\n\x1b"), std::string::npos);
}

}  // namespace
}  // namespace echotrail
