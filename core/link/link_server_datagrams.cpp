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
    session->datagrams.report(message.datagrams().newest(), message.datagrams().received(), now);
    wire::ToConsole out;
    out.mutable_datagram_echo();
    session->datagrams.addEcho(out.SerializeAsString());
}

/// By a datagram where that arrives and it fits; else by TCP.
void LinkServer::stream(LinkSession& session, SendQueue::Lane lane, const SendQueue::Frame& frame, Timestamp now) {
    if (!frame || session.closing || !session.welcomed || session.needs_snapshot) return;
    if (!session.usesDatagrams(now) || !DatagramWay::fits(frame)) return send(session, lane, frame, now);
    if (!SendQueue::allows(lane, session.datagrams.level())) return session.queue.leaveOut();
    if (session.queue.spend(frame->size(), now))
        session.datagrams.add(frame);
    else
        session.datagrams.tellCrowded(now);
}

std::vector<std::string> LinkServer::takeDatagrams(std::uint32_t console) {
    LinkSession* session = find(console);
    if (!session) return {};
    auto texts = session->datagrams.take();
    counts_.datagrams += texts.size();
    return texts;
}

}  // namespace echotrail
