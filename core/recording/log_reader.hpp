#pragma once

#include "core/data/event.hpp"
#include "core/recording/log_format.hpp"
#include "core/recording/sqlite.hpp"

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace echotrail {

/// What of a log was not as it was written.
struct LogCounts {
    std::uint64_t damaged_rows = 0;    ///< their check sum does not hold
    std::uint64_t missing_events = 0;  ///< by their numbers
    std::uint64_t missing_parts = 0;
    std::string unreadable;  ///< why reading ended early; empty where it did not
    bool any() const { return damaged_rows || missing_events || missing_parts || !unreadable.empty(); }
};

/// A row of what the tracker found.
struct LogResult {
    UpdateKind kind = UpdateKind::Track;
    Timestamp time{};
    std::string text;
    bool operator==(const LogResult&) const = default;
};

/// Reads an .echotrail log, all its parts in order, whichever of them is named. Nothing is loaded that is not asked
/// for. Nothing is changed or made, in the log or beside it; of one that was not closed, or is being written, the
/// write-ahead log is read too.
/// Threads: none; one owner calls it.
class LogReader {
public:
    /// Whether the file says that it is one.
    static bool isLog(std::string_view first_bytes);
    static Result<std::unique_ptr<LogReader>> open(const std::string& path);

    const LogHeader& header() const { return header_; }
    int parts() const { return static_cast<int>(parts_.size()); }
    std::optional<Timestamp> start() const { return start_; }  ///< of the first event
    std::optional<Timestamp> end() const { return end_; }      ///< of the last
    std::uint64_t events() const { return events_; }           ///< by the last one's number
    bool closed() const { return closed_; }                    ///< else: the run that wrote it was cut off, or goes on

    /// The next whole event; none at the end.
    std::optional<Event> next();
    /// The next one is the first at or after `time`; where the clock was set back, one of those.
    void seek(Timestamp time);
    void rewind();
    const LogCounts& counts() const { return counts_; }  ///< since the last rewind or seek

    /// The next row of the tracker's results, of a cursor of its own.
    std::optional<LogResult> nextResult();
    void rewindResults();
    /// The last summary; empty where the run had no time to write it.
    std::string summary();
    /// Sequence numbers of the pings that the tracker could not take in time.
    Result<std::set<std::uint64_t>> skips();

private:
    struct Part {
        std::string path;
        sqlite::Database database;
    };
    struct Cursor {
        std::size_t part = 0;
        std::optional<sqlite::Statement> rows;
    };
    Result<void> openParts(const std::string& path);
    void readExtent();
    bool step(Cursor& cursor, std::string_view sql, std::int64_t after);
    bool checkRow(std::span<const std::int64_t> numbers, std::int64_t crc, std::span<const std::uint8_t> payload);

    std::vector<Part> parts_;
    LogHeader header_;
    bool closed_ = true;
    std::optional<Timestamp> start_, end_;
    std::uint64_t events_ = 0;
    Cursor event_cursor_, result_cursor_;           // after parts_: their statements end before the databases close
    std::int64_t after_row_ = 0;                    ///< where the event cursor begins in its part
    std::optional<std::uint64_t> expected_number_;  ///< of the next event; unknown after a seek
    LogCounts counts_;
    std::uint64_t missing_parts_ = 0;
};

}  // namespace echotrail
