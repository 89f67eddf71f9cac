#include "core/recording/log_copy.hpp"

#include "core/recording/log_part.hpp"

#include <filesystem>

namespace echotrail {
namespace {

constexpr std::string_view insert_event =
    "INSERT OR IGNORE INTO events(row, number, kind, utc_us, monotonic_us, chunk, chunks, crc, payload) "
    "VALUES(?,?,?,?,?,?,?,?,?)";
constexpr std::string_view insert_result =
    "INSERT OR IGNORE INTO results(row, kind, utc_us, crc, payload) VALUES(?,?,?,?,?)";

bool hasHeldTable(sqlite3* database) {
    return log_part::askInteger(database, "SELECT count(*) FROM sqlite_schema WHERE name = 'held'").value_or(0) > 0;
}

}  // namespace

bool LogCopy::isOf(const std::string& path, const LogHeader& header) {
    const auto database = log_part::openToRead(path);
    return database && log_part::headerOf(database->get()) == header;
}

Result<std::unique_ptr<LogCopy>> LogCopy::open(const std::string& path, const LogHeader& header) {
    std::unique_ptr<LogCopy> copy(new LogCopy(path, header));
    std::error_code failure;
    if (std::filesystem::exists(path, failure)) {
        if (!isOf(path, header)) return Error{path + " is not a copy of this recording; give another name"};
        if (auto read = copy->readHeld(); !read) return Error{read.error()};
    } else if (auto made = log_part::make(path, header, 0); !made) {
        return Error{made.error()};
    }
    return copy;
}

LogCopy::~LogCopy() {
    // Whoever wants to know whether it worked has called close() before.
    [[maybe_unused]] const auto closed = close();
}

Result<void> LogCopy::readHeld() {
    for (const auto& [part, path] : log_format::partsBeside(path_)) {
        if (part > 0 && !isOf(path, header_)) continue;  // of another run, under a name that looks like a part's
        if (auto used = usePart(part); !used) return used;
        if (!hasHeldTable(database_.get())) {
            for (const LogTable table : log_tables)
                held_[{part, table}].add(
                    1, log_part::askInteger(database_.get(), table == LogTable::Events ? "SELECT max(row) FROM events"
                                                                                       : "SELECT max(row) FROM results")
                           .value_or(0));
            continue;
        }
        auto rows = sqlite::Statement::prepare(database_.get(), "SELECT kind, first, last FROM held");
        if (!rows) return Error{rows.error()};
        for (auto row = rows->step(); row && *row; row = rows->step())
            held_[{part, rows->integer(0) == 0 ? LogTable::Events : LogTable::Results}].add(rows->integer(1),
                                                                                            rows->integer(2));
    }
    return {};
}

Result<void> LogCopy::usePart(int part) {
    if (part == part_) return {};
    if (auto closed = close(); !closed) return closed;
    const std::string path = log_format::partPath(path_, part);
    std::error_code failure;
    if (!std::filesystem::exists(path, failure))
        if (auto made = log_part::make(path, header_, part); !made) return made;
    // A commit need not wait for the disk: see the promise.
    auto opened = log_part::openToWrite(path, "NORMAL");
    if (!opened) return Error{"cannot write " + path + ": " + opened.error()};
    database_ = *std::move(opened);
    for (const LogTable table : log_tables) {
        auto insert =
            sqlite::Statement::prepare(database_.get(), table == LogTable::Events ? insert_event : insert_result);
        if (!insert) return Error{insert.error()};
        insert_.emplace(table, *std::move(insert));
    }
    part_ = part;
    return {};
}

Result<void> LogCopy::add(const LogRowsWanted& wanted, const std::vector<LogRow>& rows) {
    if (rows.empty()) return {};
    if (auto used = usePart(wanted.part); !used) return used;
    if (!in_transaction_)
        if (auto begun = sqlite::execute(database_.get(), "BEGIN IMMEDIATE"); !begun) return begun;
    in_transaction_ = true;
    sqlite::Statement& insert = insert_.at(wanted.table);
    const int numbers = static_cast<int>(numbersOf(wanted.table));
    for (const LogRow& row : rows) {
        insert.bind(1, row.row);
        for (int i = 0; i < numbers; ++i) insert.bind(i + 2, row.numbers[static_cast<std::size_t>(i)]);
        insert.bind(numbers + 2, std::int64_t{row.crc}).bind(numbers + 3, std::span(row.payload));
        const auto done = insert.step();
        insert.reset();
        if (!done) return Error{done.error()};
        bytes_ += row.payload.size();
    }
    held_[{wanted.part, wanted.table}].add(wanted.first, rows.back().row);
    return {};
}

Result<void> LogCopy::writeHeld() {
    if (held(part_, LogTable::Events).whole() && held(part_, LogTable::Results).whole())
        return sqlite::execute(database_.get(), "DROP TABLE IF EXISTS held");
    if (auto made = sqlite::execute(database_.get(),
                                    "CREATE TABLE IF NOT EXISTS held(kind INTEGER NOT NULL, first INTEGER NOT NULL, "
                                    "last INTEGER NOT NULL); DELETE FROM held");
        !made)
        return made;
    auto insert = sqlite::Statement::prepare(database_.get(), "INSERT INTO held(kind, first, last) VALUES(?,?,?)");
    if (!insert) return Error{insert.error()};
    for (const LogTable table : log_tables)
        for (const auto& [first, last] : held(part_, table).ranges()) {
            insert->bind(1, static_cast<std::int64_t>(table)).bind(2, first).bind(3, last);
            if (auto done = insert->step(); !done) return Error{done.error()};
            insert->reset();
        }
    return {};
}

Result<void> LogCopy::commit() {
    if (!in_transaction_) return {};
    if (auto written = writeHeld(); !written) return written;
    if (auto done = sqlite::execute(database_.get(), "COMMIT"); !done) return done;
    in_transaction_ = false;
    return {};
}

Result<void> LogCopy::close() {
    if (!database_) return {};
    auto committed = commit();
    insert_.clear();
    part_ = -1;
    in_transaction_ = false;
    auto closed = log_part::close(database_);
    return committed ? closed : committed;
}

}  // namespace echotrail
