#pragma once

#include "core/seanet/frame_parser.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

/// What the host says to the head. Raw wire values; layouts: Tritech DigSon notes, the two misprinted examples there
/// corrected (the short forms).
namespace echotrail::seanet {

/// Gains of both channels of a dual-channel head.
struct ChannelGains {
    std::array<std::uint8_t, 2> ad_span{}, ad_low{}, gain{}, set_point{};
    std::array<std::uint16_t, 2> slope{}, slope_delay{};
    bool operator==(const ChannelGains&) const = default;
};

/// All parameters of a scan, mtHeadCommand.
struct HeadCommand {
    std::uint16_t head_control = 0x2301;
    std::uint8_t head_type = 2;  ///< 2 imaging, 0x11 digital
    std::array<std::uint32_t, 2> transmit_word{}, receive_word{};
    std::uint16_t pulse_us = 50;
    std::uint16_t range_scale = 0;
    std::uint16_t left_limit = 2400, right_limit = 4000;
    std::uint8_t ad_span = 0, ad_low = 0;
    std::array<std::uint8_t, 2> gain{};
    std::array<std::uint16_t, 2> slope{};
    std::uint8_t motor_time = 25;  ///< 10 µs
    std::uint8_t step = 16;
    std::uint16_t ad_interval = 0, bins = 0;
    std::uint16_t max_buffer = 1000;
    std::uint16_t lockout_us = 100;
    std::uint16_t minor_axis = 1600;
    std::uint8_t major_axis = 1;
    std::uint8_t control2 = 0;
    std::uint16_t scan_z = 0;
    std::optional<ChannelGains> channels;  ///< with it the command is of type 29, without of type 1
    bool operator==(const HeadCommand&) const = default;
};

using FrameBytes = std::vector<std::uint8_t>;
inline constexpr std::uint8_t default_head_node = 2;

FrameBytes encodeSendVersion(std::uint8_t node = default_head_node);
FrameBytes encodeSendBBUser(std::uint8_t node = default_head_node);
FrameBytes encodeReBoot(std::uint8_t node = default_head_node);
FrameBytes encodeStopAlives(std::uint8_t node = default_head_node);
/// `time_ms`: time of day in milliseconds; imaging heads do not look at it.
FrameBytes encodeSendData(std::uint32_t time_ms, std::uint8_t node = default_head_node);
FrameBytes encodeHeadCommand(const HeadCommand& command, std::uint8_t node = default_head_node);
/// Takes effect on the fly, without a new scan.
FrameBytes encodeGains(const ChannelGains& gains, std::uint8_t node = default_head_node);
FrameBytes encodeReverseScan(std::uint8_t node = default_head_node);

/// What a head reads: the parameters of a full mtHeadCommand, nothing for the short forms or a payload of another
/// length.
std::optional<HeadCommand> decodeHeadCommand(Bytes payload);
std::optional<ChannelGains> decodeGains(Bytes payload);

}  // namespace echotrail::seanet
