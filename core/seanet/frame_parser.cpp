#include "core/seanet/frame_parser.hpp"

#include <algorithm>
#include <cstring>

namespace echotrail::seanet {
namespace {

constexpr std::size_t header_bytes = 7;  // up to and with the binary length

/// 0…15, or −1 where the character is no hex digit.
int hexDigit(std::uint8_t c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    return -1;
}

/// The length that a frame beginning here tells twice, or 0 where the two disagree or are not all there.
std::size_t toldLength(Bytes bytes) {
    if (bytes.size() < header_bytes) return 0;
    std::size_t told = 0;
    for (std::size_t i = 1; i <= 4; ++i) {
        const int digit = hexDigit(bytes[i]);
        if (digit < 0) return 0;
        told = told * 16 + static_cast<std::size_t>(digit);
    }
    return told == u16(bytes, 5) ? told + 6 : 0;
}

/// Whether another frame begins inside this one and ends beyond it: then bytes of this one were lost on the way, and
/// what stands in the place of its line feed is data of the other.
bool runsIntoAnother(Bytes frame) {
    for (Bytes rest = frame.subspan(1);;) {
        const auto* at = static_cast<const std::uint8_t*>(std::memchr(rest.data(), '@', rest.size()));
        if (!at) return false;
        rest = rest.subspan(static_cast<std::size_t>(at - rest.data()));
        const std::size_t length = toldLength(rest);
        if (length > rest.size() && length <= FrameParser::longest_frame) return true;
        rest = rest.subspan(1);
    }
}

}  // namespace

FrameParser::Check FrameParser::check(Bytes bytes, std::size_t& length) const {
    // Before all digits are there, a wrong one already tells that this is no frame.
    for (std::size_t i = 1; i <= std::min<std::size_t>(4, bytes.size() - 1); ++i)
        if (hexDigit(bytes[i]) < 0) return Check::BadLength;
    if (bytes.size() < header_bytes) return Check::Incomplete;
    length = toldLength(bytes);
    if (length == 0) return Check::LengthsDiffer;
    if (length < shortest_frame || length > longest_frame) return Check::BadLength;
    if (bytes.size() < length) return Check::Incomplete;
    if (bytes[length - 1] != 0x0A) return Check::NoLineFeed;
    return runsIntoAnother(bytes.first(length)) ? Check::BytesLost : Check::Whole;
}

void FrameParser::skip(std::size_t bytes) {
    begin_ += bytes;
    consumed_ += bytes;
    skipped_ += bytes;
    if (frames_ == 0) skipped_before_first_ += bytes;
    if (frames_ > 0 && !in_damage_) ++damaged_stretches_;
    in_damage_ = true;
}

void FrameParser::reject(const char* cause) {
    // Before the first frame anything may be met: the stream began in the middle of one.
    if (frames_ > 0) ++rejected_[cause];
    skip(1);
}

void FrameParser::extract(const Sink& sink) {
    while (begin_ < buffer_.size()) {
        const std::uint8_t* data = buffer_.data() + begin_;
        const std::size_t size = buffer_.size() - begin_;
        const auto* at = static_cast<const std::uint8_t*>(std::memchr(data, '@', size));
        if (!at) return skip(size);
        if (at != data) {
            skip(static_cast<std::size_t>(at - data));
            continue;
        }
        std::size_t length = 0;
        switch (check({data, size}, length)) {
            case Check::Whole: {
                ++frames_;
                in_damage_ = false;
                const std::uint64_t offset = consumed_;
                begin_ += length;
                consumed_ += length;
                sink(Frame{{data, length}, offset});
                break;
            }
            case Check::Incomplete:
                return;
            case Check::BadLength:
                reject("bad_length");
                break;
            case Check::LengthsDiffer:
                reject("lengths_differ");
                break;
            case Check::NoLineFeed:
                reject("no_line_feed");
                break;
            case Check::BytesLost:
                reject("bytes_lost");
                break;
        }
    }
}

void FrameParser::take(Bytes bytes, const Sink& sink) {
    buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(begin_));
    begin_ = 0;
    buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
    extract(sink);
}

bool FrameParser::giveUpUnfinished(const Sink& sink) {
    const bool begun = unfinishedBytes() > 0;
    in_damage_ = true;  // what is cut off is not damaged
    while (unfinishedBytes() > 0) {
        skip(1);
        extract(sink);
    }
    return begun;
}

std::vector<std::uint8_t> makeFrame(std::uint8_t source, std::uint8_t destination, std::uint8_t id,
                                    std::uint8_t sequence, std::uint8_t node, Bytes payload, bool zero_count) {
    constexpr char digits[] = "0123456789ABCDEF";
    const auto length = static_cast<unsigned>(payload.size() + 8);
    assert(length + 6 <= FrameParser::longest_frame);
    ByteWriter frame;
    frame.u8('@');
    for (int shift = 12; shift >= 0; shift -= 4) frame.u8(static_cast<unsigned>(digits[length >> shift & 0xF]));
    frame.u16(length).u8(source).u8(destination).u8(zero_count ? 0 : (length - 5) & 0xFF);
    frame.u8(id).u8(sequence).u8(node).raw(payload).u8(0x0A);
    return frame.bytes();
}

}  // namespace echotrail::seanet
