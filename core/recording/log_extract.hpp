#pragma once

#include "core/base/result.hpp"
#include "core/data/log_rows.hpp"

#include <string>

/// A recording for somebody far away, row by row as it lies there. Nothing is kept open in between, so that whoever
/// writes the log is never in the way of being read, nor reading of it.
namespace echotrail {

/// Whether somebody in this process writes the log: it is read beside him, by SQLite's own locks. Else nothing is made
/// or changed, in the log or beside it.
enum class LogUse { Written, Resting };

/// What stands above the run, and how many rows there are by now. `path` is that of the first part.
Result<LogDescription> describeLog(const std::string& path, LogUse use);

/// Rows are read by their numbers: it costs the same wherever in the log they lie.
Result<LogRows> readLogRows(const std::string& path, LogUse use, const LogRowsWanted& wanted);

}  // namespace echotrail
