#pragma once

#include "core/link/link_control.hpp"
#include "core/link/link_session.hpp"
#include "core/link/moment_encoder.hpp"

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>

namespace echotrail::wire {
class Hello;
class SetParameters;
class Snapshot;
class ToConsole;
class ToTracker;
}  // namespace echotrail::wire

namespace echotrail {

/// The tracker's end of the link, for all consoles: bytes and times in, bytes and requests out. What a console sends
/// is never trusted; what one does not read never delays another.
/// Order:   times, by the run's clock, never go back; tick() every so often, at least twice a second.
/// Threads: none; one owner calls it.
class LinkServer {
public:
    struct Counts {
        std::uint64_t connections = 0;                 ///< that were taken
        std::uint64_t turned_away = 0;                 ///< there were too many already
        std::uint64_t malformed = 0;                   ///< messages that are none
        std::map<std::string, std::uint64_t> refused;  ///< cause → requests
        std::map<std::string, std::uint64_t> dropped;  ///< cause → consoles
        std::uint64_t resynchronised = 0;              ///< what waited was thrown away, and all told afresh
        std::uint64_t datagrams = 0;                   ///< that were sent
        std::uint64_t record_bytes = 0;                ///< of recordings, that were given
    };

    /// `run`: another number for every run of the tracker. The parameters in force have revision 1.
    LinkServer(const LinkIdentity& identity, std::uint64_t run, std::vector<NamedValue> parameters);
    ~LinkServer();

    /// A console's number; none where there are too many. `datagrams`: where it can have them, and under which key.
    std::optional<std::uint32_t> connected(Timestamp now, std::optional<LinkDatagrams> datagrams = {});
    /// The text of a datagram that is known to be this console's.
    void receivedDatagram(std::uint32_t console, Timestamp now, std::span<const std::uint8_t> text);
    /// What goes to it by datagrams now: the text of each.
    std::vector<std::string> takeDatagrams(std::uint32_t console);
    void received(std::uint32_t console, Timestamp now, std::span<const std::uint8_t> bytes);
    void disconnected(std::uint32_t console, Timestamp now);
    /// What may go to this console now, appended; about `room` bytes at most.
    void takeOutput(std::uint32_t console, Timestamp now, std::string& out, std::size_t room);
    /// The connection is to be closed, once its output has been taken.
    bool isClosing(std::uint32_t console) const;
    void tick(Timestamp now);

    // What happens aboard
    void publish(LinkMoment moment, Timestamp now);
    void publish(const LinkHealth& health, Timestamp now);
    void publish(const LinkLog& line, Timestamp now);
    /// The parameters now in force, with the next revision.
    void publishParameters(std::vector<NamedValue> parameters, Timestamp now);

    /// What a console asks for, allowed and sound in form; it is answered before the next is taken.
    std::optional<LinkRequest> nextRequest(Timestamp now);
    void answer(const LinkRequest& request, const Result<void>& result, Timestamp now);
    /// The same of recordings, where consoles may read them: one whose answer can go soon. Bytes that are asked for are
    /// limited, for all consoles together and where a console's way is slow.
    std::optional<LinkRecordRequest> nextRecordRequest(Timestamp now);
    void answer(const LinkRecordRequest& request, const Result<LinkRecordAnswer>& result, Timestamp now);
    /// From here on consoles may ask for recordings; before they join.
    void serveRecordings() { recordings_ = true; }
    /// What there is to say about the link itself: a line for the tracker's own log.
    std::optional<std::string> nextNote();

    const Counts& counts() const { return counts_; }
    std::size_t consoles() const { return sessions_.size(); }
    const LinkControl& control() const { return control_.state(); }
    std::uint64_t revision() const { return parameters_.revision; }
    /// How much of the streams is left out for this console.
    SendQueue::Level levelOf(std::uint32_t console, Timestamp now) const;
    std::size_t waitingBytes(std::uint32_t console) const;

private:
    struct Pending {
        LinkRequest request;
        std::uint64_t base_revision = 0;  ///< of parameters
    };
    LinkSession* find(std::uint32_t console) const;
    void take(LinkSession& session, const wire::ToTracker& message, Timestamp now);
    void welcome(LinkSession& session, const wire::Hello& hello, Timestamp now);
    void takeRequest(LinkSession& session, const wire::ToTracker& message, Timestamp now);
    void takeRecordRequest(LinkSession& session, const wire::ToTracker& message, Timestamp now);
    bool mayGo(LinkRecordRequest& request, Timestamp now) const;
    void takeControl(LinkSession& session, const wire::ToTracker& message, Timestamp now);
    void queue(LinkSession& session, const wire::ToTracker& message, LinkRequest request, bool needs_control,
               Timestamp now);
    void refuse(LinkSession& session, std::uint32_t request, const std::string& cause, const std::string& reason,
                Timestamp now);
    void reply(LinkSession& session, std::uint32_t request, const Result<void>& result, Timestamp now);
    void drop(LinkSession& session, const std::string& cause, Timestamp now);
    void send(LinkSession& session, SendQueue::Lane lane, SendQueue::Frame frame, Timestamp now);
    void send(LinkSession& session, const wire::ToConsole& message, Timestamp now);
    void stream(LinkSession& session, SendQueue::Lane lane, const SendQueue::Frame& frame, Timestamp now);
    void sendToAll(const wire::ToConsole& message, Timestamp now);
    void sendSnapshot(LinkSession& session, Timestamp now);
    void write(wire::Snapshot& snapshot) const;
    void tellControl(const LinkControl& before, Timestamp now);

    LinkIdentity identity_;
    std::uint64_t run_;
    LinkParameters parameters_;
    LinkHealth health_;
    std::deque<LinkLog> log_;
    ControlDesk control_;
    MomentEncoder encoder_;
    std::map<std::uint32_t, std::unique_ptr<LinkSession>> sessions_;
    std::deque<Pending> pending_;
    bool recordings_ = false;
    std::deque<LinkRecordRequest> record_pending_;
    double rows_budget_ = 0.0;  ///< bytes that may be read now
    Timestamp rows_budget_filled_{};
    std::deque<std::string> notes_;
    std::uint32_t next_console_ = 1;
    std::uint64_t health_sent_ = 0, log_sent_ = 0;
    Counts counts_;
};

}  // namespace echotrail
