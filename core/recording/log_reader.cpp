#include "core/recording/log_reader.hpp"

#include "core/recording/log_part.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>

namespace echotrail {
namespace {

using log_part::askInteger;
using log_part::hasWal;
using log_part::headerOf;
using log_part::openToRead;
using log_part::sessionValue;

constexpr std::string_view event_rows =
    "SELECT number, kind, utc_us, monotonic_us, chunk, chunks, crc, payload FROM events WHERE row > ?1 ORDER BY row";
constexpr std::string_view result_rows = "SELECT kind, utc_us, crc, payload FROM results WHERE row > ?1 ORDER BY row";

Timestamp timestamp(std::int64_t microseconds) { return Timestamp(Microseconds(microseconds)); }

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
    auto opened = openToRead(path);
    if (!opened) return Error{opened.error()};
    const auto version = askInteger(opened->get(), "PRAGMA user_version");
    if (version && *version > log_format::version)
        return Error{"cannot open " + path + ": a newer Echotrail wrote it; update this one"};
    const std::string own_part = sessionValue(opened->get(), "part");
    if (!version || own_part.empty())
        return Error{"cannot open " + path + ": it is damaged at its beginning; try 'echotrail recover'"};
    header_ = headerOf(opened->get());
    const std::string first = log_format::firstPartPath(path, static_cast<int>(number(own_part)));
    int expected = 0;
    for (const auto& [part, part_path] : log_format::partsBeside(first)) {
        auto one = openToRead(part_path);
        if (!one) return Error{one.error()};
        // A part that cannot say whose it is counts as one of ours: its rows have their own check sums.
        const LogHeader theirs = headerOf(one->get());
        const bool silent = theirs.started == Timestamp{};
        const bool ours = theirs.started == header_.started && theirs.seed == header_.seed &&
                          sessionValue(one->get(), "part") == std::to_string(part);
        if (!silent && !ours) continue;
        missing_parts_ += static_cast<std::uint64_t>(std::max(0, part - expected));
        expected = part + 1;
        closed_ &= !hasWal(part_path);
        parts_.push_back({part_path, *std::move(one)});
    }
    // Under a name that does not tell it is its own only part.
    if (parts_.empty()) parts_.push_back({path, *std::move(opened)});
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
        if (expected_number_ && event.number > *expected_number_)
            counts_.missing_events += event.number - *expected_number_;
        expected_number_ = event.number + 1;
        return event;
    }
    return std::nullopt;
}

void LogReader::rewind() {
    event_cursor_ = {};
    after_row_ = 0;
    expected_number_ = 0;
    counts_ = {};
    counts_.missing_parts = missing_parts_;
}

/// Rows are in the order of time: the first one is found by halving.
void LogReader::seek(Timestamp time) {
    rewind();
    expected_number_.reset();
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
    std::string text;
    for (const Part& part : parts_) {
        auto last = sqlite::Statement::prepare(part.database.get(),
                                               "SELECT kind, payload FROM results ORDER BY row DESC LIMIT 1");
        if (!last) continue;
        // A run that ended as it should wrote it last.
        if (const auto row = last->step(); row && *row && last->integer(0) == static_cast<int>(UpdateKind::Summary))
            text = last->text(1);
    }
    return text;
}

Result<std::set<std::uint64_t>> LogReader::skips() {
    std::set<std::uint64_t> sequences;
    for (const Part& part : parts_) {
        auto rows = sqlite::Statement::prepare(part.database.get(), "SELECT payload FROM events WHERE kind = 8");
        if (!rows) return Error{rows.error()};
        auto row = rows->step();
        for (; row && *row; row = rows->step()) sequences.insert(static_cast<std::uint64_t>(number(rows->text(0))));
        if (!row) return Error{row.error()};
    }
    return sequences;
}

}  // namespace echotrail
