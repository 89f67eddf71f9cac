#pragma once

#include "core/recording/log_format.hpp"
#include "core/recording/sqlite.hpp"

#include <optional>
#include <string>

/// One part of a log as a file: made, opened, and what stands above its run. For the log's own sources.
namespace echotrail::log_part {

/// Makes an empty part. It has another name until its tables and header are on the disk, so that at no moment a killed
/// process leaves a file that does not open. Fails, saying what to do, where the file exists or cannot be made.
Result<void> make(const std::string& path, const LogHeader& header, int part);

/// With its write-ahead log. `synchronous` as SQLite names it.
Result<sqlite::Database> openToWrite(const std::string& path, std::string_view synchronous);

/// Commits what the write-ahead log holds and leaves one plain file, which can be copied, and opened where nothing may
/// be written; where somebody reads it now it stays two, which open as well.
Result<void> close(sqlite::Database& database);

/// Of a log that nobody in this process writes: changes and makes nothing, in the file or beside it.
Result<sqlite::Database> openToRead(const std::string& path);

/// Whether there is a write-ahead log with something in it.
bool hasWal(const std::string& path);

/// What stands above the run; values whose check sums do not hold are empty.
LogHeader headerOf(sqlite3* database);
/// One value of it.
std::string sessionValue(sqlite3* database, std::string_view key);

/// The first column of the first row; none where there is no row, or on an error. `argument` is ?1, where it is named.
std::optional<std::int64_t> askInteger(sqlite3* database, std::string_view sql, std::int64_t argument = 0);

}  // namespace echotrail::log_part
