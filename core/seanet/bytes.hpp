#pragma once

#include <cassert>
#include <cstdint>
#include <span>
#include <vector>

namespace echotrail::seanet {

using Bytes = std::span<const std::uint8_t>;

/// Little-endian numbers at an offset. The caller has checked that they lie inside.
inline std::uint8_t u8(Bytes bytes, std::size_t at) {
    assert(at < bytes.size());
    return bytes[at];
}
inline std::uint16_t u16(Bytes bytes, std::size_t at) {
    return static_cast<std::uint16_t>(u8(bytes, at) | u8(bytes, at + 1) << 8);
}
inline std::uint32_t u32(Bytes bytes, std::size_t at) {
    return static_cast<std::uint32_t>(u16(bytes, at)) | static_cast<std::uint32_t>(u16(bytes, at + 2)) << 16;
}

/// Appends little-endian numbers.
class ByteWriter {
public:
    ByteWriter& u8(unsigned value) { return bytes_.push_back(static_cast<std::uint8_t>(value)), *this; }
    ByteWriter& u16(unsigned value) { return u8(value & 0xFF).u8(value >> 8 & 0xFF); }
    ByteWriter& u32(std::uint32_t value) { return u16(value & 0xFFFF).u16(value >> 16); }
    ByteWriter& raw(Bytes bytes) { return bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()), *this; }
    const std::vector<std::uint8_t>& bytes() const { return bytes_; }

private:
    std::vector<std::uint8_t> bytes_;
};

}  // namespace echotrail::seanet
