#pragma once

#include "core/base/time.hpp"
#include "core/link/send_queue.hpp"

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace echotrail {

/// What the tracker knows of the datagrams to one console: whether they arrive, how many are lost, which wait. Where
/// more wait than may, the newest stay: they are what matters.
/// What goes this way is left out by its own level, whatever waits on the other way. Loss by chance, as radios have it,
/// does not become less by sending less: some loss costs detail, only much of it all the rest, step by step.
/// Order: times never go back.
class DatagramWay {
public:
    /// The console says what has arrived. Where enough was sent since it was last judged, that decides on the level.
    void report(std::uint64_t newest, std::uint64_t received, Timestamp now);
    /// Whether what is sent arrives, as far as is known.
    bool works(Timestamp now) const;
    static bool fits(const SendQueue::Frame& frame);
    /// One that fits.
    void add(const SendQueue::Frame& frame);
    /// The console's share of the way does not let something through that was to go.
    void tellCrowded(Timestamp now);
    SendQueue::Level level() const { return level_; }
    /// Something short that is to arrive.
    void addEcho(std::string text) { waiting_.push_back(std::move(text)); }
    /// What waits, each the text of one datagram.
    std::vector<std::string> take();

private:
    void step(int levels, Microseconds not_before, Timestamp now);

    std::deque<std::string> waiting_;
    SendQueue::Level level_ = SendQueue::Everything;
    Timestamp level_changed_{};
    std::uint64_t newest_ = 0, received_ = 0;  ///< when it was last judged
    std::uint64_t received_last_ = 0;
    std::optional<Timestamp> arrived_;
};

}  // namespace echotrail
