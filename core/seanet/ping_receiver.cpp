#include "core/seanet/ping_receiver.hpp"

#include "core/seanet/messages.hpp"
#include "core/seanet/ping_decoder.hpp"

#include <algorithm>
#include <cassert>

namespace echotrail::seanet {

void PingReceiver::take(Timestamp arrival, Bytes bytes, const Sink& sink) {
    const bool begun = parser_.unfinishedBytes() > 0;
    if (begun && last_arrival_ && arrival - *last_arrival_ > longest_silence) reset(sink);
    last_arrival_ = arrival;
    reads_.push_back({received_, arrival});
    received_ += bytes.size();
    parser_.take(bytes, [&](const Frame& frame) { takeFrame(frame, sink); });
    while (reads_.size() > 1 && reads_[1].offset + FrameParser::longest_frame < received_) reads_.pop_front();
}

Timestamp PingReceiver::arrivalOf(std::uint64_t offset) const {
    const auto after = std::upper_bound(reads_.begin(), reads_.end(), offset,
                                        [](std::uint64_t o, const Read& read) { return o < read.offset; });
    assert(!reads_.empty());
    return after == reads_.begin() ? after->arrival : std::prev(after)->arrival;
}

void PingReceiver::takeFrame(const Frame& frame, const Sink& sink) {
    if (frame.id() != static_cast<std::uint8_t>(MessageId::HeadData)) {
        ++own_counts_.ignored[messageName(frame.id())];
        return;
    }
    const bool first_packet = (frame.sequence() & 0x7F) == 0;
    if (first_packet) line_began_ = arrivalOf(frame.stream_offset);
    const auto line = assembler_.take(frame);
    if (!line) return;
    Ping ping = pingFrom(*line, sequence_++, line_began_, sound_speed_mps_);
    const double flight_s = ping.bin_interval_s * static_cast<double>(ping.levels.size());
    ping.time = line_began_ - microsecondsFromSeconds(flight_s) - head_latency;
    if (last_ping_) ping.time = std::max(ping.time, *last_ping_ + Microseconds(1));
    last_ping_ = ping.time;
    sink(std::move(ping));
}

bool PingReceiver::giveUp(const Sink& sink) {
    const bool frame = parser_.giveUpUnfinished([&](const Frame& whole) { takeFrame(whole, sink); });
    const bool line = assembler_.giveUpUnfinished();
    return frame || line;
}

void PingReceiver::reset(const Sink& sink) {
    if (!giveUp(sink)) return;
    ++own_counts_.rejected["cut_frame"];
    ++own_counts_.lost_records;
}

void PingReceiver::finish(const Sink& sink) {
    SourceCounts before = counts();
    // What stands in an unfinished frame is looked through for whole ones, but is no fault of the link's.
    if (giveUp(sink)) {
        ++before.ignored["unfinished frame"];
        final_counts_ = std::move(before);
    }
}

SourceCounts PingReceiver::counts() const {
    if (final_counts_) return *final_counts_;
    SourceCounts counts = own_counts_;
    addCounts(counts, parser_, assembler_);
    return counts;
}

}  // namespace echotrail::seanet
