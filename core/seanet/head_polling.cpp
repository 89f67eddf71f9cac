#include "core/seanet/head_session.hpp"
#include "core/seanet/ping_decoder.hpp"

#include <algorithm>
#include <cassert>

/// The part of HeadSession that asks for lines. In full duplex one trigger goes out on each line: the first one from
/// idle brings two lines, so that the head always has one more to go on with. In half duplex they take turns.
namespace echotrail::seanet {
namespace {

using namespace std::chrono_literals;
constexpr int most_misses = 3, most_repeats = 3, most_unlike_resumed = 3;
constexpr int lines_under_way = 4;    // that may still be as before, after the head was told
constexpr int motor_given_up = 6;     // lines out of step, after which telling again was of no help
constexpr int tell_again_every = 50;  // lines, while a head goes on to say that it was reset
constexpr Microseconds last_listen = 3s, still_coming = 300ms, longest_transfer = 3s, between_motor_reboots = 60s;
constexpr Microseconds longest_turn = 2s;  // of the transducer to its new sector
constexpr std::uint32_t day_length_ms = 86'400'000;

Microseconds twoWayTime(double range_m, double sound_speed) {
    return microsecondsFromSeconds(2.0 * range_m / sound_speed);
}

}  // namespace

void HeadSession::poll(Microseconds now) {
    assert(in_head_);
    enter(Step::Poll, HeadState::Polling, now);
    misses_ = unlike_ = repeats_ = troubled_ = 0;
    told_since_line_ = true;
    output_.clear();
    trigger(now);
}

void HeadSession::trigger(Microseconds now) {
    const auto since_link_ms = std::chrono::duration_cast<std::chrono::milliseconds>(now - link_since_).count();
    const auto time_ms = static_cast<std::uint32_t>((since_link_ms + day_ms_) % day_length_ms);
    send(encodeSendData(time_ms, head_.node));
    asked_at_ = now;
    deadline_ = now + lineTimeout();
}

Microseconds HeadSession::lineTimeout() const {
    constexpr double bytes_per_second = 11'520.0, parameters_and_frame = 45.0;
    const Microseconds transfer = microsecondsFromSeconds((command_.bins + parameters_and_frame) / bytes_per_second);
    const Microseconds line = 2 * twoWayTime(settings_.range_m, settings_.sound_speed) + transfer + 300ms;
    return std::max<Microseconds>(1s, line) + (told_since_line_ ? longest_turn : Microseconds(0));
}

void HeadSession::takeLine(Microseconds now, const HeadData& line) {
    if (!head_.block && head_.device_type == 0) {
        head_.device_type = line.device_type;
        refreshIdentity();
    }
    if (step_ == Step::Listen) tryToResume(now, line);
    if (step_ == Step::Poll || step_ == Step::PollListen) takePolledLine(now, line);
}

void HeadSession::tryToResume(Microseconds now, const HeadData& line) {
    if (!in_head_) return foundRunning(now);
    if (differenceOf(*in_head_, line).empty()) {
        enter(Step::Poll, HeadState::Polling, now);
        misses_ = unlike_ = repeats_ = troubled_ = 0;
        asked_at_ = link_since_;
    } else if (++unlike_ >= most_unlike_resumed) {
        in_head_.reset();
        foundRunning(now);
    } else {
        output_.clear();
        trigger(now);
    }
}

void HeadSession::takePolledLine(Microseconds now, const HeadData& line) {
    step_ = Step::Poll;
    ++status_.pings;
    misses_ = 0;
    reboots_in_a_row_ = 0;
    if (headIsInTrouble(now, line)) return;
    compareWithOrders(line);
    const Microseconds flight = twoWayTime(rangeScaleMetres(line.range_scale), settings_.sound_speed);
    // a line doubled on the way is no answer to the trigger that its twin brought about: sound is not that fast
    if (status_.half_duplex && now - asked_at_ < flight / 2) return;
    told_since_line_ = false;
    sendChange();
    trigger(now);
}

bool HeadSession::headIsInTrouble(Microseconds now, const HeadData& line) {
    if (!line.wasReset() && !line.motorLostSync()) {
        troubled_ = 0;
        return false;
    }
    if (troubled_++ % tell_again_every == 0) {
        tell_all_ = true;
        ++status_.retries;
    }
    const bool recently = rebooted_for_motor_ && now - *rebooted_for_motor_ < between_motor_reboots;
    if (!line.motorLostSync() || troubled_ < motor_given_up || recently) return false;
    rebooted_for_motor_ = now;
    reboot(now);
    return true;
}

void HeadSession::compareWithOrders(const HeadData& line) {
    status_.confirmed = confirmedSettings(line, settings_);
    status_.difference = differenceOf(command_, line);
    status_.advice.clear();
    if (line.motorLostSync()) status_.advice = "The motor loses its steps, so bearings are wrong: is it free to turn?";
    if (differenceOf(*in_head_, line).empty()) {
        unlike_ = repeats_ = 0;
    } else if (repeats_ >= most_repeats) {
        status_.advice = "The head keeps to other parameters than it was told: " + status_.difference + '.';
    } else if (++unlike_ >= lines_under_way) {
        ++repeats_;
        ++status_.retries;
        tell_all_ = true;
    }
}

/// Tells the head what it has not been told yet; only the gains where that is enough.
void HeadSession::sendChange() {
    if (!tell_all_ && command_ == *in_head_) return;
    if (!tell_all_ && command_.channels && differOnlyInGains(command_, *in_head_))
        send(encodeGains(*command_.channels, head_.node));
    else
        send(encodeHeadCommand(command_, head_.node));
    in_head_ = command_;
    tell_all_ = false;
    told_since_line_ = true;
    unlike_ = 0;
}

void HeadSession::lineTimedOut(Microseconds now) {
    if (step_ == Step::PollListen) {
        listen(now);
        status_.state = HeadState::Silent;
        status_.advice = "The head has fallen silent: check its power and cable.";
        return;
    }
    const bool coming = parser_.unfinishedBytes() > 0 && now - last_bytes_ < still_coming;
    if (coming && now - asked_at_ < lineTimeout() + longest_transfer) {
        deadline_ = now + still_coming;
        return;
    }
    const std::uint64_t before = status_.pings;
    giveUpPartialFrames(now);  // a whole line may lie behind a damaged one
    if (status_.pings != before || step_ != Step::Poll) return;
    ++status_.timeouts;
    if (++misses_ >= most_misses) {
        step_ = Step::PollListen;
        deadline_ = now + last_listen;
        return;
    }
    ++status_.retries;
    if (!output_.empty()) tell_all_ = true;  // it never went out
    output_.clear();
    sendChange();
    trigger(now);
}

void HeadSession::headWasReset(Microseconds now) {
    ++status_.head_resets;
    in_head_.reset();
    output_.clear();
    centre(now);
}

}  // namespace echotrail::seanet
