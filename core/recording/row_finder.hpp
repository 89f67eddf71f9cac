#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace echotrail {

/// A row of a log, found among bytes. It points into them.
struct FoundRow {
    enum class Table { Session, Events, Results };
    Table table = Table::Events;
    std::int64_t row = 0;
    std::array<std::int64_t, 6> numbers{};  ///< of an event: number, kind, utc, monotonic, chunk, chunks; of a result:
                                            ///< kind, utc
    std::string_view key;                   ///< of the session
    std::span<const std::uint8_t> payload;
    std::size_t bytes = 0;  ///< of the cell, from its first byte
};

/// No row is longer than this: it would not lie whole in its page.
inline constexpr std::size_t longest_row = 16'384;

/// The row whose cell begins with the first of these bytes, if one does and its check sum holds: whatever is wrong with
/// the page, the tree or the file around it. The layout of a cell is that of a "table b-tree leaf cell" in SQLite's
/// file format (sqlite.org/fileformat2.html, 1.6 and 2.1): payload bytes, row number, header bytes and a serial type
/// for every column as variable-length integers, then the columns.
std::optional<FoundRow> rowAt(std::span<const std::uint8_t> bytes);

}  // namespace echotrail
