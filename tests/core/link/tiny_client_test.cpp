// A client that knows nothing but link.proto: its own frames, the generated messages, and no other header of the link.
#include "core/link/link.pb.h"
#include "tests/core/link/link_pair.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace tiny {

using namespace echotrail::wire;

struct Client {
    std::string outgoing, incoming;
    std::map<int, echotrail::wire::Track> tracks;
    std::map<std::string, double> numbers;  ///< parameters
    std::uint64_t revision = 0, beams = 0;
    std::uint32_t console = 0, holder = 0, next_request = 1;
    std::map<std::uint32_t, Reply> replies;
    double strongest_m = 0.0;  ///< range of the strongest echo of the last beam

    void say(const ToTracker& message) {
        const std::string text = message.SerializeAsString();
        const std::size_t n = text.size();
        for (const std::size_t byte : {n >> 24, n >> 16, n >> 8, n}) outgoing.push_back(static_cast<char>(byte & 255));
        outgoing += text;
    }
    void hello() {
        ToTracker message;
        message.mutable_hello()->set_oldest_version(1);
        message.mutable_hello()->set_newest_version(1);
        message.mutable_hello()->set_name("tiny");
        message.mutable_hello()->set_wants_control(true);
        say(message);
    }
    std::uint32_t setRange(double range_m) {
        ToTracker message;
        message.set_request(next_request++);
        message.mutable_set_parameters()->set_base_revision(revision);
        auto* parameter = message.mutable_set_parameters()->add_parameters();
        parameter->set_name("range_m");
        parameter->set_real(range_m);
        say(message);
        return message.request();
    }
    void hear(const std::string& bytes) {
        incoming += bytes;
        while (incoming.size() >= 4) {
            std::size_t n = 0;
            for (int i = 0; i < 4; ++i) n = n * 256 + static_cast<unsigned char>(incoming[static_cast<std::size_t>(i)]);
            if (incoming.size() < 4 + n) return;
            ToConsole message;
            ASSERT_TRUE(message.ParseFromString(incoming.substr(4, n)));
            incoming.erase(0, 4 + n);
            take(message);
        }
    }
    void take(const Parameters& parameters) {
        revision = parameters.revision();
        for (const auto& each : parameters.parameters())
            if (each.value_case() == Parameter::kReal) numbers[each.name()] = each.real();
    }
    void take(const ToConsole& message) {
        if (message.has_welcome()) console = message.welcome().console();
        if (message.has_snapshot()) {
            take(message.snapshot().parameters());
            holder = message.snapshot().control().holder();
            tracks.clear();
            for (const auto& each : message.snapshot().tracks()) tracks[each.id()] = each;
        }
        if (message.has_parameters()) take(message.parameters());
        if (message.has_control()) holder = message.control().holder();
        if (message.has_reply()) replies[message.reply().request()] = message.reply();
        if (message.has_tracks()) {
            for (const auto& each : message.tracks().tracks()) tracks[each.id()] = each;
            for (const int id : message.tracks().gone()) tracks.erase(id);
        }
        if (message.has_beam()) {
            ++beams;
            const auto& beam = message.beam();
            std::size_t strongest = 0;
            for (std::size_t i = 0; i < beam.levels().size(); ++i)
                if (static_cast<unsigned char>(beam.levels()[i]) > static_cast<unsigned char>(beam.levels()[strongest]))
                    strongest = i;
            strongest_m = (static_cast<double>(strongest) + 0.5) * beam.sound_speed_mps() * beam.bin_interval_s() / 2.0;
        }
    }
};

}  // namespace tiny

namespace echotrail {
namespace {

TEST(TinyClient, SomebodyElsesProgramJoinsFollowsAndCommands) {
    test::Wire wire;
    for (std::uint64_t i = 0; i < 10; ++i) wire.ping(i, 2);
    tiny::Client tiny;
    tiny.hello();
    const auto number = wire.server.connected(wire.now());
    ASSERT_TRUE(number);
    const auto carry = [&] {
        wire.server.received(*number, wire.now(), test::bytesOf(std::exchange(tiny.outgoing, {})));
        std::string down;
        wire.server.takeOutput(*number, wire.now(), down, 1 << 24);
        tiny.hear(down);
    };
    carry();
    EXPECT_EQ(tiny.console, *number);
    EXPECT_EQ(tiny.holder, *number);
    EXPECT_EQ(tiny.numbers["range_m"], 50.0);
    EXPECT_EQ(tiny.tracks.size(), 2U);
    EXPECT_EQ(tiny.beams, 10U);
    EXPECT_GT(tiny.strongest_m, 0.0);
    EXPECT_LT(tiny.strongest_m, 50.0);

    wire.ping(10, 3);
    carry();
    EXPECT_EQ(tiny.tracks.size(), 3U);
    const auto asked = tiny.setRange(20.0);
    carry();
    const auto request = wire.server.nextRequest(wire.now());
    ASSERT_TRUE(request);
    wire.server.publishParameters({{"range_m", 20.0}}, wire.now());
    wire.server.answer(*request, {}, wire.now());
    carry();
    EXPECT_TRUE(tiny.replies[asked].done());
    EXPECT_EQ(tiny.numbers["range_m"], 20.0);
    EXPECT_EQ(tiny.revision, 2U);
}

}  // namespace
}  // namespace echotrail
