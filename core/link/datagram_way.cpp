#include "core/link/datagram_way.hpp"

#include "core/link/framing.hpp"
#include "core/link/link_limits.hpp"

namespace echotrail {

std::optional<double> DatagramWay::report(std::uint64_t newest, std::uint64_t received, Timestamp now) {
    constexpr std::uint64_t enough = 4;
    if (received > newest || newest < newest_ || received < received_) return std::nullopt;  // it cannot be
    const std::uint64_t sent = newest - newest_, arrived = received - received_;
    if (arrived > 0) arrived_ = now;
    if (sent < enough) return std::nullopt;
    newest_ = newest;
    received_ = received;
    return arrived >= sent ? 0.0 : 1.0 - static_cast<double>(arrived) / static_cast<double>(sent);
}

bool DatagramWay::works(Timestamp now) const { return arrived_ && now - *arrived_ < link_limits::nothing_arrives; }

bool DatagramWay::add(const SendQueue::Frame& frame) {
    if (frame->size() > link_limits::longest_datagram_text + link_frame_head) return false;
    if (waiting_.size() >= link_limits::most_datagrams) waiting_.pop_front();
    waiting_.push_back(frame->substr(link_frame_head));
    return true;
}

std::vector<std::string> DatagramWay::take() {
    std::vector<std::string> texts(std::make_move_iterator(waiting_.begin()), std::make_move_iterator(waiting_.end()));
    waiting_.clear();
    return texts;
}

}  // namespace echotrail
