#include "core/simulation/head_answers.hpp"

namespace echotrail {

namespace {

constexpr std::uint8_t host = 255;
constexpr std::uint32_t chirp_hz = 50'000;  // how wide the band of a digital head's channel is

/// The payload of mtBBUserData; offsets count from the frame's `@`, as the notes have them.
class Block {
public:
    Block& byte(std::size_t wire, unsigned value) {
        payload_[wire - 13] = static_cast<std::uint8_t>(value);
        return *this;
    }
    Block& word(std::size_t wire, unsigned value) { return byte(wire, value & 0xFF).byte(wire + 1, value >> 8 & 0xFF); }
    Block& number(std::size_t wire, std::uint32_t value) {
        return word(wire, value & 0xFFFF).word(wire + 2, value >> 16);
    }
    const std::vector<std::uint8_t>& payload() const { return payload_; }

private:
    std::vector<std::uint8_t> payload_ = std::vector<std::uint8_t>(250);
};

Block commonBlock() {
    constexpr unsigned main_low = 3, main_high = 7;  // codes of 9600 and 115200 baud, as on heads from the maker
    return Block().byte(13, host).word(15, 0x1234).word(35, main_low).word(37, main_high).word(33, 3);
}

std::vector<std::uint8_t> digitalBlock(bool half_duplex) {
    Block block = commonBlock();
    block.word(17, 161).byte(19, 15).byte(20, 1).byte(59, 1);
    for (std::size_t channel = 0; channel < 2; ++channel) {
        const std::size_t at = 60 + 43 * channel;
        const std::uint32_t start = head_channel_hz[channel] - chirp_hz / 2;
        block.number(at, start).number(at + 4, start + chirp_hz).number(at + 29, start);
        block.number(at + 33, start + chirp_hz).number(at + 37, 400).byte(at + 41, 100);
    }
    block.byte(146, half_duplex).byte(147, 1).word(150, 200).word(152, 800).byte(166, half_duplex);
    return block.payload();
}

std::vector<std::uint8_t> analogueBlock(bool half_duplex) {
    Block block = commonBlock();
    block.word(17, 186).word(59, 0xFFFF).word(99, half_duplex ? 0xFFFF : 0).word(109, 90).word(111, 125);
    for (std::size_t channel = 0; channel < 2; ++channel) {
        const unsigned khz = head_channel_hz[channel] / 1000;
        block.word(101 + 2 * channel, khz).word(105 + 2 * channel, khz);
    }
    block.word(123, 200).word(125, 800);
    return block.payload();
}

}  // namespace

std::vector<std::uint8_t> versionPayload(bool digital, int serial_number, std::uint8_t node) {
    constexpr unsigned frequency_codes = 0x31;  // 325 and 675 kHz
    constexpr unsigned software_version = 1, sonar_board = 0x11;
    const unsigned serial = digital ? 0 : static_cast<unsigned>(serial_number);
    seanet::ByteWriter payload;
    payload.u8(digital ? software_version : frequency_codes).u8(sonar_board).u16(serial).u32(1).u16(0).u8(node);
    return payload.bytes();
}

std::vector<std::uint8_t> blockPayload(bool digital, bool half_duplex) {
    return digital ? digitalBlock(half_duplex) : analogueBlock(half_duplex);
}

}  // namespace echotrail
