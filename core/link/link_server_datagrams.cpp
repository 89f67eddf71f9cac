#include "core/link/link_server.hpp"
#include "core/link/wire_values.hpp"

// The part of a LinkServer that sends by datagrams what matters only while it is new.
namespace echotrail {

void LinkServer::receivedDatagram(std::uint32_t console, Timestamp now, std::span<const std::uint8_t> text) {
    LinkSession* session = find(console);
    if (!session || session->closing || !session->welcomed || !session->datagram_offer) return;
    wire::ToTracker message;
    if (!parse({reinterpret_cast<const char*>(text.data()), text.size()}, message) || !message.has_datagrams()) {
        ++counts_.malformed;
        return;
    }
    const auto lost = session->datagrams.report(message.datagrams().newest(), message.datagrams().received(), now);
    if (lost) session->queue.tellLoss(*lost, now);
    wire::ToConsole out;
    out.mutable_datagram_echo();
    session->datagrams.addEcho(out.SerializeAsString());
}

/// By a datagram where that arrives and it fits; else by TCP.
void LinkServer::stream(LinkSession& session, SendQueue::Lane lane, const SendQueue::Frame& frame, Timestamp now) {
    if (!frame || session.closing || !session.welcomed || session.needs_snapshot) return;
    const bool by_datagram = session.datagram_offer && session.datagrams.works(now);
    if (by_datagram && session.queue.allows(lane) && session.datagrams.add(frame)) return;
    send(session, lane, frame, now);
}

std::vector<std::string> LinkServer::takeDatagrams(std::uint32_t console) {
    LinkSession* session = find(console);
    if (!session) return {};
    auto texts = session->datagrams.take();
    counts_.datagrams += texts.size();
    return texts;
}

}  // namespace echotrail
