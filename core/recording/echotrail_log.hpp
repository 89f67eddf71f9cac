#pragma once

#include "core/data/source.hpp"
#include "core/recording/log_reader.hpp"
#include "core/recording/ping_feed.hpp"
#include "core/recording/recording.hpp"

#include <memory>
#include <optional>
#include <string>

namespace echotrail {

/// A log of our own as a source: its events go through the same PingFeed as they did in the live run, so that the same
/// pings come out, at the same point of the navigation, with the same controls before them.
/// `info().pings` is 0 where the run was cut off before it could say how many there were.
class EchotrailLog final : public PingSource {
public:
    /// The log is open, and holds at least one ping unless the options allow for none (a run that ended while the head
    /// was still being set up): then it starts and ends when the run started. Else the error says what is wrong.
    static Result<std::unique_ptr<EchotrailLog>> open(const std::string& path, const RecordingOptions& options);

    std::optional<Ping> next() override;
    void rewind() override;
    const SourceInfo& info() const override { return info_; }
    SourceCounts counts() const override;
    const PoseHistory& navigation() const override { return feed_->navigation(); }
    std::vector<RunControl> takeControls() override;
    std::optional<RecordedRun> recordedRun() const override;

    LogReader& reader() { return *reader_; }

private:
    EchotrailLog(std::unique_ptr<LogReader> reader, const RecordingOptions& options);
    void describe(const std::string& path);

    std::unique_ptr<LogReader> reader_;
    RecordingOptions options_;
    std::set<std::uint64_t> skips_;
    std::optional<PingFeed> feed_;
    bool finished_ = false;
    SourceInfo info_;
};

}  // namespace echotrail
