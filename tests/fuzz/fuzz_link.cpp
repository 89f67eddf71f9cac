#include "core/link/framing.hpp"
#include "core/link/link_client.hpp"
#include "core/link/link_server.hpp"
#include "core/link/pairing_message.hpp"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

// Any bytes at either end of the link, with and without a greeting: nothing outside is read, what is held and what
// waits stays within its limits, and who talks nonsense is told to go.
namespace echotrail {
namespace {

void require(bool law, const char* what) {
    if (law) return;
    std::fprintf(stderr, "broken law: %s\n", what);
    std::abort();
}

constexpr Timestamp start{Microseconds{1'700'000'000'000'000}};
using Bytes = std::span<const std::uint8_t>;

Bytes bytesOf(const std::string& text) { return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}; }

LinkClient makeClient() { return LinkClient(LinkClient::Options{.identity = {"shore", "fuzz"}, .datagrams = true}); }

/// Gives how many there were.
std::size_t answerRecordRequests(LinkServer& server) {
    std::size_t asked = 0;
    for (; const auto request = server.nextRecordRequest(start); ++asked) {
        require(asked < link_limits::most_record_requests, "few requests for recordings wait");
        Result<LinkRecordAnswer> answer = LinkRecordAnswer(LinkRecordings{});
        if (const auto* described = std::get_if<LinkDescribeRecording>(&request->content)) {
            require(described->recording.size() <= link_limits::longest_word, "names are short");
            answer = LinkRecordAnswer(LinkRecording{0, "a", {{}, {{1, 1}}}});
        }
        if (const auto* wanted = std::get_if<LinkReadRows>(&request->content)) {
            require(wanted->rows.most_bytes <= link_limits::longest_rows, "an answer is no longer than allowed");
            require(wanted->rows.first >= 0 && wanted->rows.last >= 0 && wanted->rows.part >= 0, "rows are numbers");
            answer = Error{"no such recording"};
        }
        server.answer(*request, answer, start);
    }
    return asked;
}

/// What a console says, to a tracker that answers all it is asked.
void toTracker(Bytes bytes, bool greeted) {
    LinkServer server({"vehicle", "fuzz"}, 1, {{"range_m", 50.0}, {"particles", 2000}});
    server.serveRecordings();
    const LinkDatagrams datagrams{1, 2, std::string(link_limits::datagram_key_bytes, 'k')};
    const std::uint32_t console = server.connected(start, datagrams).value();
    LinkClient client = makeClient();
    client.linkUp(Microseconds{0});
    if (greeted) server.received(console, start, bytesOf(client.takeOutput()));
    server.received(console, start, bytes);
    server.receivedDatagram(console, start, bytes);
    require(server.takeDatagrams(console).size() <= 1, "a datagram is answered by one at most");
    for (int asked = 0; const auto request = server.nextRequest(start); ++asked) {
        require(asked < static_cast<int>(link_limits::most_waiting_requests), "few requests wait");
        require(request->name.size() <= link_limits::longest_name, "names are short");
        server.answer(*request, {}, start);
    }
    const std::size_t answers = answerRecordRequests(server);
    require(server.waitingBytes(console) <= link_limits::urgent_bytes, "what waits is bounded");
    std::string out;
    server.takeOutput(console, start, out, 1 << 20);
    client.received(Microseconds{1}, bytesOf(out));
    // Answers to what this console did not ask are not for it.
    require(client.status().malformed <= answers, "a tracker says nothing that a console cannot read");
    server.tick(start + Microseconds{60'000'000});
    require(server.isClosing(console), "who falls silent goes");
}

/// What a tracker says, to a console.
void toConsole(Bytes bytes) {
    LinkClient client = makeClient();
    client.linkUp(Microseconds{0});
    client.received(Microseconds{1}, bytes);
    client.receivedDatagram(Microseconds{2}, 1, bytes);
    std::size_t events = 0;
    while (client.next()) ++events;
    require(events <= link_limits::most_events, "events are bounded");
    require(client.status().malformed <= 2 + bytes.size() / link_frame_head, "what cannot be is counted once");
}

void pairing(std::string_view message) {
    if (const auto request = readPairRequest(message)) {
        require(request->proof.size() == pairing_proof_bytes, "a proof has its length");
        require(request->name.size() <= link_limits::longest_name, "names are short");
    }
    if (const auto reply = readPairReply(message))
        require(!reply->done || reply->proof.size() == pairing_proof_bytes, "yes comes with a proof");
}

}  // namespace
}  // namespace echotrail

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace echotrail;
    if (size == 0) return 0;
    const Bytes bytes{data + 1, size - 1};
    const std::string_view message{reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    switch (data[0] % 5) {
        case 0:
            toTracker(bytesOf(linkFrame(message)), true);
            break;
        case 1:
            toTracker(bytes, false);
            break;
        case 2:
            toConsole(bytesOf(linkFrame(message)));
            break;
        case 3:
            toConsole(bytes);
            break;
        default:
            pairing(message);
    }
    return 0;
}
