#include "core/recording/log_reader.hpp"

#include <array>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace echotrail {
namespace {

constexpr std::string_view event_rows =
    "SELECT number, kind, utc_us, monotonic_us, chunk, chunks, crc, payload FROM events WHERE row > ?1 ORDER BY row";
constexpr std::string_view result_rows = "SELECT kind, utc_us, crc, payload FROM results WHERE row > ?1 ORDER BY row";

Timestamp timestamp(std::int64_t microseconds) { return Timestamp(Microseconds(microseconds)); }

/// SQLite's name for a file, with the characters escaped that mean something in a URI.
std::string uriOf(const std::string& path, std::string_view query) {
    constexpr char digits[] = "0123456789ABCDEF";
    std::string uri = "file:";
    for (const char c : std::filesystem::absolute(path).string()) {
        if (c == '%' || c == '?' || c == '#') {
            const auto byte = static_cast<unsigned char>(c);
            uri += {'%', digits[byte >> 4], digits[byte & 15]};
        } else {
            uri += c;
        }
    }
    return uri + std::string(query);
}

bool holdsBytes(const std::string& path) {
    std::error_code failure;
    const auto size = std::filesystem::file_size(path, failure);
    return !failure && size > 0;
}

/// A log without a write-ahead log beside it is opened as what cannot change: then nothing is made beside it, and a
/// medium that cannot be written will do.
Result<sqlite::Database> openPart(const std::string& path) {
    const bool has_wal = holdsBytes(path + "-wal");
    constexpr int flags = SQLITE_OPEN_READONLY | SQLITE_OPEN_URI;
    auto opened = sqlite::open(uriOf(path, has_wal ? "?mode=ro" : "?mode=ro&immutable=1"), flags);
    if (!opened) return Error{"cannot open " + path + ": " + opened.error()};
    return opened;
}

std::optional<std::int64_t> askInteger(sqlite3* database, std::string_view sql, std::int64_t argument = 0) {
    auto statement = sqlite::Statement::prepare(database, sql);
    if (!statement) return std::nullopt;
    if (sql.find("?1") != std::string_view::npos) statement->bind(1, argument);
    const auto row = statement->step();
    if (!row || !*row) return std::nullopt;
    return statement->integer(0);
}

std::string askText(sqlite3* database, std::string_view sql) {
    auto statement = sqlite::Statement::prepare(database, sql);
    if (!statement) return {};
    const auto row = statement->step();
    return row && *row ? statement->text(0) : std::string();
}

std::int64_t number(const std::string& text) {
    std::int64_t value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

}  // namespace

bool LogReader::isLog(std::string_view first_bytes) {
    constexpr std::size_t id_at = 68;  // application_id in SQLite's file header, big-endian
    if (first_bytes.size() < id_at + 4 || !first_bytes.starts_with("SQLite format 3")) return false;
    std::uint32_t id = 0;
    for (std::size_t i = 0; i < 4; ++i) id = id << 8 | static_cast<unsigned char>(first_bytes[id_at + i]);
    return id == static_cast<std::uint32_t>(log_format::application_id);
}

Result<std::unique_ptr<LogReader>> LogReader::open(const std::string& path) {
    std::unique_ptr<LogReader> reader(new LogReader);
    if (auto opened = reader->openParts(path); !opened) return Error{opened.error()};
    reader->readExtent();
    reader->rewind();
    return reader;
}

Result<void> LogReader::openParts(const std::string& path) {
    auto opened = openPart(path);
    if (!opened) return Error{opened.error()};
    sqlite3* named = opened->get();
    const auto version = askInteger(named, "PRAGMA user_version");
    const std::string part_text = askText(named, "SELECT value FROM session WHERE key = 'part'");
    if (!version || part_text.empty())
        return Error{"cannot open " + path + ": it is damaged at its beginning; try 'echotrail recover'"};
    if (*version > log_format::version)
        return Error{"cannot open " + path + ": a newer Echotrail wrote it; update this one"};
    const std::string first = log_format::firstPartPath(path, static_cast<int>(number(part_text)));
    for (int part = 0;; ++part) {
        const std::string part_path = log_format::partPath(first, part);
        if (!holdsBytes(part_path)) {
            if (part > number(part_text)) break;
            parts_missing_ = true;
            ++counts_.missing_parts;
            continue;
        }
        auto one = openPart(part_path);
        if (!one) return Error{one.error()};
        closed_ &= !holdsBytes(part_path + "-wal");
        parts_.push_back({part_path, *std::move(one)});
    }
    return readHeader();
}

Result<void> LogReader::readHeader() {
    sqlite3* first = parts_.front().database.get();
    const auto value = [&](const std::string& key) {
        return askText(first, "SELECT value FROM session WHERE key = '" + key + "'");
    };
    header_.program_version = value("program_version");
    header_.head = value("head");
    header_.configuration = value("configuration");
    header_.seed = static_cast<std::uint64_t>(std::strtoull(value("seed").c_str(), nullptr, 10));
    header_.started = timestamp(number(value("started_us")));
    return {};
}

void LogReader::readExtent() {
    for (const Part& part : parts_) {
        const auto first = askInteger(part.database.get(), "SELECT utc_us FROM events ORDER BY row LIMIT 1");
        const auto last = askInteger(part.database.get(), "SELECT utc_us FROM events ORDER BY row DESC LIMIT 1");
        const auto last_number = askInteger(part.database.get(), "SELECT number FROM events ORDER BY row DESC LIMIT 1");
        if (!start_ && first) start_ = timestamp(*first);
        if (last) end_ = timestamp(*last);
        if (last_number) events_ = static_cast<std::uint64_t>(*last_number) + 1;
    }
}

/// To the next row, in the next part where this one has no more.
bool LogReader::step(Cursor& cursor, std::string_view sql, std::int64_t after) {
    while (cursor.part < parts_.size()) {
        if (!cursor.rows) {
            auto rows = sqlite::Statement::prepare(parts_[cursor.part].database.get(), sql);
            if (rows) {
                cursor.rows.emplace(*std::move(rows));
                cursor.rows->bind(1, after);
            } else {
                counts_.unreadable = parts_[cursor.part].path + ": " + rows.error();
            }
        }
        if (cursor.rows) {
            const auto row = cursor.rows->step();
            if (row && *row) return true;
            if (!row) counts_.unreadable = parts_[cursor.part].path + ": " + row.error();
        }
        cursor.rows.reset();
        ++cursor.part;
        after = 0;
    }
    return false;
}

bool LogReader::checkRow(std::span<const std::int64_t> numbers, std::int64_t crc,
                         std::span<const std::uint8_t> payload) {
    const bool holds = crc == std::int64_t{log_format::rowCrc(numbers, payload)};
    if (!holds) ++counts_.damaged_rows;
    return holds;
}

std::optional<Event> LogReader::next() {
    Event event;
    std::int64_t chunks_taken = 0;
    while (step(event_cursor_, event_rows, std::exchange(after_row_, 0))) {
        sqlite::Statement& row = *event_cursor_.rows;
        std::array<std::int64_t, 6> numbers{};
        for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = row.integer(static_cast<int>(i));
        const auto payload = row.blob(7);
        if (!checkRow(numbers, row.integer(6), payload)) continue;
        const auto [number, kind, utc, monotonic, chunk, chunks] = numbers;
        if (chunk == 0) {
            event = {static_cast<std::uint64_t>(number),
                     static_cast<EventKind>(kind),
                     timestamp(utc),
                     Microseconds(monotonic),
                     {}};
            chunks_taken = 0;
        } else if (chunk != chunks_taken || static_cast<std::uint64_t>(number) != event.number) {
            continue;  // its beginning is missing: the event's number will be, too
        }
        event.payload.insert(event.payload.end(), payload.begin(), payload.end());
        if (++chunks_taken < chunks) continue;
        if (last_number_ && event.number > *last_number_ + 1)
            counts_.missing_events += event.number - *last_number_ - 1;
        last_number_ = event.number;
        return event;
    }
    return std::nullopt;
}

void LogReader::rewind() {
    event_cursor_ = {};
    after_row_ = 0;
    last_number_.reset();
    counts_ = {};
    counts_.missing_parts = parts_missing_ ? 1 : 0;
}

/// Rows are in the order of time: the first one is found by halving.
void LogReader::seek(Timestamp time) {
    rewind();
    const std::int64_t wanted = time.time_since_epoch().count();
    for (std::size_t part = 0; part < parts_.size(); ++part) {
        sqlite3* database = parts_[part].database.get();
        const auto last = askInteger(database, "SELECT utc_us FROM events ORDER BY row DESC LIMIT 1");
        if (!last || *last < wanted) continue;
        std::int64_t before = 0, at = askInteger(database, "SELECT max(row) FROM events").value_or(0);
        while (before + 1 < at) {
            const std::int64_t middle = before + (at - before) / 2;
            const auto utc =
                askInteger(database, "SELECT utc_us FROM events WHERE row >= ?1 ORDER BY row LIMIT 1", middle);
            if (utc && *utc < wanted)
                before = middle;
            else
                at = middle;
        }
        event_cursor_.part = part;
        after_row_ = at - 1;
        return;
    }
    event_cursor_.part = parts_.size();
}

std::optional<LogResult> LogReader::nextResult() {
    while (step(result_cursor_, result_rows, 0)) {
        sqlite::Statement& row = *result_cursor_.rows;
        const std::array<std::int64_t, 2> numbers{row.integer(0), row.integer(1)};
        if (!checkRow(numbers, row.integer(2), row.blob(3))) continue;
        return LogResult{static_cast<UpdateKind>(numbers[0]), timestamp(numbers[1]), row.text(3)};
    }
    return std::nullopt;
}

void LogReader::rewindResults() { result_cursor_ = {}; }

std::string LogReader::summary() {
    // The last row of a run that ended as it should.
    std::string text;
    for (const Part& part : parts_)
        if (auto found = askText(part.database.get(),
                                 "SELECT payload FROM (SELECT kind, payload FROM results ORDER BY row DESC LIMIT 1) "
                                 "WHERE kind = 3");
            !found.empty())
            text = std::move(found);
    return text;
}

std::set<std::uint64_t> LogReader::skips() {
    std::set<std::uint64_t> sequences;
    for (const Part& part : parts_) {
        auto rows = sqlite::Statement::prepare(part.database.get(), "SELECT payload FROM events WHERE kind = 8");
        if (!rows) continue;
        for (auto row = rows->step(); row && *row; row = rows->step())
            sequences.insert(static_cast<std::uint64_t>(number(rows->text(0))));
    }
    return sequences;
}

}  // namespace echotrail
