#include "core/recording/row_finder.hpp"

#include "core/recording/log_format.hpp"

namespace echotrail {
namespace {

using Bytes = std::span<const std::uint8_t>;

/// SQLite's variable-length integer; takes its bytes off the front. The value is 0 where the bytes end within it: no
/// row has that at a place where it matters.
std::uint64_t takeVarint(Bytes& bytes) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < 9 && i < bytes.size(); ++i) {
        if (i == 8) {
            value = value << 8 | bytes[i];
        } else {
            value = value << 7 | (bytes[i] & 0x7FU);
            if (bytes[i] & 0x80U) continue;
        }
        bytes = bytes.subspan(i + 1);
        return value;
    }
    bytes = {};
    return 0;
}

std::optional<std::size_t> integerBytes(std::uint64_t serial_type) {
    constexpr std::array<std::size_t, 10> sizes{0, 1, 2, 3, 4, 6, 8, 99, 0, 0};
    if (serial_type == 0 || serial_type >= sizes.size() || serial_type == 7) return std::nullopt;
    return sizes[serial_type];
}

/// Big-endian two's complement; the types 8 and 9 are the numbers 0 and 1.
std::int64_t integerOf(std::uint64_t serial_type, Bytes bytes) {
    if (serial_type >= 8) return static_cast<std::int64_t>(serial_type - 8);
    std::uint64_t value = bytes[0] & 0x80U ? ~std::uint64_t{0} : 0;
    for (const std::uint8_t byte : bytes) value = value << 8 | byte;
    return static_cast<std::int64_t>(value);
}

struct Column {
    std::uint64_t type = 0;
    Bytes bytes;
    bool isText() const { return type >= 13 && type % 2 == 1; }
    bool isBlob() const { return type >= 12 && type % 2 == 0; }
    bool isInteger() const { return integerBytes(type).has_value(); }
    std::int64_t integer() const { return integerOf(type, bytes); }
};

constexpr std::size_t most_columns = 8;

/// The columns after the row number, whose own column is empty.
struct Columns {
    std::array<Column, most_columns> all;
    std::size_t count = 0;
};

/// `record` is a header with its own length, and the columns it tells of.
std::optional<Columns> columnsOf(Bytes record) {
    Bytes header = record;
    const std::uint64_t header_bytes = takeVarint(header);
    const bool one_byte = record.size() - header.size() == 1;
    if (!one_byte || header_bytes < 5 || header_bytes >= record.size()) return std::nullopt;
    Bytes body = record.subspan(header_bytes);
    header = header.first(header_bytes - 1);
    if (takeVarint(header) != 0) return std::nullopt;
    Columns columns;
    while (!header.empty()) {
        if (columns.count == most_columns) return std::nullopt;
        Column& column = columns.all[columns.count++];
        column.type = takeVarint(header);
        const auto integer = integerBytes(column.type);
        if (!integer && column.type < 12) return std::nullopt;
        const std::uint64_t size = integer ? *integer : (column.type - 12) / 2;
        if (size > body.size()) return std::nullopt;
        column.bytes = body.first(size);
        body = body.subspan(size);
    }
    if (!body.empty()) return std::nullopt;
    return columns;
}

std::optional<FoundRow> sessionRow(const Columns& columns) {
    const Column &key = columns.all[0], &crc = columns.all[1], &value = columns.all[2];
    if (!key.isText() || !crc.isInteger() || !value.isBlob()) return std::nullopt;
    FoundRow row{.table = FoundRow::Table::Session, .payload = value.bytes};
    row.key = {reinterpret_cast<const char*>(key.bytes.data()), key.bytes.size()};
    if (crc.integer() != std::int64_t{log_format::sessionCrc(row.key, row.payload)}) return std::nullopt;
    return row;
}

/// `numbers` integers, their check sum, the payload.
std::optional<FoundRow> numberedRow(FoundRow::Table table, std::size_t numbers, const Columns& columns) {
    FoundRow row{.table = table};
    for (std::size_t i = 0; i <= numbers; ++i)
        if (!columns.all[i].isInteger()) return std::nullopt;
    if (!columns.all[numbers + 1].isBlob()) return std::nullopt;
    for (std::size_t i = 0; i < numbers; ++i) row.numbers[i] = columns.all[i].integer();
    row.payload = columns.all[numbers + 1].bytes;
    const std::uint32_t crc = log_format::rowCrc(std::span(row.numbers).first(numbers), row.payload);
    if (columns.all[numbers].integer() != std::int64_t{crc}) return std::nullopt;
    return row;
}

}  // namespace

std::optional<FoundRow> rowAt(Bytes bytes) {
    Bytes rest = bytes;
    const std::uint64_t record_bytes = takeVarint(rest);
    if (record_bytes < 6 || record_bytes > longest_row) return std::nullopt;
    const auto number = static_cast<std::int64_t>(takeVarint(rest));
    if (number < 1 || record_bytes > rest.size()) return std::nullopt;
    const auto columns = columnsOf(rest.first(record_bytes));
    if (!columns) return std::nullopt;
    std::optional<FoundRow> row;
    if (columns->count == 3) row = sessionRow(*columns);
    if (columns->count == 4) row = numberedRow(FoundRow::Table::Results, 2, *columns);
    if (columns->count == 8) row = numberedRow(FoundRow::Table::Events, 6, *columns);
    if (!row) return std::nullopt;
    row->row = number;
    row->bytes = (bytes.size() - rest.size()) + record_bytes;
    return row;
}

}  // namespace echotrail
