#pragma once

#include "core/seanet/bytes.hpp"

#include <array>
#include <cstdint>
#include <vector>

/// What a simulated SeaKing says of itself: payloads by the Tritech DigSon notes, with the values of captured heads.
namespace echotrail {

/// Middles of the bands of its channels.
inline constexpr std::array<std::uint32_t, 2> head_channel_hz{325'000, 675'000};

/// Of mtVersionData, 11 bytes. Digital heads tell no serial number.
std::vector<std::uint8_t> versionPayload(bool digital, int serial_number, std::uint8_t node);

/// Of mtBBUserData, 250 bytes.
std::vector<std::uint8_t> blockPayload(bool digital, bool half_duplex);

}  // namespace echotrail
