#pragma once

#include "core/recording/file_reader.hpp"
#include "core/recording/recording.hpp"
#include "core/seanet/messages.hpp"
#include "core/seanet/ping_decoder.hpp"

#include <string_view>

namespace echotrail {

/// A log of Tritech's Seanet Pro, version 4 (layout worked out from real files: a header of 80 bytes, settings as
/// registry text, then records of a length, a Delphi date and a message without its frame; an index and a check byte
/// of unknown rule at the end). Records are walked by their own lengths; index and counts are only compared.
/// Its times are the PC's clock, taken as UTC.
class V4Log final : public PingSource {
public:
    static constexpr std::string_view magic = "SeaNetV4 Log File V1";

    V4Log(const std::string& path, std::ifstream file, const RecordingOptions& options);

    std::optional<Ping> next() override;
    void rewind() override;
    const SourceInfo& info() const override { return info_; }
    SourceCounts counts() const override;
    const PoseHistory& navigation() const override { return no_navigation_; }

private:
    struct Record {
        std::uint64_t offset = 0;
        std::size_t length = 0;
        Timestamp time{};
        std::uint8_t id = 0;
        bool length_agrees = false;  ///< with what the scan line itself tells
    };
    void readHeader(const RecordingOptions& options);
    bool isIndex(std::uint64_t offset);
    void survey();
    void describeHead();
    std::optional<Record> plausibleRecord(std::uint64_t offset);
    std::optional<Record> trustedRecord(std::uint64_t offset);
    std::optional<Record> nextRecord();
    bool isOutOfOrder(Timestamp time);
    void skipDamage();
    void finish();
    std::optional<double> storedSoundSpeed();
    void lose(const char* cause, std::uint64_t records = 1);

    FileReader file_;
    SourceInfo info_;
    SourceCounts counts_;
    PoseHistory no_navigation_;
    std::uint64_t first_record_ = 0;
    std::uint64_t records_end_ = 0;       ///< where the header says the index begins, or the end of the file
    bool cut_before_index_ = false;       ///< the file ends before the place where its header says the index begins
    std::uint64_t promised_records_ = 0;  ///< scan records, as the header says
    std::uint64_t offset_ = 0;
    std::uint64_t sequence_ = 0;
    std::uint64_t scan_records_ = 0;
    std::optional<Timestamp> last_time_;
    std::optional<seanet::BBUserData> user_data_;
    bool finished_ = false;
};

}  // namespace echotrail
