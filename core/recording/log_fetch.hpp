#pragma once

#include "core/recording/log_copy.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace echotrail {

/// Decides which rows of a recording that lies elsewhere are fetched next, and keeps them in a copy here, until that is
/// whole. Of what goes on there, results come only when the events are here that were there at the time: a copy that is
/// cut off looks like a run that was.
/// Order: next(), and take() with what came for it.
class LogFetch {
public:
    struct Progress {
        std::int64_t rows = 0;    ///< that are here
        std::int64_t there = 0;   ///< as far as is known
        std::int64_t missed = 0;  ///< of those since the copy was begun: the others are older
    };
    /// `newest_first`: of a run that goes on, what has come since the copy was begun comes before what was there then.
    LogFetch(std::unique_ptr<LogCopy> copy, const LogDescription& there, bool newest_first);

    /// None where all that is known to be there is here.
    std::optional<LogRowsWanted> next(std::size_t most_bytes);
    /// Asks whether there is more by now: first how far the results are, then for events.
    LogRowsWanted lookForMore(std::size_t most_bytes);
    /// Fails where the copy cannot be written; rows that were not asked for are an error, too.
    Result<void> take(const LogRowsWanted& wanted, const LogRows& rows);
    Progress progress() const;
    LogCopy& copy() { return *copy_; }

private:
    struct Part {
        LogExtent there;
        LogExtent begins{1, 1};                     ///< rows from here on come first
        std::array<bool, 2> settled{false, false};  ///< by table: no row is added any more
        std::int64_t results_seen = 0;              ///< that may be fetched once the events have been asked for
    };
    std::optional<LogRowsWanted> missingFrom(bool the_newer, std::size_t most_bytes);

    std::unique_ptr<LogCopy> copy_;
    std::vector<Part> parts_;
    LogTable turn_ = LogTable::Results;
};

}  // namespace echotrail
