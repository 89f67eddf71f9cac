#include "core/recording/byte_dump.hpp"

#include "core/seanet/messages.hpp"
#include "core/seanet/ping_decoder.hpp"

#include <cstdio>

namespace echotrail {
namespace {

constexpr std::size_t chunk_bytes = 1 << 16;
constexpr std::uint8_t head_data = 2, digital_head = 0x11;

}  // namespace

ByteDump::ByteDump(const std::string& path, std::ifstream file, const RecordingOptions& options)
    : file_(std::move(file)) {
    info_.name = fileName(path);
    info_.format = "raw Seanet byte stream";
    info_.sound_speed_mps = options.sound_speed_mps.value_or(options.default_sound_speed_mps);
    info_.notes = {"times are rebuilt from each ping's own duration, beginning at 1970-01-01T00:00:00Z",
                   options.sound_speed_mps ? "speed of sound as given" : "the stream holds no speed of sound: default",
                   "no navigation in the recording: the vehicle is taken to stand still"};
    survey();
    rewind();
}

void ByteDump::takeFrame(const seanet::Frame& frame) {
    if (frame.id() != head_data) {
        ++own_counts_.ignored[seanet::messageName(frame.id())];
        return;
    }
    node_ = frame.source();
    if (auto line = assembler_.take(frame)) {
        device_ = line->device_type;
        lines_.push_back(std::move(*line));
    }
}

/// A file that ends inside a frame, or inside a line of several frames, lost that line.
void ByteDump::finish() {
    if (finished_) return;
    finished_ = true;
    const auto sink = [this](const seanet::Frame& frame) { takeFrame(frame); };
    const bool cut = parser_.giveUpUnfinished(sink);
    if (assembler_.giveUpUnfinished() || cut) {
        ++own_counts_.rejected["cut_frame"];
        ++own_counts_.lost_records;
    }
}

std::optional<Ping> ByteDump::next() {
    while (lines_.empty()) {
        const seanet::Bytes chunk = file_.read(offset_, chunk_bytes);
        if (chunk.empty()) {
            finish();
            if (lines_.empty()) return std::nullopt;
            break;
        }
        offset_ += chunk.size();
        parser_.take(chunk, [this](const seanet::Frame& frame) { takeFrame(frame); });
    }
    const seanet::HeadData line = std::move(lines_.front());
    lines_.pop_front();
    Ping ping = seanet::pingFrom(line, sequence_++, time_, info_.sound_speed_mps);
    time_ += microsecondsFromSeconds(seanet::pingDurationSeconds(line, info_.sound_speed_mps));
    return ping;
}

void ByteDump::rewind() {
    parser_ = {};
    assembler_ = {};
    lines_.clear();
    own_counts_ = {};
    offset_ = sequence_ = 0;
    time_ = {};
    finished_ = false;
}

SourceCounts ByteDump::counts() const {
    SourceCounts counts = own_counts_;
    seanet::addCounts(counts, parser_, assembler_);
    return counts;
}

void ByteDump::survey() {
    double frequency = 0;
    rewind();
    while (const auto ping = next()) {
        if (info_.pings++ == 0) {
            info_.start = ping->time;
            info_.range_scale_m = ping->range_scale_m;
            frequency = ping->frequency_hz;
        }
        info_.end = ping->time;
    }
    char text[96];
    std::snprintf(text, sizeof text, "%s head, node %d, at %.0f kHz", device_ == digital_head ? "digital" : "imaging",
                  node_, frequency / 1e3);
    info_.head = text;
}

}  // namespace echotrail
