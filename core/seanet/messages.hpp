#pragma once

#include "core/seanet/frame_parser.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// Typed messages of the SeaNet protocol. Field names and layouts follow the Tritech DigSon notes, rev 4; integers are
/// raw wire values unless a comment says otherwise. Offsets in comments count from the frame's `@`.
namespace echotrail::seanet {

enum class MessageId : std::uint8_t {
    VersionData = 1,
    HeadData = 2,
    Alive = 4,
    BBUserData = 6,
    AuxData = 8,
    ReBoot = 16,
    HeadCommand = 19,
    SendVersion = 23,
    SendBBUser = 24,
    SendData = 25,
    FpgaVersionData = 57,
    FpgaCalibrationData = 63,
    StopAlives = 66,
};

/// "mtHeadData"; "message 61" where the id has no name here.
std::string messageName(std::uint8_t id);

struct VersionData {
    std::uint8_t byte13 =
        0;  ///< digital heads: software version; others: channel frequency codes, low nibble channel 1
    std::uint8_t infobits = 0;
    std::uint16_t serial = 0;
    std::uint32_t program_length = 0;
    std::uint16_t checksum = 0;
    std::uint8_t node = 0;
};

struct Alive {
    std::uint8_t will_send = 0;
    std::uint32_t head_time_ms = 0;
    std::uint16_t transducer = 0;  ///< 1/16 gradian; 3200 is ahead
    std::uint8_t head_info = 0;
    bool inCentre() const { return head_info & 0x01; }
    bool centred() const { return head_info & 0x02; }
    bool motoring() const { return head_info & 0x04; }
    bool motorOn() const { return head_info & 0x08; }
    bool offCentre() const { return head_info & 0x10; }
    bool inScan() const { return head_info & 0x20; }
    bool needsParameters() const { return head_info & 0x40; }
    bool sentConfiguration() const { return head_info & 0x80; }
};

/// One channel of a digital head.
struct DigitalChannel {
    std::uint32_t receive_start_hz = 0, receive_end_hz = 0;
    std::uint32_t filter_length_us = 0, sample_rate_hz = 0;
    std::uint32_t transmit_start_hz = 0, transmit_end_hz = 0, transmit_pulse_us = 0;
    std::uint8_t transmit_duty = 0;
};

struct BBUserData {
    std::uint8_t surface_node = 0;
    std::uint16_t magic = 0;      ///< 0x1234
    std::uint16_t length = 0;     ///< how much of the block is meaningful
    std::uint8_t board_type = 0;  ///< 15: digital
    std::uint8_t software_version = 0;
    std::uint16_t main_port_low = 0, main_port_high = 0;  ///< codes of the baud rates
    bool half_duplex = false;
    bool has_motor = false;
    std::uint16_t pan_constant = 0, pan_speed = 0;
    // digital heads
    std::uint8_t head_kind = 0;  ///< 1 SeaKing, 2 SeaPrince, 3 Micron
    DigitalChannel channel[2];
    // older heads
    std::uint16_t transmit_khz[2] = {0, 0}, receive_khz[2] = {0, 0}, slope[2] = {0, 0};
    bool digital() const { return board_type == 15; }
};

struct AuxData {
    std::string text;  ///< as sent; may hold any byte
};

struct FpgaVersionData {
    std::uint8_t device_id = 0;
    std::uint32_t flash_id = 0;
    std::uint8_t revision = 0;
    std::uint32_t user_code = 0;
};

struct FpgaCalibrationData {
    std::vector<std::uint8_t> bytes;
};

/// Well formed, but of no use here; or its payload is too short for what it claims to be.
struct OtherMessage {
    std::uint8_t id = 0;
    bool malformed = false;
};

/// Everything but mtHeadData, which may take several frames: see HeadDataAssembler.
using Message =
    std::variant<VersionData, Alive, BBUserData, AuxData, FpgaVersionData, FpgaCalibrationData, OtherMessage>;

Message decodeMessage(const Frame& frame);
/// From a payload without its frame, as recordings keep it.
Message decodeMessage(std::uint8_t id, Bytes payload);

}  // namespace echotrail::seanet
