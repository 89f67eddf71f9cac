#include "core/seanet/head_data.hpp"

#include <utility>

namespace echotrail::seanet {

Result<HeadData> decodeHeadData(Bytes p) {
    if (p.size() < head_parameter_bytes) return Error{"short_line"};
    HeadData line;
    line.total = u16(p, 0);
    line.device_type = u8(p, 2);
    line.status = u8(p, 3);
    line.sweep_code = u8(p, 4);
    line.head_control = u16(p, 5);
    line.range_scale = u16(p, 7);
    line.transmit_word = u32(p, 9);
    line.gain = u8(p, 13);
    line.slope = u16(p, 14);
    line.ad_span = u8(p, 16);
    line.ad_low = u8(p, 17);
    line.heading_offset = u16(p, 18);
    line.ad_interval = u16(p, 20);
    line.left_limit = u16(p, 22);
    line.right_limit = u16(p, 24);
    line.step = u8(p, 26);
    line.bearing = u16(p, 27);
    line.data_bytes = u16(p, 29);
    if (line.total != head_parameter_bytes + line.data_bytes) return Error{"counts_differ"};
    if (p.size() < head_parameter_bytes + line.data_bytes) return Error{"short_line"};
    if (line.bearing >= 6400) return Error{"bad_bearing"};
    const Bytes data = p.subspan(head_parameter_bytes);
    line.data.assign(data.begin(), data.begin() + line.data_bytes);
    line.extra.assign(data.begin() + line.data_bytes, data.end());
    return line;
}

std::vector<std::uint8_t> encodeHeadPayload(const HeadData& line) {
    const auto bytes = static_cast<unsigned>(line.data.size());
    ByteWriter out;
    out.u16(head_parameter_bytes + bytes).u8(line.device_type).u8(line.status).u8(line.sweep_code);
    out.u16(line.head_control).u16(line.range_scale).u32(line.transmit_word).u8(line.gain).u16(line.slope);
    out.u8(line.ad_span).u8(line.ad_low).u16(line.heading_offset).u16(line.ad_interval);
    out.u16(line.left_limit).u16(line.right_limit).u8(line.step).u16(line.bearing).u16(bytes);
    return out.raw(line.data).raw(line.extra).bytes();
}

std::vector<std::uint8_t> encodeHeadData(const HeadData& line, std::uint8_t node) {
    constexpr std::uint8_t host = 255, head_data = 2, single = 0x80;
    return makeFrame(node, host, head_data, single, node, encodeHeadPayload(line), true);
}

std::optional<HeadData> HeadDataAssembler::whole(Bytes payload) {
    auto line = decodeHeadData(payload);
    if (line) return std::move(*line);
    ++rejected_[line.error()];
    return std::nullopt;
}

std::optional<HeadData> HeadDataAssembler::take(const Frame& frame) {
    const int packet = frame.sequence() & 0x7F;
    const bool last = frame.sequence() & 0x80;
    if (packet == 0) {
        if (giveUpUnfinished()) ++rejected_["unfinished_line"];
        next_packet_ = 0;
        if (last) return whole(frame.payload());
    } else if (packet != next_packet_) {
        // Counted once: what else comes of the same line is no further loss.
        if (next_packet_ != lost_line) ++rejected_["packet_gap"];
        payload_.clear();
        next_packet_ = last ? 0 : lost_line;
        return std::nullopt;
    }
    const Bytes payload = frame.payload();
    payload_.insert(payload_.end(), payload.begin(), payload.end());
    next_packet_ = last ? 0 : packet + 1;
    if (!last) return std::nullopt;
    return whole(std::exchange(payload_, {}));
}

bool HeadDataAssembler::giveUpUnfinished() {
    const bool begun = next_packet_ > 0;
    payload_.clear();
    if (begun) next_packet_ = lost_line;
    return begun;
}

void addCounts(SourceCounts& counts, const FrameParser& parser, const HeadDataAssembler& assembler) {
    counts.skipped_bytes += parser.skippedBytes();
    for (const auto& [cause, number] : parser.rejected()) counts.rejected[cause] += number;
    for (const auto& [cause, number] : assembler.rejected()) {
        counts.rejected[cause] += number;
        counts.lost_records += number;
    }
    counts.lost_records += parser.damagedStretches();
}

}  // namespace echotrail::seanet
