#pragma once

#include "core/base/result.hpp"
#include "core/data/source.hpp"
#include "core/seanet/frame_parser.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace echotrail::seanet {

/// One scan line, mtHeadData: raw wire values. Layout: Tritech DigSon notes; ADSpan comes before ADLow.
struct HeadData {
    std::uint16_t total = 0;       ///< bytes of parameters and data: 31 + data_bytes
    std::uint8_t device_type = 0;  ///< 2 imaging, 0x11 digital
    std::uint8_t status = 0;
    std::uint8_t sweep_code = 0;  ///< 1 left limit, 2 right limit, 5 centre; many heads never set it
    std::uint16_t head_control = 0;
    std::uint16_t range_scale = 0;  ///< bits 0–13 tenths, bits 14–15 unit: m, ft, fathom, yd
    std::uint32_t transmit_word = 0;
    std::uint8_t gain = 0;  ///< 210 is 100 %
    std::uint16_t slope = 0;
    std::uint8_t ad_span = 0, ad_low = 0;
    std::uint16_t heading_offset = 0;
    std::uint16_t ad_interval = 0;                  ///< bin period, 640 ns; 0 where the head does not tell
    std::uint16_t left_limit = 0, right_limit = 0;  ///< 1/16 gradian
    std::uint8_t step = 0;
    std::uint16_t bearing = 0;  ///< 1/16 gradian, 3200 is ahead
    std::uint16_t data_bytes = 0;
    std::vector<std::uint8_t> data;
    std::vector<std::uint8_t> extra;  ///< appended after the data (status bit 7); format not published

    bool eightBit() const { return head_control & 0x0001; }
    bool clockwise() const { return head_control & 0x0004; }
    bool secondChannel() const { return head_control & 0x0080; }
    bool wasReset() const { return status & 0x01; }
    bool motorLostSync() const { return status & 0x02; }
    std::size_t bins() const { return eightBit() ? data.size() : 2 * data.size(); }
    bool operator==(const HeadData&) const = default;
};

inline constexpr std::size_t head_parameter_bytes = 31;

/// Parameters and data of a whole line from its payload (from `total` on). Fails where the redundant counts do not
/// agree or data are missing; the message is the cause, one word.
Result<HeadData> decodeHeadData(Bytes payload);

/// The payload that decodeHeadData reads back; total and data_bytes are worked out from the data.
std::vector<std::uint8_t> encodeHeadPayload(const HeadData& line);
/// A single-packet frame from `node` to the host.
std::vector<std::uint8_t> encodeHeadData(const HeadData& line, std::uint8_t node = 2);

/// Puts lines together from frames: a line in one frame, or in several of at most some 130 bytes each. A gap in the
/// sequence, or a new line before the old was whole, discards the old one.
/// State: the packets of one unfinished line; counts.
class HeadDataAssembler {
public:
    /// A whole line, where this frame completes one.
    std::optional<HeadData> take(const Frame& frame);
    /// Discards an unfinished line; true if there was one. The caller counts it: rejected() does not.
    bool giveUpUnfinished();
    /// Cause → lines that were lost.
    const std::map<std::string, std::uint64_t>& rejected() const { return rejected_; }

private:
    std::optional<HeadData> whole(Bytes payload);
    std::vector<std::uint8_t> payload_;   ///< of the packets so far, joined
    static constexpr int lost_line = -1;  ///< until the next line begins, as at the start of a stream
    int next_packet_ = lost_line;         ///< 0: between lines
    std::map<std::string, std::uint64_t> rejected_;
};

/// Adds what parser and assembler have refused. Lost are the lines that the assembler knows of, and one for every
/// damaged stretch.
void addCounts(SourceCounts& counts, const FrameParser& parser, const HeadDataAssembler& assembler);

}  // namespace echotrail::seanet
