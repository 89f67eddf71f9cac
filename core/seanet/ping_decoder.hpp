#pragma once

#include "core/data/ping.hpp"
#include "core/seanet/head_data.hpp"

namespace echotrail::seanet {

/// A line as a ping. Ranges come from the line's own ADInterval (heads round what they are told), or from range scale
/// and bins where it is 0. 4-bit bins become level (ADLow + ADSpan·v/15), as the head applied both before packing.
/// `transmit` is the instant of transmission.
Ping pingFrom(const HeadData& line, std::uint64_t sequence, Timestamp transmit, double sound_speed_mps);

/// The other way round: a line of 8-bit bins that pingFrom() reads as this ping again, but for its time and number.
/// What a ping does not hold (limits, slope) is made up: a full turn.
HeadData lineFrom(const Ping& ping);

/// Bin levels 0…255 of 80 dB, nearest first; of two 4-bit bins in a byte the high nibble is the nearer.
std::vector<std::uint8_t> levelsOf(const HeadData& line);

double rangeScaleMetres(std::uint16_t range_scale);
/// Hz from the transmit synthesiser word: F = word · 32 MHz / 2³².
double frequencyOf(std::uint32_t transmit_word);

/// How long a ping takes: the water or the serial link (115 200 baud), whichever is slower, as full duplex allows.
double pingDurationSeconds(const HeadData& line, double sound_speed_mps);

}  // namespace echotrail::seanet
