#pragma once

#include "core/data/event.hpp"
#include "core/recording/log_format.hpp"
#include "core/recording/sqlite.hpp"

#include <memory>
#include <optional>
#include <string>

namespace echotrail {

struct LogOptions {
    std::uint64_t part_bytes = 1ULL << 30;  ///< a part that has grown to this is closed, and the next one begun
};

/// Writes an .echotrail log (see log_format.hpp).
/// Order:   add and addUpdate as things happen; commit() at least once a second; close() at the end.
/// Promise: write-ahead log with synchronous=FULL. What a commit() that returned had taken is on the disk: neither the
///          end of the process nor of the power loses it, as far as the disk honours fsync. Between commits a killed
///          process loses what it had not committed, and nothing else. (With synchronous=NORMAL a killed process would
///          lose no more, but a loss of power the last commits; with OFF it could cost the file.)
/// Threads: none; one owner calls it.
class LogWriter {
public:
    /// Fails, saying what to do, where the file exists or cannot be made.
    static Result<std::unique_ptr<LogWriter>> create(const std::string& path, const LogHeader& header,
                                                     const LogOptions& options = {});
    ~LogWriter();
    LogWriter(const LogWriter&) = delete;
    LogWriter& operator=(const LogWriter&) = delete;

    Result<void> add(const Event& event);
    /// `text` is one JSON object.
    Result<void> addUpdate(UpdateKind kind, Timestamp time, const std::string& text);
    Result<void> commit();
    /// Commits and leaves one plain file a part, without a write-ahead log beside it.
    Result<void> close();

    const std::string& path() const { return path_; }  ///< of the part being written
    std::uint64_t bytes() const;                       ///< payload so far, all parts

private:
    LogWriter(std::string first_path, LogHeader header, LogOptions options)
        : first_path_(std::move(first_path)), header_(std::move(header)), options_(options) {}
    Result<void> beginPart(int part);
    Result<void> openPart();
    Result<void> closePart();
    Result<void> begin();

    std::string first_path_, path_;
    LogHeader header_;
    LogOptions options_;
    int part_ = -1;
    sqlite::Database database_;
    std::optional<sqlite::Statement> add_event_, add_result_;  // after database_: finalised before it closes
    bool in_transaction_ = false;
    std::uint64_t part_bytes_ = 0, earlier_bytes_ = 0;
};

}  // namespace echotrail
