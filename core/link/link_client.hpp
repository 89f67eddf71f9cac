#pragma once

#include "core/link/framing.hpp"
#include "core/link/link_limits.hpp"
#include "core/link/link_values.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>

namespace echotrail::wire {
class ToConsole;
class ToTracker;
}  // namespace echotrail::wire

namespace echotrail {

/// How the link is, seen from the console. Counts are since the client was made.
struct LinkClientStatus {
    enum class State { Down, Greeting, Joined };
    State state = State::Down;
    std::string refusal;  ///< the tracker's last word, where it closed the connection
    LinkWelcome welcome;
    LinkControl control;
    LinkParameters parameters;
    std::optional<Microseconds> last_heard;  ///< own monotonic time of the last whole message
    std::optional<Microseconds> round_trip;  ///< of the last probe
    std::optional<Microseconds> latency;     ///< of the last beam or tracks, from the tracker's receiving it to here
    std::uint64_t messages = 0, bytes = 0;
    std::uint64_t gaps = 0;       ///< stream messages that did not come
    std::uint64_t late = 0;       ///< that came after newer ones, and were passed over
    std::uint64_t datagrams = 0;  ///< that came since the last welcome
    std::uint64_t malformed = 0;  ///< messages that cannot be; a broken stream counts once
    std::uint64_t snapshots = 0;
    std::uint64_t joins = 0;

    /// The tracker lets its recordings be read.
    bool mayReadRecordings() const {
        const auto& able = welcome.capabilities;
        return state == State::Joined && std::find(able.begin(), able.end(), link_recordings) != able.end();
    }
    bool holdsControl() const { return state == State::Joined && control.holder == welcome.console; }
};

/// The console's end of the link: bytes and times in, bytes and events out. What the tracker sends is not trusted
/// either.
/// Order: linkUp(), then received() and tick() at least twice a second; after each take the output and the events.
///        Where wantsToClose() the connection is to be closed and made again. `now` is monotonic.
class LinkClient {
public:
    struct Options {
        LinkIdentity identity;
        bool wants_control = true;
        std::uint64_t bytes_per_second = 0;  ///< 0: as fast as the way goes
        bool datagrams = false;              ///< streams may come by them
    };
    explicit LinkClient(Options options) : options_(std::move(options)) {}

    void linkUp(Microseconds now);
    void linkDown();
    void received(Microseconds now, std::span<const std::uint8_t> bytes);
    /// The text of a datagram that is known to be the tracker's, and its number.
    void receivedDatagram(Microseconds now, std::uint64_t number, std::span<const std::uint8_t> text);
    /// The text of a datagram that is to be sent now, if one is; asked for as often as tick().
    std::optional<std::string> datagramToSend(Microseconds now);
    void tick(Microseconds now);
    std::string takeOutput() { return std::exchange(output_, {}); }
    std::optional<LinkEvent> next();
    /// The stream is broken, the tracker has refused, or says nothing any more.
    bool wantsToClose() const { return wants_to_close_; }

    // Requests; each gives the number that its reply will name, or 0 where there is no link.
    std::uint32_t setParameters(const std::vector<NamedValue>& values);
    std::uint32_t designate(double range_m, Bearing from_bow);
    std::uint32_t clearDesignation();
    std::uint32_t drop(int track, double range_m, Bearing from_bow);
    std::uint32_t restore(int track);
    std::uint32_t annotate(const std::string& text);
    std::uint32_t control(ControlAction action);
    // Of recordings; the answer is a LinkRecordings, LinkRecording or LinkRows, or a LinkReply that says why not.
    std::uint32_t listRecordings();
    std::uint32_t describeRecording(const std::string& name);
    std::uint32_t readRows(const LinkReadRows& wanted);

    const LinkClientStatus& status() const { return status_; }
    std::optional<double> linkAge(Microseconds now) const;
    /// The tracker's own time now; none before the first probe came back.
    std::optional<Timestamp> trackerTime(Microseconds now) const;
    /// The quickest of the last probes: what the way itself takes.
    std::optional<Microseconds> quickestRoundTrip() const;
    /// Requests that have no reply yet.
    std::size_t unanswered() const { return unanswered_.size(); }

private:
    struct Probed {
        Microseconds round_trip{0};
        Microseconds offset{0};  ///< of the tracker's clock from ours
    };
    std::optional<Probed> quickest() const;
    bool take(const wire::ToConsole& message, Microseconds now);
    bool takeSnapshot(const wire::ToConsole& message);
    bool takeStream(const wire::ToConsole& message, Microseconds now);
    void takeProbe(const wire::ToConsole& message, Microseconds now);
    void takeReply(const wire::ToConsole& message);
    template <class Answer>
    bool takeAnswer(std::uint32_t request, std::optional<Answer> answer);
    bool isNext(const wire::ToConsole& message);
    void noteLatency(Timestamp happened, Microseconds now);
    void add(LinkEvent event);
    std::uint32_t ask(wire::ToTracker& message);
    void send(const wire::ToTracker& message);
    void probe(Microseconds now);

    Options options_;
    LinkClientStatus status_;
    FrameReader reader_{link_limits::longest_message};
    std::string output_;
    std::deque<LinkEvent> events_;
    std::map<int, std::uint64_t> last_sequence_;  ///< by kind of content
    std::set<std::uint32_t> unanswered_;
    std::deque<Probed> probes_;
    std::uint32_t next_request_ = 1;
    Microseconds up_since_{0};
    std::optional<Microseconds> probed_, reported_;
    std::uint64_t newest_datagram_ = 0;
    bool wants_to_close_ = false;
};

}  // namespace echotrail
