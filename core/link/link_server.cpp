#include "core/link/link_server.hpp"

#include "core/link/wire_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace echotrail {
namespace {

constexpr std::size_t most_notes = 100;
constexpr double picture_share = 0.5;  // of a limited rate's second, for the picture of who comes late

SendQueue::Frame frameOf(const wire::ToConsole& message) {
    return std::make_shared<const std::string>(linkFrame(message.SerializeAsString()));
}

bool isPlace(const auto& message) {
    return message.range_m() >= 0.0 && message.range_m() <= link_limits::farthest_pick_m &&
           isSane(message.bearing_rad());
}

bool isTrack(const auto& message) {
    return message.track() > 0 && message.track() <= static_cast<std::uint32_t>(std::numeric_limits<int>::max());
}

}  // namespace

LinkServer::LinkServer(const LinkIdentity& identity, std::uint64_t run, std::vector<NamedValue> parameters)
    : identity_{cleanText(identity.name, link_limits::longest_name),
                cleanText(identity.program, link_limits::longest_name)},
      run_(run),
      parameters_{1, std::move(parameters)} {}

LinkServer::~LinkServer() = default;

LinkSession* LinkServer::find(std::uint32_t console) const {
    const auto found = sessions_.find(console);
    return found == sessions_.end() ? nullptr : found->second.get();
}

std::optional<std::uint32_t> LinkServer::connected(Timestamp now, std::optional<LinkDatagrams> datagrams) {
    if (sessions_.size() >= link_limits::most_consoles) {
        ++counts_.turned_away;
        return std::nullopt;
    }
    ++counts_.connections;
    const std::uint32_t console = next_console_++;
    sessions_.emplace(console, std::make_unique<LinkSession>(console, now));
    sessions_.at(console)->datagram_offer = std::move(datagrams);
    return console;
}

void LinkServer::disconnected(std::uint32_t console, Timestamp now) {
    const LinkSession* session = find(console);
    if (!session) return;
    if (session->welcomed && notes_.size() < most_notes) notes_.push_back("console '" + session->name + "' has left");
    sessions_.erase(console);
    std::erase_if(record_pending_, [&](const LinkRecordRequest& request) { return request.console == console; });
    const LinkControl before = control_.state();
    control_.left(console);
    tellControl(before, now);
}

void LinkServer::received(std::uint32_t console, Timestamp now, std::span<const std::uint8_t> bytes) {
    LinkSession* session = find(console);
    if (!session || session->closing) return;
    session->reader.take(bytes);
    while (!session->closing) {
        const auto text = session->reader.next();
        if (!text) break;
        wire::ToTracker message;
        if (!parse(*text, message)) {
            ++counts_.malformed;
            return drop(*session, "sent what is no message", now);
        }
        session->last_heard = now;
        take(*session, message, now);
    }
    if (session->reader.broken()) {
        ++counts_.malformed;
        drop(*session, "sent a message of impossible length", now);
    }
}

void LinkServer::take(LinkSession& session, const wire::ToTracker& message, Timestamp now) {
    using wire::ToTracker;
    if (message.content_case() == ToTracker::kHello) return welcome(session, message.hello(), now);
    if (!session.welcomed) {
        ++counts_.malformed;
        return drop(session, "did not say hello first", now);
    }
    const auto content = message.content_case();
    if (content == ToTracker::kListRecordings || content == ToTracker::kDescribeRecording ||
        content == ToTracker::kReadRows)
        return takeRecordRequest(session, message, now);
    if (!session.mayAsk(now)) return refuse(session, message.request(), "too_many", "too many requests at once", now);
    wire::ToConsole out;
    switch (message.content_case()) {
        case ToTracker::kProbe:
            out.mutable_probe()->set_console_us(message.probe().console_us());
            out.mutable_probe()->set_tracker_us(microsecondsOf(now));
            return send(session, out, now);
        case ToTracker::kControl:
            return takeControl(session, message, now);
        case ToTracker::kSnapshot:
            session.needs_snapshot = true;
            return reply(session, message.request(), {}, now);
        default:
            return takeRequest(session, message, now);
    }
}

void LinkServer::welcome(LinkSession& session, const wire::Hello& hello, Timestamp now) {
    if (session.welcomed) return refuse(session, 0, "second_hello", "hello was said before", now);
    const std::uint32_t version = std::min(hello.newest_version(), link_limits::newest_version);
    if (version < std::max(hello.oldest_version(), link_limits::oldest_version))
        return drop(session,
                    "speaks no version of the link that this tracker does (" +
                        std::to_string(link_limits::oldest_version) + " to " +
                        std::to_string(link_limits::newest_version) + ")",
                    now);
    session.welcomed = true;
    session.name = cleanText(hello.name(), link_limits::longest_name);
    if (session.name.empty()) session.name = "console " + std::to_string(session.console);
    session.program = cleanText(hello.program(), link_limits::longest_name);
    session.queue.setRate(static_cast<double>(hello.bytes_per_second()), now);
    if (notes_.size() < most_notes)
        notes_.push_back("console '" + session.name + "' has come (" + session.program + ")");

    wire::ToConsole out;
    wire::Welcome& welcome = *out.mutable_welcome();
    welcome.set_version(version);
    welcome.set_program(identity_.program);
    welcome.set_name(identity_.name);
    for (const char* capability : {"parameters", "designate", "annotate", "control", "beams", "drop"})
        welcome.add_capabilities(capability);
    if (recordings_) welcome.add_capabilities(link_recordings);
    welcome.set_console(session.console);
    welcome.set_run(run_);
    if (!hello.datagrams()) session.datagram_offer.reset();
    if (session.datagram_offer) {
        welcome.mutable_datagrams()->set_port(session.datagram_offer->port);
        welcome.mutable_datagrams()->set_session(session.datagram_offer->session);
        welcome.mutable_datagrams()->set_key(session.datagram_offer->key);
    }
    send(session, out, now);
    const LinkControl before = control_.state();
    if (hello.wants_control() && before.holder == 0)
        static_cast<void>(control_.act(ControlAction::Ask, session.console, session.name, now));
    tellControl(before, now);
    sendSnapshot(session, now);
}

void LinkServer::takeRequest(LinkSession& session, const wire::ToTracker& message, Timestamp now) {
    using wire::ToTracker;
    const auto unsound = [&](const std::string& reason) { refuse(session, message.request(), "unsound", reason, now); };
    LinkRequest request{session.console, message.request(), session.name, LinkClearDesignation{}};
    switch (message.content_case()) {
        case ToTracker::kSetParameters: {
            auto values = read(message.set_parameters().parameters());
            if (!values) return unsound("a parameter that cannot be, or too many of them");
            request.content = LinkSetParameters{*std::move(values)};
            return queue(session, message, std::move(request), true, now);
        }
        case ToTracker::kDesignate: {
            const wire::Designate& pick = message.designate();
            if (!isPlace(pick)) return unsound("a place that cannot be");
            request.content = LinkDesignate{pick.range_m(), Bearing::radians(pick.bearing_rad())};
            return queue(session, message, std::move(request), true, now);
        }
        case ToTracker::kClearDesignation:
            return queue(session, message, std::move(request), true, now);
        case ToTracker::kDropTrack: {
            const wire::DropTrack& drop = message.drop_track();
            if (!isPlace(drop) || !isTrack(drop)) return unsound("a track or a place that cannot be");
            request.content =
                LinkDrop{static_cast<int>(drop.track()), drop.range_m(), Bearing::radians(drop.bearing_rad())};
            return queue(session, message, std::move(request), true, now);
        }
        case ToTracker::kRestoreTrack:
            if (!isTrack(message.restore_track())) return unsound("a track that cannot be");
            request.content = LinkRestore{static_cast<int>(message.restore_track().track())};
            return queue(session, message, std::move(request), true, now);
        case ToTracker::kAnnotate: {
            const std::string& text = message.annotate().text();
            if (text.empty() || text.size() > link_limits::longest_remark)
                return unsound("a remark has 1 to " + std::to_string(link_limits::longest_remark) + " bytes");
            request.content = LinkAnnotate{cleanText(text, link_limits::longest_remark)};
            return queue(session, message, std::move(request), false, now);
        }
        default:
            return refuse(session, message.request(), "unknown", "this tracker does not know such a request", now);
    }
}

void LinkServer::queue(LinkSession& session, const wire::ToTracker& message, LinkRequest request, bool needs_control,
                       Timestamp now) {
    if (needs_control && !control_.holds(session.console)) {
        const std::string& holder = control_.state().holder_name;
        return refuse(session, message.request(), "no_control",
                      holder.empty() ? "this console does not hold control; ask for it" : holder + " holds control",
                      now);
    }
    if (pending_.size() >= link_limits::most_waiting_requests)
        return refuse(session, message.request(), "too_many", "too many requests wait", now);
    pending_.push_back({std::move(request), message.set_parameters().base_revision()});
}

std::optional<LinkRequest> LinkServer::nextRequest(Timestamp now) {
    while (!pending_.empty()) {
        const Pending next = std::move(pending_.front());
        pending_.pop_front();
        const bool outdated = std::holds_alternative<LinkSetParameters>(next.request.content) &&
                              next.base_revision != parameters_.revision;
        if (!outdated) return next.request;
        if (LinkSession* session = find(next.request.console))
            refuse(*session, next.request.request, "outdated", "the parameters have been changed meanwhile", now);
    }
    return std::nullopt;
}

void LinkServer::answer(const LinkRequest& request, const Result<void>& result, Timestamp now) {
    LinkSession* session = find(request.console);
    if (!session) return;
    if (result) return reply(*session, request.request, result, now);
    refuse(*session, request.request, "not_done", result.error(), now);
}

void LinkServer::takeControl(LinkSession& session, const wire::ToTracker& message, Timestamp now) {
    const auto action = message.control().action();
    if (action < wire::ControlRequest::ASK || action > wire::ControlRequest::TAKE)
        return refuse(session, message.request(), "unknown", "this tracker does not know such a request", now);
    const LinkControl before = control_.state();
    const auto acted = control_.act(static_cast<ControlAction>(action), session.console, session.name, now);
    tellControl(before, now);
    if (acted) return reply(session, message.request(), {}, now);
    refuse(session, message.request(), "control", acted.error(), now);
}

void LinkServer::tellControl(const LinkControl& before, Timestamp now) {
    const LinkControl& state = control_.state();
    if (state == before) return;
    if (state.holder != before.holder && notes_.size() < most_notes)
        notes_.push_back(state.holder == 0 ? "nobody holds control"
                                           : "console '" + state.holder_name + "' holds control");
    wire::ToConsole out;
    echotrail::write(state, *out.mutable_control());
    sendToAll(out, now);
}

void LinkServer::refuse(LinkSession& session, std::uint32_t request, const std::string& cause,
                        const std::string& reason, Timestamp now) {
    ++counts_.refused[cause];
    reply(session, request, Error{reason}, now);
    // A person is told no now and then; a program that does not listen is not to go on.
    const bool a_matter_of_course =
        cause == "no_control" || cause == "control" || cause == "outdated" || cause == "not_done";
    if (!a_matter_of_course && ++session.refusals > link_limits::most_refusals)
        drop(session, "asked too often for what cannot be", now);
}

void LinkServer::reply(LinkSession& session, std::uint32_t request, const Result<void>& result, Timestamp now) {
    if (request == 0) return;
    wire::ToConsole out;
    out.mutable_reply()->set_request(request);
    out.mutable_reply()->set_done(result.has_value());
    if (!result) out.mutable_reply()->set_reason(cleanText(result.error(), link_limits::longest_text));
    send(session, out, now);
}

void LinkServer::drop(LinkSession& session, const std::string& cause, Timestamp now) {
    if (session.closing) return;
    ++counts_.dropped[cause];
    if (notes_.size() < most_notes)
        notes_.push_back("console " + (session.name.empty() ? "without a name" : "'" + session.name + "'") +
                         " dropped: it " + cause);
    session.queue.clear();
    wire::ToConsole out;
    out.mutable_refusal()->set_reason(cause);
    send(session, out, now);
    session.closing = true;
}

void LinkServer::send(LinkSession& session, SendQueue::Lane lane, SendQueue::Frame frame, Timestamp now) {
    if (!frame || session.closing || !session.welcomed || session.needs_snapshot) return;
    if (session.queue.add(lane, std::move(frame), now)) return;
    if (!std::exchange(session.needs_snapshot, true)) ++counts_.resynchronised;
}

void LinkServer::send(LinkSession& session, const wire::ToConsole& message, Timestamp now) {
    if (session.closing) return;
    if (!session.queue.add(SendQueue::Lane::Urgent, frameOf(message), now) &&
        !std::exchange(session.needs_snapshot, true))
        ++counts_.resynchronised;
}

void LinkServer::sendToAll(const wire::ToConsole& message, Timestamp now) {
    const SendQueue::Frame frame = frameOf(message);
    for (const auto& [console, session] : sessions_) send(*session, SendQueue::Lane::Urgent, frame, now);
}

void LinkServer::sendSnapshot(LinkSession& session, Timestamp now) {
    session.needs_snapshot = false;
    session.snapshot_sent = now;
    wire::ToConsole out;
    write(*out.mutable_snapshot());
    send(session, out, now);
    for (const SendQueue::Frame& frame : encoder_.recentRegions()) send(session, SendQueue::Lane::Regions, frame, now);
    const double rate = session.queue.rate();
    const std::size_t picture =
        rate > 0.0 ? static_cast<std::size_t>(picture_share * rate) : link_limits::picture_bytes;
    for (const SendQueue::Frame& frame : encoder_.recentBeams(picture))
        send(session, SendQueue::Lane::Picture, frame, now);
}

void LinkServer::takeOutput(std::uint32_t console, Timestamp now, std::string& out, std::size_t room) {
    LinkSession* session = find(console);
    if (!session) return;
    session->queue.take(out, room, now);
    const bool may_have_one = session->welcomed && !session->closing && session->queue.empty() &&
                              now - session->snapshot_sent >= link_limits::between_snapshots;
    if (session->needs_snapshot && may_have_one) sendSnapshot(*session, now);
}

bool LinkServer::isClosing(std::uint32_t console) const {
    const LinkSession* session = find(console);
    return !session || session->closing;
}

void LinkServer::tick(Timestamp now) {
    for (const auto& [console, session] : sessions_) {
        session->queue.judge(now);
        if (!session->welcomed && now - session->connected > link_limits::hello_within)
            drop(*session, "did not say hello in time", now);
        else if (now - session->last_heard > link_limits::silence)
            drop(*session, "was silent for too long", now);
        else if (session->queue.stuckFor(now) > link_limits::reads_nothing)
            drop(*session, "reads nothing", now);
    }
}

std::optional<std::string> LinkServer::nextNote() {
    if (notes_.empty()) return std::nullopt;
    std::string note = std::move(notes_.front());
    notes_.pop_front();
    return note;
}

SendQueue::Level LinkServer::levelOf(std::uint32_t console, Timestamp now) const {
    const LinkSession* session = find(console);
    return session ? session->level(now) : SendQueue::NoPicture;
}

std::size_t LinkServer::waitingBytes(std::uint32_t console) const {
    const LinkSession* session = find(console);
    return session ? session->queue.waitingBytes() : 0;
}

}  // namespace echotrail
