#pragma once

#include <cstdint>
#include <string>

namespace echotrail {

/// `text*hh`, with the right checksum.
inline std::string withChecksum(const std::string& text) {
    constexpr char digits[] = "0123456789ABCDEF";
    unsigned sum = 0;
    for (const char c : text) sum ^= static_cast<unsigned char>(c);
    return text + "*" + digits[sum >> 4U & 15U] + digits[sum & 15U];
}

inline constexpr std::int64_t first_ms = 1274601600000;

/// A line as a navigation file holds it, `after_ms` after `first_ms`; `body` is the sentence without its `$`.
inline std::string nmeaLine(std::int64_t after_ms, const std::string& body) {
    return "\\" + withChecksum("c:" + std::to_string(first_ms + after_ms)) + "\\$" + withChecksum(body) + "\r\n";
}

}  // namespace echotrail
