#include "core/link/link_client.hpp"

#include "core/link/wire_values.hpp"

#include <algorithm>

namespace echotrail {
namespace {

using State = LinkClientStatus::State;

constexpr Microseconds between_probes{1'000'000};
constexpr Microseconds patience{10'000'000};  // a tracker answers every probe
constexpr std::size_t probes_kept = 16;       // the quickest of them tells the clocks' difference best
constexpr std::size_t most_unanswered = 1'000;

std::optional<LinkDatagrams> datagramsOf(const wire::Welcome& welcome) {
    const wire::Datagrams& in = welcome.datagrams();
    if (!welcome.has_datagrams() || in.port() == 0 || in.port() > 65'535 ||
        in.key().size() != link_limits::datagram_key_bytes)
        return std::nullopt;
    return LinkDatagrams{static_cast<std::uint16_t>(in.port()), in.session(), in.key()};
}

}  // namespace

void LinkClient::linkUp(Microseconds now) {
    linkDown();
    status_.state = State::Greeting;
    status_.refusal.clear();
    up_since_ = now;
    wire::ToTracker message;
    wire::Hello& hello = *message.mutable_hello();
    hello.set_oldest_version(link_limits::oldest_version);
    hello.set_newest_version(link_limits::newest_version);
    hello.set_name(cleanText(options_.identity.name, link_limits::longest_name));
    hello.set_program(cleanText(options_.identity.program, link_limits::longest_name));
    hello.set_wants_control(options_.wants_control);
    hello.set_bytes_per_second(options_.bytes_per_second);
    hello.set_datagrams(options_.datagrams);
    send(message);
    probe(now);
}

void LinkClient::receivedDatagram(Microseconds now, std::uint64_t number, std::span<const std::uint8_t> text) {
    if (status_.state != State::Joined) return;
    ++status_.datagrams;
    newest_datagram_ = std::max(newest_datagram_, number);
    status_.bytes += text.size();
    wire::ToConsole message;
    const bool whole = parse({reinterpret_cast<const char*>(text.data()), text.size()}, message);
    const auto content = message.content_case();
    if (whole && content == wire::ToConsole::kDatagramEcho) return;
    const bool fits = content == wire::ToConsole::kBeam || content == wire::ToConsole::kRegions ||
                      content == wire::ToConsole::kParticles;
    if (!whole || !fits || !takeStream(message, now)) ++status_.malformed;
}

std::optional<std::string> LinkClient::datagramToSend(Microseconds now) {
    if (status_.state != State::Joined || !status_.welcome.datagrams) return std::nullopt;
    if (reported_ && now - *reported_ < link_limits::between_reports) return std::nullopt;
    reported_ = now;
    wire::ToTracker message;
    message.mutable_datagrams()->set_newest(newest_datagram_);
    message.mutable_datagrams()->set_received(status_.datagrams);
    return message.SerializeAsString();
}

/// What was known of the far side stays, for the eye; its age tells that it is old.
void LinkClient::linkDown() {
    status_.state = State::Down;
    wants_to_close_ = false;
    reader_ = FrameReader(link_limits::longest_message);
    output_.clear();
    last_sequence_.clear();
    for (const std::uint32_t request : unanswered_)
        add(LinkReply{request, false, "the link was lost before the answer came; see what is in force"});
    unanswered_.clear();
    probed_.reset();  // what the old probes say of the clocks still holds
    status_.round_trip.reset();
}

void LinkClient::received(Microseconds now, std::span<const std::uint8_t> bytes) {
    if (status_.state == State::Down || wants_to_close_) return;
    status_.bytes += bytes.size();
    reader_.take(bytes);
    while (!wants_to_close_) {
        const auto text = reader_.next();
        if (!text) break;
        wire::ToConsole message;
        if (!parse(*text, message)) {
            ++status_.malformed;
            wants_to_close_ = true;
            return;
        }
        ++status_.messages;
        status_.last_heard = now;
        if (!take(message, now)) ++status_.malformed;
    }
    if (reader_.broken()) {
        ++status_.malformed;
        wants_to_close_ = true;
    }
}

void LinkClient::tick(Microseconds now) {
    if (status_.state == State::Down) return;
    if (!probed_ || now - *probed_ >= between_probes) probe(now);
    const Microseconds heard = std::max(up_since_, status_.last_heard.value_or(up_since_));
    if (now - heard > patience) wants_to_close_ = true;
}

bool LinkClient::take(const wire::ToConsole& message, Microseconds now) {
    using wire::ToConsole;
    if (message.content_case() == ToConsole::kRefusal) {
        status_.refusal = cleanText(message.refusal().reason(), link_limits::longest_text);
        wants_to_close_ = true;
        return true;
    }
    if (message.content_case() == ToConsole::kWelcome) {
        const wire::Welcome& welcome = message.welcome();
        if (status_.state != State::Greeting || welcome.version() < link_limits::oldest_version ||
            welcome.version() > link_limits::newest_version)
            return false;
        status_.state = State::Joined;
        ++status_.joins;
        status_.welcome = {welcome.version(),
                           {cleanText(welcome.name(), link_limits::longest_text),
                            cleanText(welcome.program(), link_limits::longest_text)},
                           {},
                           welcome.console(),
                           welcome.run(),
                           datagramsOf(welcome)};
        status_.datagrams = newest_datagram_ = 0;
        reported_.reset();
        for (const std::string& capability : welcome.capabilities())
            if (status_.welcome.capabilities.size() < link_limits::most_counts)
                status_.welcome.capabilities.push_back(cleanText(capability, link_limits::longest_word));
        add(status_.welcome);
        return true;
    }
    if (status_.state != State::Joined) return false;
    switch (message.content_case()) {
        case ToConsole::kReply:
            takeReply(message);
            return true;
        case ToConsole::kProbe:
            takeProbe(message, now);
            return true;
        case ToConsole::kSnapshot:
            return takeSnapshot(message);
        case ToConsole::kControl:
            status_.control = read(message.control());
            add(status_.control);
            return true;
        case ToConsole::kParameters: {
            auto parameters = read(message.parameters());
            if (!parameters) return false;
            status_.parameters = *parameters;
            add(*std::move(parameters));
            return true;
        }
        case ToConsole::kRecordings:
            return takeAnswer(message.recordings().request(), read(message.recordings()));
        case ToConsole::kRecording:
            return takeAnswer(message.recording().request(), read(message.recording()));
        case ToConsole::kRows:
            return takeAnswer(message.rows().request(), read(message.rows()));
        case ToConsole::CONTENT_NOT_SET:
            return true;  // of a newer tracker: nothing that this console knows
        default:
            return takeStream(message, now);
    }
}

bool LinkClient::takeSnapshot(const wire::ToConsole& message) {
    const wire::Snapshot& in = message.snapshot();
    LinkSnapshot snapshot;
    auto parameters = read(in.parameters());
    auto health = read(in.health());
    if (!parameters || !health || static_cast<std::size_t>(in.tracks_size()) > link_limits::most_tracks ||
        static_cast<std::size_t>(in.log_size()) > link_limits::recent_log_lines)
        return false;
    for (const wire::Track& each : in.tracks()) {
        auto track = read(each);
        if (!track) return false;
        snapshot.tracks.push_back(*std::move(track));
    }
    for (const wire::Log& each : in.log()) {
        auto line = read(each);
        if (!line) return false;
        snapshot.log.push_back(*std::move(line));
    }
    if (in.first_ping_us() != 0) {
        snapshot.first_ping = timeFrom(in.first_ping_us());
        if (!snapshot.first_ping) return false;
    }
    snapshot.parameters = status_.parameters = *std::move(parameters);
    snapshot.control = status_.control = read(in.control());
    snapshot.health = *std::move(health);
    last_sequence_.clear();  // streams begin anew
    ++status_.snapshots;
    add(std::move(snapshot));
    return true;
}

/// False for what has been before; what is missing is counted.
bool LinkClient::isNext(const wire::ToConsole& message) {
    const auto [last, first_of_its_kind] = last_sequence_.try_emplace(message.content_case(), message.sequence());
    if (first_of_its_kind) return true;
    if (message.sequence() <= last->second) return false;
    status_.gaps += message.sequence() - last->second - 1;
    last->second = message.sequence();
    return true;
}

bool LinkClient::takeStream(const wire::ToConsole& message, Microseconds now) {
    using wire::ToConsole;
    const std::uint64_t gaps_before = status_.gaps;
    if (!isNext(message)) {
        ++status_.late;
        return true;
    }
    const auto pass_on = [this](auto value) {
        if (!value) return false;
        add(*std::move(value));
        return true;
    };
    switch (message.content_case()) {
        case ToConsole::kBeam: {
            auto beam = read(message.beam());
            if (!beam) return false;
            if (status_.gaps != gaps_before) beam->update.broke_off = true;  // a gap is shown as a gap
            noteLatency(beam->ping.time, now);
            return pass_on(std::move(beam));
        }
        case ToConsole::kRegions:
            return pass_on(read(message.regions()));
        case ToConsole::kTracks:
            return pass_on(read(message.tracks()));
        case ToConsole::kParticles:
            return pass_on(read(message.particles()));
        case ToConsole::kHealth:
            return pass_on(read(message.health()));
        case ToConsole::kLog:
            return pass_on(read(message.log()));
        default:
            return false;
    }
}

/// Of what was asked for, and only once.
template <class Answer>
bool LinkClient::takeAnswer(std::uint32_t request, std::optional<Answer> answer) {
    if (unanswered_.erase(request) == 0) return false;
    if (answer)
        add(*std::move(answer));
    else
        add(LinkReply{request, false, "the answer cannot be understood"});
    return answer.has_value();
}

void LinkClient::takeReply(const wire::ToConsole& message) {
    const wire::Reply& reply = message.reply();
    if (unanswered_.erase(reply.request()) == 0) return;  // nobody asked
    add(LinkReply{reply.request(), reply.done(), cleanText(reply.reason(), link_limits::longest_text)});
}

void LinkClient::takeProbe(const wire::ToConsole& message, Microseconds now) {
    const Microseconds sent(message.probe().console_us());
    const auto theirs = timeFrom(message.probe().tracker_us());
    if (!theirs || sent > now || sent < up_since_) return;  // not one of ours
    const Microseconds round_trip = now - sent;
    status_.round_trip = round_trip;
    probes_.push_back({round_trip, theirs->time_since_epoch() - (sent + round_trip / 2)});
    if (probes_.size() > probes_kept) probes_.pop_front();
}

std::optional<LinkClient::Probed> LinkClient::quickest() const {
    if (probes_.empty()) return std::nullopt;
    return *std::min_element(probes_.begin(), probes_.end(),
                             [](const Probed& a, const Probed& b) { return a.round_trip < b.round_trip; });
}

std::optional<Timestamp> LinkClient::trackerTime(Microseconds now) const {
    const auto probed = quickest();
    if (!probed) return std::nullopt;
    return Timestamp(now + probed->offset);
}

std::optional<Microseconds> LinkClient::quickestRoundTrip() const {
    const auto probed = quickest();
    if (!probed) return std::nullopt;
    return probed->round_trip;
}

void LinkClient::noteLatency(Timestamp happened, Microseconds now) {
    if (const auto theirs = trackerTime(now))
        status_.latency = std::max(Microseconds{0}, std::chrono::duration_cast<Microseconds>(*theirs - happened));
}

std::optional<double> LinkClient::linkAge(Microseconds now) const {
    if (!status_.last_heard) return std::nullopt;
    return std::chrono::duration<double>(now - *status_.last_heard).count();
}

/// Where nobody takes them the oldest go, and a new snapshot would be needed: that is said by a gap.
void LinkClient::add(LinkEvent event) {
    if (events_.size() >= link_limits::most_events) {
        events_.pop_front();
        ++status_.gaps;
    }
    events_.push_back(std::move(event));
}

std::optional<LinkEvent> LinkClient::next() {
    if (events_.empty()) return std::nullopt;
    LinkEvent event = std::move(events_.front());
    events_.pop_front();
    return event;
}

void LinkClient::probe(Microseconds now) {
    probed_ = now;
    wire::ToTracker message;
    message.mutable_probe()->set_console_us(now.count());
    send(message);
}

void LinkClient::send(const wire::ToTracker& message) { output_ += linkFrame(message.SerializeAsString()); }

std::uint32_t LinkClient::ask(wire::ToTracker& message) {
    if (status_.state != State::Joined || unanswered_.size() >= most_unanswered) return 0;
    message.set_request(next_request_++);
    if (next_request_ == 0) next_request_ = 1;
    unanswered_.insert(message.request());
    send(message);
    return message.request();
}

}  // namespace echotrail
