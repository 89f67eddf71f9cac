#include "core/seanet/head_session.hpp"

#include <algorithm>
#include <utility>
#include <variant>

namespace echotrail::seanet {
namespace {

using namespace std::chrono_literals;
constexpr std::uint8_t host_node = 255;
constexpr Microseconds frame_silence = 1s;  // within a frame; longer, and its rest is not coming

}  // namespace

HeadSession::HeadSession(const HeadSettings& settings, Duplex duplex, std::uint8_t node)
    : settings_(settings), duplex_(duplex) {
    head_.node = node;
    status_.commanded = settings;
    command_ = commandFor(settings_, head_);
    refreshIdentity();
}

void HeadSession::linkUp(Microseconds now, std::uint32_t day_ms) {
    linkDown(now);
    day_ms_ = day_ms;
    link_since_ = last_bytes_ = now;
    quiet_until_ = now;
    reboots_in_a_row_ = 0;
    listen(now);
}

void HeadSession::linkDown(Microseconds now) {
    forgetPartialFrames();
    output_.clear();
    enter(Step::NoLink, HeadState::NoLink, now);
    deadline_.reset();
    status_.advice.clear();
}

void HeadSession::received(Microseconds now, Bytes bytes) {
    if (step_ == Step::NoLink || bytes.empty()) return;
    if (now - last_bytes_ > frame_silence) giveUpPartialFrames(now);
    last_bytes_ = now;
    if (now < quiet_until_) return;  // said before the head heard that it is to start afresh
    bytes_heard_ += bytes.size();
    text_heard_ += static_cast<std::uint64_t>(std::count_if(
        bytes.begin(), bytes.end(), [](std::uint8_t b) { return (b >= ' ' && b <= '~') || b == '\r' || b == '\n'; }));
    parser_.take(bytes, [&](const Frame& frame) { takeFrame(now, frame); });
    countRejected();
}

void HeadSession::takeFrame(Microseconds now, const Frame& frame) {
    if (now < quiet_until_) return;
    if (frame.source() != head_.node) {
        ++status_.foreign;
        if (frame.source() == host_node)
            ++echoes_;
        else
            other_node_ = frame.source();
        return;
    }
    answered_ = true;
    if (frame.id() == static_cast<std::uint8_t>(MessageId::HeadData)) {
        if (const auto line = assembler_.take(frame)) takeLine(now, *line);
        return;
    }
    const Message message = decodeMessage(frame);
    if (const auto* alive = std::get_if<Alive>(&message)) takeAlive(now, *alive);
    if (const auto* version = std::get_if<VersionData>(&message)) takeVersion(now, *version);
    if (const auto* block = std::get_if<BBUserData>(&message)) takeBlock(now, *block);
    if (const auto* other = std::get_if<OtherMessage>(&message)) malformed_ += other->malformed;
    // a digital head says this last of itself
    if (std::holds_alternative<FpgaVersionData>(message) && step_ == Step::BlockTail) centre(now);
}

void HeadSession::tick(Microseconds now) {
    if (!deadline_ || now < *deadline_) return;
    if (step_ == Step::Poll || step_ == Step::PollListen)
        lineTimedOut(now);
    else
        handshakeTimedOut(now);
}

void HeadSession::setSettings(Microseconds now, const HeadSettings& settings) {
    settings_ = settings;
    status_.commanded = settings;
    const HeadCommand before = std::exchange(command_, commandFor(settings_, head_));
    if (command_ == before) return;
    repeats_ = 0;
    if (step_ == Step::Parameters) {
        tries_ = 0;
        configure(now);
    }
    // in full duplex at once, but not more often than lines come: a slider moves faster than a head listens
    if (step_ == Step::Poll && !status_.half_duplex && !told_since_line_) sendChange();
}

std::optional<FrameBytes> HeadSession::takeOutput() {
    if (output_.empty()) return std::nullopt;
    FrameBytes next = std::move(output_.front());
    output_.pop_front();
    return next;
}

void HeadSession::enter(Step step, HeadState state, Microseconds now) {
    step_ = step;
    since_ = now;
    tries_ = 0;
    status_.state = state;
}

void HeadSession::forgetPartialFrames() {
    parser_.giveUpUnfinished([](const Frame&) {});
    assembler_.giveUpUnfinished();
}

void HeadSession::giveUpPartialFrames(Microseconds now) {
    parser_.giveUpUnfinished([&](const Frame& frame) { takeFrame(now, frame); });
    assembler_.giveUpUnfinished();
    countRejected();
}

void HeadSession::refreshIdentity() {
    status_.head = head_.text();
    status_.digital = head_.digital();
    status_.half_duplex = duplex_ == Duplex::Half || (duplex_ == Duplex::FromHead && head_.halfDuplex());
    command_ = commandFor(settings_, head_);
}

void HeadSession::countRejected() {
    status_.rejected = malformed_ + parser_.damagedStretches();
    for (const auto& [cause, number] : assembler_.rejected()) status_.rejected += number;
}

}  // namespace echotrail::seanet
