#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace echotrail {

/// The length of a message before it: four bytes, the highest first.
inline constexpr std::size_t link_frame_head = 4;

/// `message` as it goes over the wire.
std::string linkFrame(std::string_view message);

/// Cuts a stream into messages. A length of 0 or beyond the limit is never allocated: the stream is broken then, for
/// nobody knows where the next message begins.
class FrameReader {
public:
    explicit FrameReader(std::size_t longest) : longest_(longest) {}

    void take(std::span<const std::uint8_t> bytes);
    /// The next whole message; valid until the next call of either.
    std::optional<std::string_view> next();
    bool broken() const { return broken_; }
    /// Bytes that are held; never more than the longest message, its head and what take() was given last.
    std::size_t held() const { return buffer_.size() - at_; }

private:
    std::size_t longest_;
    std::string buffer_;
    std::size_t at_ = 0;  ///< before it everything has been given
    bool broken_ = false;
};

}  // namespace echotrail
