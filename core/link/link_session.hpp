#pragma once

#include "core/link/datagram_way.hpp"
#include "core/link/framing.hpp"
#include "core/link/link_limits.hpp"
#include "core/link/link_values.hpp"
#include "core/link/send_queue.hpp"

#include <optional>
#include <string>

namespace echotrail {

/// What the tracker keeps of one console.
struct LinkSession {
    LinkSession(std::uint32_t number, Timestamp now)
        : console(number), connected(now), last_heard(now), budget_filled(now) {}

    std::uint32_t console;
    std::string name, program;
    bool welcomed = false;
    bool needs_snapshot = false;  ///< something it cannot do without was thrown away
    bool closing = false;         ///< what waits is the last it hears
    std::uint32_t refusals = 0;
    Timestamp connected, last_heard, snapshot_sent{}, rows_sent{};
    FrameReader reader{link_limits::longest_request};
    SendQueue queue;
    std::optional<LinkDatagrams> datagram_offer;  ///< none where there are none
    DatagramWay datagrams;

    /// Whether streams go to it by datagrams now.
    bool usesDatagrams(Timestamp now) const { return datagram_offer && datagrams.works(now); }
    /// How much is left out of the streams to it.
    SendQueue::Level level(Timestamp now) const { return usesDatagrams(now) ? datagrams.level() : queue.level(); }
    /// One request more; false where it has had too many lately.
    bool mayAsk(Timestamp now);

private:
    double budget = link_limits::requests_at_once;
    Timestamp budget_filled;
};

}  // namespace echotrail
