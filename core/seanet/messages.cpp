#include "core/seanet/messages.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace echotrail::seanet {
namespace {

constexpr std::size_t payload_offset = 13;  // of the payload in a frame: the notes count from the frame's start

VersionData decodeVersion(Bytes p) { return {u8(p, 0), u8(p, 1), u16(p, 2), u32(p, 4), u16(p, 8), u8(p, 10)}; }

Alive decodeAlive(Bytes p) { return {u8(p, 0), u32(p, 1), u16(p, 5), u8(p, 7)}; }

DigitalChannel decodeChannel(Bytes p, std::size_t wire) {
    const std::size_t at = wire - payload_offset;
    return {u32(p, at),      u32(p, at + 4),  u32(p, at + 8),  u32(p, at + 12),
            u32(p, at + 29), u32(p, at + 33), u32(p, at + 37), u8(p, at + 41)};
}

BBUserData decodeBBUser(Bytes p) {
    const auto word = [&](std::size_t wire) { return u16(p, wire - payload_offset); };
    const auto byte = [&](std::size_t wire) { return u8(p, wire - payload_offset); };
    BBUserData data;
    data.surface_node = byte(13);
    data.magic = word(15);
    data.length = word(17);
    data.board_type = byte(19);
    data.software_version = byte(20);
    data.main_port_low = word(35);
    data.main_port_high = word(37);
    if (data.digital()) {
        data.head_kind = byte(59);
        data.channel[0] = decodeChannel(p, 60);
        data.channel[1] = decodeChannel(p, 103);
        data.half_duplex = byte(146) != 0;
        data.has_motor = byte(147) != 0;
        data.pan_constant = word(150);
        data.pan_speed = word(152);
    } else {
        data.has_motor = word(59) != 0;
        data.half_duplex = word(99) != 0;
        for (std::size_t channel = 0; channel < 2; ++channel) {
            data.transmit_khz[channel] = word(101 + 2 * channel);
            data.receive_khz[channel] = word(105 + 2 * channel);
            data.slope[channel] = word(109 + 2 * channel);
        }
        data.pan_constant = word(123);
        data.pan_speed = word(125);
    }
    return data;
}

}  // namespace

std::string messageName(std::uint8_t id) {
    constexpr std::array<std::pair<std::uint8_t, std::string_view>, 14> names{{
        {1, "mtVersionData"},
        {2, "mtHeadData"},
        {4, "mtAlive"},
        {6, "mtBBUserData"},
        {8, "mtAuxData"},
        {13, "mtLanStatus"},
        {16, "mtReBoot"},
        {19, "mtHeadCommand"},
        {23, "mtSendVersion"},
        {24, "mtSendBBUser"},
        {25, "mtSendData"},
        {57, "mtFpgaVersionData"},
        {63, "mtFpgaCalibrationData"},
        {66, "mtStopAlives"},
    }};
    const auto found = std::find_if(names.begin(), names.end(), [id](const auto& entry) { return entry.first == id; });
    return found != names.end() ? std::string(found->second) : "message " + std::to_string(id);
}

Message decodeMessage(const Frame& frame) { return decodeMessage(frame.id(), frame.payload()); }

Message decodeMessage(std::uint8_t id, Bytes payload) {
    constexpr std::size_t shortest_bbuser = 175 - 14;  // frames of 175 and of 264 bytes are known
    const auto atLeast = [&](std::size_t bytes) { return payload.size() >= bytes; };
    switch (MessageId{id}) {
        case MessageId::VersionData:
            if (atLeast(11)) return decodeVersion(payload);
            break;
        case MessageId::Alive:
            if (atLeast(8)) return decodeAlive(payload);
            break;
        case MessageId::BBUserData:
            if (atLeast(shortest_bbuser)) return decodeBBUser(payload);
            break;
        case MessageId::AuxData:
            if (atLeast(2)) {
                const std::size_t length = std::min<std::size_t>(u16(payload, 0), payload.size() - 2);
                const Bytes text = payload.subspan(2, length);
                return AuxData{std::string(text.begin(), text.end())};
            }
            break;
        case MessageId::FpgaVersionData:
            if (atLeast(14)) return FpgaVersionData{u8(payload, 0), u32(payload, 1), u8(payload, 9), u32(payload, 10)};
            break;
        case MessageId::FpgaCalibrationData:
            return FpgaCalibrationData{{payload.begin(), payload.end()}};
        default:
            return OtherMessage{id, false};
    }
    return OtherMessage{id, true};
}

}  // namespace echotrail::seanet
