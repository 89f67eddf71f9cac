#pragma once

#include "core/recording/file_reader.hpp"
#include "core/recording/recording.hpp"
#include "core/seanet/frame_parser.hpp"
#include "core/seanet/head_data.hpp"

#include <deque>

namespace echotrail {

/// The raw byte stream of a head, as a serial server or a logger wrote it. It holds no times: they are rebuilt, each
/// ping following the last by its own duration. Bytes before the first frame belong to a frame that began earlier and
/// are no loss; a frame cut by the end of the file is.
class ByteDump final : public PingSource {
public:
    ByteDump(const std::string& path, std::ifstream file, const RecordingOptions& options);

    std::optional<Ping> next() override;
    void rewind() override;
    const SourceInfo& info() const override { return info_; }
    SourceCounts counts() const override;
    const PoseHistory& navigation() const override { return no_navigation_; }

private:
    void survey();
    void takeFrame(const seanet::Frame& frame);
    void finish();

    FileReader file_;
    SourceInfo info_;
    PoseHistory no_navigation_;
    seanet::FrameParser parser_;
    seanet::HeadDataAssembler assembler_;
    std::deque<seanet::HeadData> lines_;  ///< whole, not yet handed out
    SourceCounts own_counts_;             ///< what the parser and the assembler do not count
    std::uint64_t offset_ = 0;
    std::uint64_t sequence_ = 0;
    Timestamp time_{};
    int node_ = 0;
    std::uint8_t device_ = 0;  ///< type of the head, as its last line tells
    bool finished_ = false;
};

}  // namespace echotrail
