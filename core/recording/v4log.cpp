#include "core/recording/v4log.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>

namespace echotrail {
namespace {

using seanet::Bytes;
using seanet::u16;
using seanet::u32;

constexpr std::size_t header_bytes = 80;
constexpr std::size_t record_header_bytes = 15;  // length, time, nodes, id, sequence, node
constexpr std::size_t longest_record = 4200;     // 1 500 bins and what may be appended
constexpr std::uint8_t head_data = 2;
constexpr std::size_t longest_settings = 1 << 20;
constexpr double days_to_1970 = 25'569.0;  // from the Delphi epoch, 1899-12-30

double f64(Bytes bytes, std::size_t at) {
    const std::uint64_t low = u32(bytes, at), high = u32(bytes, at + 4);
    return std::bit_cast<double>(high << 32 | low);
}

/// Between 1980 and 2080: what is outside is no time of a recording.
bool isPlausibleDate(double days) { return days > 29'221.0 && days < 65'746.0; }

Timestamp timeOf(double days) { return Timestamp(Microseconds(std::llround((days - days_to_1970) * 86'400e6))); }

}  // namespace

V4Log::V4Log(const std::string& path, std::ifstream file, const RecordingOptions& options) : file_(std::move(file)) {
    info_.name = fileName(path);
    info_.format = "Seanet Pro V4LOG";
    readHeader(options);
    survey();
    describeHead();
    rewind();
}

void V4Log::readHeader(const RecordingOptions& options) {
    const Bytes header = file_.read(0, header_bytes);
    first_record_ = records_end_ = file_.size();
    if (header.size() < header_bytes) return;
    promised_records_ = u32(header, 44);
    if (promised_records_ > file_.size() / (record_header_bytes + seanet::head_parameter_bytes))
        promised_records_ = 0;  // more than the file could ever have held: the count itself is damaged
    const std::uint64_t index = u32(header, 56);
    first_record_ = std::clamp<std::uint64_t>(u32(header, 40), header_bytes, file_.size());
    cut_before_index_ = index > file_.size();
    records_end_ = isIndex(index) ? index : file_.size();
    const auto stored = storedSoundSpeed();
    info_.sound_speed_mps = options.sound_speed_mps.value_or(stored.value_or(options.default_sound_speed_mps));
    if (options.sound_speed_mps)
        info_.notes.push_back("speed of sound as given, not as stored in the file");
    else
        info_.notes.push_back(stored ? "speed of sound as stored in the file"
                                     : "the file stores no speed of sound: default");
    info_.notes.push_back("times are the recording PC's clock, taken as UTC");
    info_.notes.push_back("no navigation in the recording: the vehicle is taken to stand still");
}

/// The index tells where each scan record stands, so its first entry leads back to one; an offset of which that is not
/// true is damaged, and believing it would cost every record behind it.
bool V4Log::isIndex(std::uint64_t offset) {
    if (offset < first_record_ || offset > file_.size()) return false;
    const Bytes entry = file_.read(offset, 4);
    if (promised_records_ == 0 || entry.size() < 4) return true;
    const std::uint64_t first = u32(entry, 0);
    return first >= first_record_ && first < offset && plausibleRecord(first);
}

/// The settings are a registry export; the speed of sound is eight hexadecimal bytes of a double under "VOS".
std::optional<double> V4Log::storedSoundSpeed() {
    const auto length =
        static_cast<std::size_t>(std::min<std::uint64_t>(first_record_ - header_bytes, longest_settings));
    const Bytes bytes = file_.read(header_bytes, length);
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    constexpr std::string_view key = "\"VOS\"=hex:";
    const auto at = text.find(key);
    if (at == std::string_view::npos) return std::nullopt;
    const std::string value(text.substr(at + key.size(), 24));
    unsigned b[8];
    if (std::sscanf(value.c_str(), "%2x,%2x,%2x,%2x,%2x,%2x,%2x,%2x", b, b + 1, b + 2, b + 3, b + 4, b + 5, b + 6,
                    b + 7) != 8)
        return std::nullopt;
    std::uint64_t bits = 0;
    for (int i = 7; i >= 0; --i) bits = bits << 8 | b[i];
    const auto speed = std::bit_cast<double>(bits);
    return speed > 1'000 && speed < 2'000 ? std::optional(speed) : std::nullopt;
}

/// A record that could be one: its length could be a record's, its date is a date.
std::optional<V4Log::Record> V4Log::plausibleRecord(std::uint64_t offset) {
    const Bytes head = file_.read(offset, record_header_bytes + seanet::head_parameter_bytes);
    if (head.size() < record_header_bytes) return std::nullopt;
    Record record{offset, u16(head, 0), {}, head[12]};
    const double days = f64(head, 2);
    if (record.length < record_header_bytes || record.length > longest_record || !isPlausibleDate(days))
        return std::nullopt;
    if (record.id == head_data) {
        const std::size_t line = record_header_bytes + seanet::head_parameter_bytes;
        if (head.size() < line || record.length < line + u16(head, line - 2)) return std::nullopt;
        record.length_agrees = record.length == line + u16(head, line - 2);
    }
    record.time = timeOf(days);
    return record;
}

/// A plausible record whose length is to be trusted: a scan line that tells the same length itself, or else a record
/// that ends where another, or nothing, follows.
std::optional<V4Log::Record> V4Log::trustedRecord(std::uint64_t offset) {
    const auto record = plausibleRecord(offset);
    if (!record || record->length_agrees) return record;
    const std::uint64_t after = offset + record->length;
    return after == records_end_ || (after < records_end_ && plausibleRecord(after)) ? record : std::nullopt;
}

void V4Log::lose(const char* cause, std::uint64_t records) {
    counts_.rejected[cause] += records;
    counts_.lost_records += records;
}

/// Goes byte by byte to the next place where a whole record stands.
void V4Log::skipDamage() {
    lose("damaged_record");
    const std::uint64_t from = offset_;
    for (++offset_; offset_ < records_end_; ++offset_) {
        const auto record = trustedRecord(offset_);
        if (record && offset_ + record->length <= records_end_) break;
    }
    counts_.skipped_bytes += offset_ - from;
}

std::optional<V4Log::Record> V4Log::nextRecord() {
    while (offset_ < records_end_) {
        const auto record = trustedRecord(offset_);
        if (!record) {
            if (records_end_ - offset_ < record_header_bytes + seanet::head_parameter_bytes) break;
            skipDamage();
        } else if (offset_ + record->length > records_end_) {
            break;
        } else {
            offset_ += record->length;
            return record;
        }
    }
    finish();
    return std::nullopt;
}

/// At the end: a record that was cut, and scan lines that the header counted but that are not there.
void V4Log::finish() {
    if (finished_) return;
    finished_ = true;
    if (offset_ < records_end_) {
        counts_.skipped_bytes += records_end_ - offset_;
        lose("cut_record");
    }
    const std::uint64_t accounted = scan_records_ + counts_.lost_records;
    if (promised_records_ > accounted)
        lose("missing_record", promised_records_ - accounted);
    else if (cut_before_index_ && counts_.lost_records == 0)
        lose("missing_record");  // cut between two records: at least one is gone
}

/// Earlier than the line before it; or later than the line after it, which itself is not too early: then it is this
/// date that is wrong, and to believe it would cost all lines behind it.
bool V4Log::isOutOfOrder(Timestamp time) {
    if (last_time_ && time < *last_time_) return true;
    const auto following = plausibleRecord(offset_);
    return following && following->time < time && (!last_time_ || following->time >= *last_time_);
}

std::optional<Ping> V4Log::next() {
    while (const auto record = nextRecord()) {
        const bool out_of_order = record->id == head_data && isOutOfOrder(record->time);
        const Bytes payload = file_.read(record->offset + record_header_bytes, record->length - record_header_bytes);
        if (record->id != head_data) {
            ++counts_.ignored[seanet::messageName(record->id)];
            const auto message = seanet::decodeMessage(record->id, payload);
            if (const auto* data = std::get_if<seanet::BBUserData>(&message)) user_data_ = *data;
            continue;
        }
        ++scan_records_;
        const auto line = seanet::decodeHeadData(payload);
        if (!line) {
            lose(line.error().c_str());
            continue;
        }
        if (out_of_order) {
            lose("time_order");
            continue;
        }
        last_time_ = record->time;
        return seanet::pingFrom(*line, sequence_++, record->time, info_.sound_speed_mps);
    }
    return std::nullopt;
}

void V4Log::rewind() {
    offset_ = first_record_;
    sequence_ = scan_records_ = 0;
    last_time_.reset();
    finished_ = false;
    counts_ = {};
}

SourceCounts V4Log::counts() const { return counts_; }

void V4Log::survey() {
    rewind();
    while (const auto ping = next()) {
        if (info_.pings++ == 0) {
            info_.start = ping->time;
            info_.range_scale_m = ping->range_scale_m;
        }
        info_.end = ping->time;
    }
}

void V4Log::describeHead() {
    rewind();
    const auto record = nextRecord();
    if (!record) return;
    const Bytes head = file_.read(record->offset, record_header_bytes);
    const int node = head[10];
    rewind();
    const auto ping = next();
    char text[96];
    std::string kind = "imaging head";
    if (user_data_ && !user_data_->digital())
        kind = "SeaKing " + std::to_string(user_data_->transmit_khz[0]) + "/" +
               std::to_string(user_data_->transmit_khz[1]) + " kHz";
    else if (user_data_)
        kind = user_data_->head_kind == 3 ? "Micron DST" : user_data_->head_kind == 2 ? "SeaPrince DST" : "SeaKing DST";
    std::snprintf(text, sizeof text, "%s, node %d, at %.0f kHz", kind.c_str(), node,
                  ping ? ping->frequency_hz / 1e3 : 0.0);
    info_.head = text;
}

}  // namespace echotrail
