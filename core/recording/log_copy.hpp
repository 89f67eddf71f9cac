#pragma once

#include "core/base/result.hpp"
#include "core/data/log_rows.hpp"
#include "core/recording/row_ranges.hpp"
#include "core/recording/sqlite.hpp"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace echotrail {

/// A copy of a log that lies elsewhere: a log itself, whose rows have the numbers that they have there, and come in any
/// order. While some are missing before others, table `held` (kind, first, last) of a part says which there are; a part
/// without it holds every row up to its last.
/// Order:   add() as rows come; commit() at least once a second; close() at the end.
/// Promise: what a commit() that returned had taken survives the end of the process. A loss of power may cost the last
///          commits, but never the file: rows and what is said of them go together, and what is missing is fetched
///          again.
/// Threads: none; one owner calls it.
class LogCopy {
public:
    /// Opens the copy of this run, or makes it. Fails where the file is of another run, or no log.
    static Result<std::unique_ptr<LogCopy>> open(const std::string& path, const LogHeader& header);
    /// Whether the file is a log of this run.
    static bool isOf(const std::string& path, const LogHeader& header);
    ~LogCopy();
    LogCopy(const LogCopy&) = delete;
    LogCopy& operator=(const LogCopy&) = delete;

    /// Rows of `wanted`, all from its first to the last that is given; those there already stay as they are.
    Result<void> add(const LogRowsWanted& wanted, const std::vector<LogRow>& rows);
    /// The rows of `wanted` are nowhere: they count as if they were here.
    void passOver(const LogRowsWanted& wanted) { held_[{wanted.part, wanted.table}].add(wanted.first, wanted.last); }
    Result<void> commit();
    Result<void> close();

    const RowRanges& held(int part, LogTable table) { return held_[{part, table}]; }
    const std::string& path() const { return path_; }
    std::uint64_t bytes() const { return bytes_; }  ///< payload taken since it was opened

private:
    LogCopy(std::string path, LogHeader header) : path_(std::move(path)), header_(std::move(header)) {}
    Result<void> readHeld();
    Result<void> usePart(int part);
    Result<void> writeHeld();

    std::string path_;
    LogHeader header_;
    std::map<std::pair<int, LogTable>, RowRanges> held_;
    int part_ = -1;  ///< that is open
    sqlite::Database database_;
    std::map<LogTable, sqlite::Statement> insert_;  // after database_: finalised before it closes
    bool in_transaction_ = false;
    std::uint64_t bytes_ = 0;
};

}  // namespace echotrail
