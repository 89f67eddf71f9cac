#pragma once

#include "app/io/byte_channel.hpp"

#include <cstdint>
#include <memory>
#include <string_view>

namespace echotrail {

/// Sends reports, a line each, to a motion controller: as UDP datagrams, or over TCP as client. A late report is worth
/// nothing, so that one that cannot go soon is dropped whole and counted; nothing is sent twice or kept for later.
/// Threads: as ByteChannel.
class ReportSender {
public:
    struct Counts {
        std::uint64_t sent = 0;     ///< handed to the network; with UDP nobody says whether they arrived
        std::uint64_t dropped = 0;  ///< there was no connection, or the peer was too slow
    };

    /// `address` is tcp or udp with a port; the error, a matter of usage, names what was given.
    static Result<std::unique_ptr<ReportSender>> open(const LinkAddress& address);

    /// `line` is given without its end; a line feed is added.
    void send(std::string_view line);
    const Counts& counts() const { return counts_; }
    /// For its signals and its state.
    const ByteChannel& channel() const { return *channel_; }

private:
    explicit ReportSender(std::unique_ptr<ByteChannel> channel) : channel_(std::move(channel)) {}

    std::unique_ptr<ByteChannel> channel_;
    Counts counts_;
};

}  // namespace echotrail
