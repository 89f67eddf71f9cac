#pragma once

#include "core/link/link_client.hpp"
#include "core/link/link_server.hpp"
#include "tests/core/link/sample_values.hpp"

#include <memory>
#include <string>
#include <vector>

namespace echotrail::test {

inline std::span<const std::uint8_t> bytesOf(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// A console at the end of a wire that the test holds in its hand.
struct Console {
    explicit Console(const std::string& name, bool wants_control = true, std::uint64_t bytes_per_second = 0)
        : client({{name, "test"}, wants_control, bytes_per_second}) {}

    template <class Event>
    std::vector<Event> heard() const {
        std::vector<Event> all;
        for (const LinkEvent& event : events)
            if (const auto* each = std::get_if<Event>(&event)) all.push_back(*each);
        return all;
    }
    /// Of the last request but those before `from`.
    const LinkReply* replyTo(std::uint32_t request) const {
        for (const LinkEvent& event : events)
            if (const auto* reply = std::get_if<LinkReply>(&event); reply && reply->request == request) return reply;
        return nullptr;
    }

    LinkClient client;
    std::uint32_t number = 0;  ///< at the tracker; 0: no wire
    std::vector<LinkEvent> events;
    std::size_t reads = 1 << 24;  ///< bytes that it takes in one turn of the wire
};

/// A tracker, consoles, and a clock that goes when the test says so.
struct Wire {
    Wire() : server({"vehicle", "echotrail test"}, 42, sampleParameters()) {}

    Timestamp now() const { return at(0.0) + Microseconds(now_us); }
    Microseconds monotonic() const { return Microseconds(now_us); }

    void plug(Console& console) {
        const auto number = server.connected(now());
        if (!number) return;
        console.number = *number;
        console.client.linkUp(monotonic());
    }
    void pull(Console& console) {
        server.disconnected(console.number, now());
        console.number = 0;
        console.client.linkDown();
        takeEvents(console);
    }
    /// Everything that waits goes over, both ways, until nothing moves.
    void carry(std::vector<Console*> consoles) {
        for (int turn = 0; turn < 4; ++turn)
            for (Console* console : consoles) {
                if (console->number == 0) continue;
                const std::string up = console->client.takeOutput();
                server.received(console->number, now(), bytesOf(up));
                std::string down;
                server.takeOutput(console->number, now(), down, console->reads);
                console->client.received(monotonic(), bytesOf(down));
                takeEvents(*console);
                if (server.isClosing(console->number) || console->client.wantsToClose()) pull(*console);
            }
    }
    /// The clock goes on by so much in steps, each with a turn of the wire.
    void run(double seconds, std::vector<Console*> consoles, double step_s = 0.05) {
        for (double passed = 0.0; passed < seconds - 1e-9; passed += step_s) {
            now_us += static_cast<std::int64_t>(step_s * 1e6);
            server.tick(now());
            for (Console* console : consoles) console->client.tick(monotonic());
            carry(consoles);
        }
    }
    void ping(std::uint64_t number, int tracks = 1) {
        server.publish(sampleMoment(number, 1e-6 * static_cast<double>(now_us), tracks), now());
    }
    static void takeEvents(Console& console) {
        while (auto event = console.client.next()) console.events.push_back(*std::move(event));
    }

    LinkServer server;
    std::int64_t now_us = 1'000'000;
};

}  // namespace echotrail::test
