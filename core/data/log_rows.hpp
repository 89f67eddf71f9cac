#pragma once

#include "core/base/time.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// A recording as its rows: what of it goes from one place to another. Layout: core/recording/log_format.hpp.
namespace echotrail {

/// What a log says about its run.
struct LogHeader {
    std::string program_version;
    std::string head;           ///< what the head said of itself, or where it was looked for
    std::string configuration;  ///< TOML of all parameters at the start
    std::uint64_t seed = 0;
    Timestamp started{};
    bool operator==(const LogHeader&) const = default;
};

/// The numbers go over the link: they never change their meaning.
enum class LogTable : std::uint8_t { Events = 0, Results = 1 };
inline constexpr std::array<LogTable, 2> log_tables{LogTable::Events, LogTable::Results};

/// One row as it lies in the log. Rows of a table are numbered from 1 in each part, without a gap.
struct LogRow {
    std::int64_t row = 0;
    std::array<std::int64_t, 6> numbers{};  ///< of an event: number, kind, utc, monotonic, chunk, chunks; of a result:
                                            ///< kind, utc
    std::uint32_t crc = 0;                  ///< over numbers and payload; whoever reads the log checks it
    std::vector<std::uint8_t> payload;
    bool operator==(const LogRow&) const = default;
};

/// How many of LogRow::numbers a table has.
constexpr std::size_t numbersOf(LogTable table) { return table == LogTable::Events ? 6 : 2; }

/// Rows that one part of a log has, by their last numbers.
struct LogExtent {
    std::int64_t events = 0, results = 0;
    std::int64_t& of(LogTable table) { return table == LogTable::Events ? events : results; }
    std::int64_t of(LogTable table) const { return table == LogTable::Events ? events : results; }
    bool operator==(const LogExtent&) const = default;
};

struct LogDescription {
    LogHeader header;
    std::vector<LogExtent> parts;
};

/// Some rows, one after the other: those from `first` to `last`, as far as they fit in so many bytes; at least one.
struct LogRowsWanted {
    int part = 0;
    LogTable table = LogTable::Events;
    std::int64_t first = 1, last = 0;
    std::size_t most_bytes = 0;
    bool operator==(const LogRowsWanted&) const = default;
};

struct LogRows {
    LogTable table = LogTable::Events;
    std::vector<LogRow> rows;
    std::int64_t there = 0;  ///< number of the last row of this table in this part
    int parts = 0;           ///< of the log, by now
};

}  // namespace echotrail
