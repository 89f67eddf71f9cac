#include "core/link/datagram_way.hpp"

#include "core/link/framing.hpp"
#include "core/link/link_limits.hpp"

#include <algorithm>
#include <cassert>

namespace echotrail {
namespace {

constexpr double much = 0.1;  ///< lost: radios lose some in the best of times
constexpr double most = 0.4;  ///< lost: a picture of such remains tells little
/// Sent, before a share is judged: of few, chance alone loses any share now and then.
constexpr std::uint64_t enough = 30;
constexpr Microseconds before_less{1'000'000}, before_more{5'000'000};

}  // namespace

void DatagramWay::report(std::uint64_t newest, std::uint64_t received, Timestamp now) {
    if (received > newest || newest < newest_ || received < received_) return;  // it cannot be
    if (received > received_last_) arrived_ = now;
    received_last_ = std::max(received_last_, received);
    const std::uint64_t sent = newest - newest_, arrived = received - received_;
    if (sent < enough) return;
    newest_ = newest;
    received_ = received;
    const double lost = arrived >= sent ? 0.0 : 1.0 - static_cast<double>(arrived) / static_cast<double>(sent);
    const SendQueue::Level worth = lost > most   ? SendQueue::NoPicture
                                   : lost > much ? SendQueue::QuarterDetail
                                                 : SendQueue::Everything;
    if (level_ < worth)
        step(1, before_less, now);
    else if (level_ > worth)
        step(-1, before_more, now);
}

void DatagramWay::tellCrowded(Timestamp now) {
    if (level_ < SendQueue::NoPicture)
        step(1, before_less, now);
    else
        level_changed_ = now;  // no step back to more for a while
}

/// To less, or to more, but not sooner after the last step than that.
void DatagramWay::step(int levels, Microseconds not_before, Timestamp now) {
    if (now - level_changed_ <= not_before) return;
    level_ = static_cast<SendQueue::Level>(level_ + levels);
    level_changed_ = now;
}

bool DatagramWay::works(Timestamp now) const { return arrived_ && now - *arrived_ < link_limits::nothing_arrives; }

bool DatagramWay::fits(const SendQueue::Frame& frame) {
    return frame->size() <= link_limits::longest_datagram_text + link_frame_head;
}

void DatagramWay::add(const SendQueue::Frame& frame) {
    assert(fits(frame));
    if (waiting_.size() >= link_limits::most_datagrams) waiting_.pop_front();
    waiting_.push_back(frame->substr(link_frame_head));
}

std::vector<std::string> DatagramWay::take() {
    std::vector<std::string> texts(std::make_move_iterator(waiting_.begin()), std::make_move_iterator(waiting_.end()));
    waiting_.clear();
    return texts;
}

}  // namespace echotrail
