#pragma once

#include "core/base/result.hpp"

#include <cstdint>
#include <string>

namespace echotrail {

/// What recover() found.
struct RecoveryCounts {
    std::uint64_t parts = 0;           ///< files of rows that were gone through, without their write-ahead logs
    std::uint64_t events = 0;          ///< whole ones, now in the new log
    std::uint64_t missing_events = 0;  ///< by their numbers, up to the last one found
    std::uint64_t results = 0;
    bool header_found = false;  ///< else the new log has none: no seed, no configuration
    bool cut = false;           ///< a file is shorter than it should be: what followed cannot be known
    bool was_readable = false;  ///< the log opens and reads as it is, and nothing is missing: no need to recover
    /// Whether the new log holds all that the run committed; else exit code 3.
    bool whole() const { return was_readable && header_found && !cut && missing_events == 0; }
};

/// Writes to a new log `out_path` every row of a damaged or cut log whose check sum holds, from all its parts and their
/// write-ahead logs. Neither the order of the files nor SQLite's pages are trusted: every byte is looked at for the
/// beginning of a row. An event of several rows needs them all. Memory: 24 bytes a row; the rows stay on the disk.
/// Fails, in one line, where the file is no log at all or `out_path` exists or cannot be written.
Result<RecoveryCounts> recover(const std::string& in_path, const std::string& out_path);

}  // namespace echotrail
