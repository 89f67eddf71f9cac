#include "core/link/datagram_way.hpp"

#include "core/link/framing.hpp"
#include "core/link/link_limits.hpp"

#include <cassert>

namespace echotrail {
namespace {

constexpr double much = 0.1;  ///< lost: radios lose some in the best of times
constexpr double most = 0.4;  ///< lost: a picture of such remains tells little
constexpr Microseconds before_less{1'000'000}, before_more{5'000'000};

}  // namespace

std::optional<double> DatagramWay::report(std::uint64_t newest, std::uint64_t received, Timestamp now) {
    constexpr std::uint64_t enough = 4;
    if (received > newest || newest < newest_ || received < received_) return std::nullopt;  // it cannot be
    const std::uint64_t sent = newest - newest_, arrived = received - received_;
    if (arrived > 0) arrived_ = now;
    if (sent < enough) return std::nullopt;
    newest_ = newest;
    received_ = received;
    const double lost = arrived >= sent ? 0.0 : 1.0 - static_cast<double>(arrived) / static_cast<double>(sent);
    if (lost > much)
        sendLess(lost > most ? SendQueue::NoPicture : SendQueue::QuarterDetail, now);
    else if (level_ > SendQueue::Everything && now - level_changed_ > before_more) {
        level_ = static_cast<SendQueue::Level>(level_ - 1);
        level_changed_ = now;
    }
    return lost;
}

void DatagramWay::tellCrowded(Timestamp now) { sendLess(SendQueue::NoPicture, now); }

/// A step less, where that is not beyond the limit for this reason.
void DatagramWay::sendLess(SendQueue::Level at_most, Timestamp now) {
    if (now - level_changed_ <= before_less) return;
    level_changed_ = now;  // and no step back to more for a while
    if (level_ < at_most) level_ = static_cast<SendQueue::Level>(level_ + 1);
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
