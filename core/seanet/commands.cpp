#include "core/seanet/commands.hpp"

namespace echotrail::seanet {
namespace {

constexpr std::uint8_t host = 255;
constexpr std::uint8_t single = 0x80;
constexpr std::uint8_t id_reboot = 16, id_head_command = 19, id_send_version = 23, id_send_bbuser = 24,
                       id_send_data = 25, id_stop_alives = 66;
constexpr std::uint8_t type_parameters = 1, type_reverse = 15, type_dual = 29, type_gains = 30;
constexpr std::size_t parameter_bytes = 52, gain_bytes = 16;

FrameBytes command(std::uint8_t id, std::uint8_t node, Bytes payload = {}) {
    return makeFrame(host, node, id, single, node, payload);
}

void writeGains(ByteWriter& out, const ChannelGains& gains) {
    for (const auto& pair : {gains.ad_span, gains.ad_low, gains.gain, gains.set_point}) out.u8(pair[0]).u8(pair[1]);
    for (const auto& pair : {gains.slope, gains.slope_delay}) out.u16(pair[0]).u16(pair[1]);
}

ChannelGains readGains(Bytes p) {
    const auto bytes = [&](std::size_t at) { return std::array<std::uint8_t, 2>{u8(p, at), u8(p, at + 1)}; };
    const auto words = [&](std::size_t at) { return std::array<std::uint16_t, 2>{u16(p, at), u16(p, at + 2)}; };
    return {bytes(0), bytes(2), bytes(4), bytes(6), words(8), words(12)};
}

}  // namespace

FrameBytes encodeSendVersion(std::uint8_t node) { return command(id_send_version, node); }
FrameBytes encodeSendBBUser(std::uint8_t node) { return command(id_send_bbuser, node); }
FrameBytes encodeReBoot(std::uint8_t node) { return command(id_reboot, node); }
FrameBytes encodeStopAlives(std::uint8_t node) { return command(id_stop_alives, node); }

FrameBytes encodeSendData(std::uint32_t time_ms, std::uint8_t node) {
    return command(id_send_data, node, ByteWriter().u32(time_ms).bytes());
}

FrameBytes encodeHeadCommand(const HeadCommand& c, std::uint8_t node) {
    ByteWriter out;
    out.u8(c.channels ? type_dual : type_parameters).u16(c.head_control).u8(c.head_type);
    out.u32(c.transmit_word[0]).u32(c.transmit_word[1]).u32(c.receive_word[0]).u32(c.receive_word[1]);
    out.u16(c.pulse_us).u16(c.range_scale).u16(c.left_limit).u16(c.right_limit).u8(c.ad_span).u8(c.ad_low);
    out.u8(c.gain[0]).u8(c.gain[1]).u16(c.slope[0]).u16(c.slope[1]).u8(c.motor_time).u8(c.step);
    out.u16(c.ad_interval).u16(c.bins).u16(c.max_buffer).u16(c.lockout_us).u16(c.minor_axis);
    out.u8(c.major_axis).u8(c.control2).u16(c.scan_z);
    if (c.channels) writeGains(out, *c.channels);
    return command(id_head_command, node, out.bytes());
}

FrameBytes encodeGains(const ChannelGains& gains, std::uint8_t node) {
    ByteWriter out;
    out.u8(type_gains);
    writeGains(out, gains);
    return command(id_head_command, node, out.bytes());
}

FrameBytes encodeReverseScan(std::uint8_t node) {
    return command(id_head_command, node, ByteWriter().u8(type_reverse).bytes());
}

std::optional<HeadCommand> decodeHeadCommand(Bytes p) {
    const bool dual = p.size() == parameter_bytes + gain_bytes && p[0] == type_dual;
    if (!dual && !(p.size() == parameter_bytes && p[0] == type_parameters)) return std::nullopt;
    HeadCommand c;
    c.head_control = u16(p, 1);
    c.head_type = u8(p, 3);
    c.transmit_word = {u32(p, 4), u32(p, 8)};
    c.receive_word = {u32(p, 12), u32(p, 16)};
    c.pulse_us = u16(p, 20);
    c.range_scale = u16(p, 22);
    c.left_limit = u16(p, 24);
    c.right_limit = u16(p, 26);
    c.ad_span = u8(p, 28);
    c.ad_low = u8(p, 29);
    c.gain = {u8(p, 30), u8(p, 31)};
    c.slope = {u16(p, 32), u16(p, 34)};
    c.motor_time = u8(p, 36);
    c.step = u8(p, 37);
    c.ad_interval = u16(p, 38);
    c.bins = u16(p, 40);
    c.max_buffer = u16(p, 42);
    c.lockout_us = u16(p, 44);
    c.minor_axis = u16(p, 46);
    c.major_axis = u8(p, 48);
    c.control2 = u8(p, 49);
    c.scan_z = u16(p, 50);
    if (dual) c.channels = readGains(p.subspan(parameter_bytes));
    return c;
}

std::optional<ChannelGains> decodeGains(Bytes p) {
    if (p.size() != 1 + gain_bytes || p[0] != type_gains) return std::nullopt;
    return readGains(p.subspan(1));
}

}  // namespace echotrail::seanet
