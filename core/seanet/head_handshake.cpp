#include "core/seanet/head_session.hpp"

#include <algorithm>
#include <utility>

/// The part of HeadSession before the first line. Times and tries: Tritech DigSon notes and the drivers in the field.
namespace echotrail::seanet {
namespace {

using namespace std::chrono_literals;
constexpr Microseconds patience = 4s;       // for a sign of life
constexpr Microseconds quiet_reboot = 1s;   // what still comes was said before it
constexpr Microseconds longest_boot = 6s;   // until it speaks again
constexpr Microseconds alive_missing = 5s;  // an idle head says so once a second
constexpr Microseconds slow_centring = 15s, longest_centring = 30s, longest_check = 10s;
constexpr Microseconds answer_within = 1s, block_within = 2s, tail_within = 300ms;
constexpr int version_tries = 5, block_tries = 2, command_tries = 3, most_reboots = 2, most_probes = 3;
constexpr std::uint64_t enough_bytes = 64;  // to say that they mean nothing

/// A head that holds parameters has been centred before, though a scan may have left it to one side.
bool isCentred(const Alive& alive) {
    return !alive.motoring() && (alive.centred() || (!alive.needsParameters() && !alive.inCentre()));
}

}  // namespace

void HeadSession::listen(Microseconds now) {
    enter(Step::Listen, HeadState::Waiting, now);
    bytes_heard_ = text_heard_ = echoes_ = 0;
    other_node_.reset();
    answered_ = told_since_line_ = false;
    alive_.reset();
    unlike_ = 0;
    if (!in_head_) {  // it may be another one by now
        head_ = HeadIdentity{.node = head_.node};
        refreshIdentity();
    }
    deadline_ = now + answer_within;
}

void HeadSession::judgeSilence(Microseconds now) {
    if (now - std::max(since_, quiet_until_) < patience) return;
    status_.state = HeadState::WrongDevice;
    if (other_node_) {
        status_.advice = "A device answers as node " + std::to_string(*other_node_) +
                         ", but the sonar should be node " + std::to_string(head_.node) +
                         ": set the node, or look for another port.";
    } else if (echoes_ > 0) {
        status_.state = HeadState::Silent;
        status_.advice =
            "Only our own commands come back: the adapter echoes, and no head answers. Check the head's "
            "power and its two data wires.";
    } else if (bytes_heard_ >= enough_bytes) {
        const bool text = text_heard_ * 10 > bytes_heard_ * 9;
        status_.advice =
            text ? "Text arrives, as from a compass or a GPS receiver: this is not the sonar's port."
                 : "Bytes arrive that mean nothing: try another baud rate (115200, or 9600), or another port.";
    } else {
        status_.state = HeadState::Silent;
        status_.advice = "Nothing is heard: check the head's power and cable, the port, and its baud rate (115200).";
    }
}

/// Somebody's parameters are inside, or it scans for somebody: only a fresh start makes sure of its state.
void HeadSession::foundRunning(Microseconds now) {
    if (reboots_in_a_row_ < most_reboots)
        reboot(now);
    else
        identify(now);  // it will not let go of them; ours replace them as well
}

void HeadSession::reboot(Microseconds now) {
    output_.clear();
    send(encodeReBoot(head_.node));
    ++status_.reboots_sent;
    ++reboots_in_a_row_;
    in_head_.reset();
    listen(now);
    quiet_until_ = now + quiet_reboot;
    deadline_ = now + longest_boot;
}

void HeadSession::identify(Microseconds now) {
    if (in_head_) head_ = HeadIdentity{.node = head_.node};  // it was away: another one may have come
    in_head_.reset();
    output_.clear();
    status_.advice.clear();
    refreshIdentity();
    if (head_.version) return askBlock(now);
    enter(Step::Version, HeadState::Identifying, now);
    send(encodeSendVersion(head_.node));
    deadline_ = now + answer_within;
}

void HeadSession::askBlock(Microseconds now) {
    enter(Step::Block, HeadState::Identifying, now);
    status_.advice.clear();
    send(encodeSendBBUser(head_.node));
    deadline_ = now + block_within;
}

void HeadSession::centre(Microseconds now) {
    if (head_.block && !head_.block->has_motor) return configure(now);
    enter(Step::Centre, HeadState::Centring, now);
    deadline_ = now + alive_missing;
    if (alive_ && isCentred(*alive_) && now - alive_at_ < alive_missing) configure(now);
}

void HeadSession::configure(Microseconds now) {
    if (step_ != Step::Parameters) enter(Step::Parameters, HeadState::Configuring, now);
    ++tries_;
    status_.advice.clear();
    output_.clear();
    send(encodeHeadCommand(command_, head_.node));
    in_head_ = command_;
    tell_all_ = false;
    asked_at_ = now;
    deadline_ = now + alive_missing;
}

void HeadSession::takeAlive(Microseconds now, const Alive& alive) {
    alive_ = alive;
    alive_at_ = now;
    const bool ready = !alive.needsParameters();
    switch (step_) {
        case Step::Listen:
            if (!ready) {
                if (in_head_) ++status_.head_resets;
                identify(now);
            } else if (in_head_) {
                probe(now);
            } else {
                foundRunning(now);
            }
            break;
        case Step::Centre:
            if (isCentred(alive)) configure(now);
            break;
        case Step::Parameters:
            if (ready) poll(now);
            break;
        case Step::Poll:
            if (!ready) headWasReset(now);
            break;
        case Step::PollListen:
            if (ready)
                poll(now);
            else
                headWasReset(now);
            break;
        default:
            break;
    }
}

/// After a break: the copy of the parameters in its next line tells whether they are still ours.
void HeadSession::probe(Microseconds now) {
    if (tries_ > 0 && now - asked_at_ < lineTimeout()) return;
    if (++tries_ > most_probes) return foundRunning(now);
    trigger(now);
}

void HeadSession::takeVersion(Microseconds now, const VersionData& version) {
    if (step_ != Step::Listen && step_ != Step::Version) return;  // said twice, or late
    const bool other =
        head_.version && (head_.version->serial != version.serial || head_.version->checksum != version.checksum);
    if (other) head_.block.reset();
    head_.version = version;
    refreshIdentity();
    if (other) in_head_.reset();
    if (step_ == Step::Version) askBlock(now);
}

void HeadSession::takeBlock(Microseconds now, const BBUserData& block) {
    constexpr std::uint16_t magic = 0x1234;
    if (block.magic != magic) {
        ++malformed_;
        return;
    }
    if (head_.block && step_ != Step::Block) return;  // said twice
    head_.block = block;
    refreshIdentity();
    if (step_ != Step::Block) return;
    if (!block.digital()) return centre(now);
    enter(Step::BlockTail, HeadState::Identifying, now);
    deadline_ = now + tail_within;
}

void HeadSession::handshakeTimedOut(Microseconds now) {
    switch (step_) {
        case Step::Listen:
            return nothingHeard(now);
        case Step::Version:
            return noAnswer(now);
        case Step::Block:
            if (tries_ + 1 < block_tries) return askAgain(now, encodeSendBBUser(head_.node), block_within);
            ++status_.timeouts;
            return centre(now);
        case Step::BlockTail:
            return centre(now);
        default:
            return notReadyYet(now);
    }
}

void HeadSession::noAnswer(Microseconds now) {
    if (tries_ + 1 < version_tries) return askAgain(now, encodeSendVersion(head_.node), answer_within);
    const bool heard = alive_ && now - alive_at_ < alive_missing;
    if (!heard) listen(now);
    status_.state = HeadState::Silent;
    status_.advice =
        "The head is heard but does not answer: check the wire that carries commands to it, and whether "
        "it speaks RS-232 or RS-485.";
    if (heard) askAgain(now, encodeSendVersion(head_.node), 2 * answer_within);
}

void HeadSession::askAgain(Microseconds now, FrameBytes question, Microseconds within) {
    ++tries_;
    ++status_.timeouts;
    ++status_.retries;
    output_.clear();
    send(std::move(question));
    deadline_ = now + within;
}

void HeadSession::nothingHeard(Microseconds now) {
    const Microseconds enough = in_head_ ? 2 * patience : patience;  // lines may get lost while it is probed
    if (answered_ && now - std::max(since_, quiet_until_) >= enough) return foundRunning(now);  // alives were stopped
    if (!answered_) judgeSilence(now);
    output_.clear();
    send(encodeSendVersion(head_.node));
    deadline_ = now + (status_.state == HeadState::Waiting ? answer_within : 2 * answer_within);
}

/// While it centres, or checks what it was told.
void HeadSession::notReadyYet(Microseconds now) {
    if (now - std::max(alive_ ? alive_at_ : since_, since_) >= alive_missing) {
        ++status_.timeouts;
        in_head_.reset();
        return listen(now);
    }
    deadline_ = now + answer_within;
    if (step_ == Step::Centre) {
        if (now - since_ >= slow_centring)
            status_.advice = "The head does not find its centre: is the transducer free to turn?";
        if (now - since_ >= longest_centring) reboot(now);
    } else if (now - asked_at_ >= longest_check) {
        ++status_.timeouts;
        if (tries_ >= command_tries) return reboot(now);
        ++status_.retries;
        configure(now);
    }
}

}  // namespace echotrail::seanet
