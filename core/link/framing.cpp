#include "core/link/framing.hpp"

namespace echotrail {

std::string linkFrame(std::string_view message) {
    std::string frame;
    frame.reserve(link_frame_head + message.size());
    for (int shift = 24; shift >= 0; shift -= 8) frame += static_cast<char>(message.size() >> shift & 0xFF);
    frame += message;
    return frame;
}

void FrameReader::take(std::span<const std::uint8_t> bytes) {
    if (broken_) return;
    buffer_.erase(0, at_);
    at_ = 0;
    buffer_.append(bytes.begin(), bytes.end());
}

std::optional<std::string_view> FrameReader::next() {
    if (broken_ || held() < link_frame_head) return std::nullopt;
    std::size_t length = 0;
    for (std::size_t i = 0; i < link_frame_head; ++i)
        length = length << 8 | static_cast<std::uint8_t>(buffer_[at_ + i]);
    if (length == 0 || length > longest_) {
        broken_ = true;
        buffer_.clear();
        at_ = 0;
        return std::nullopt;
    }
    if (held() < link_frame_head + length) return std::nullopt;
    const std::string_view message(buffer_.data() + at_ + link_frame_head, length);
    at_ += link_frame_head + length;
    return message;
}

}  // namespace echotrail
