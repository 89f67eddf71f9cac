#include "core/recording/log_extract.hpp"

#include "core/recording/log_part.hpp"

#include <filesystem>

namespace echotrail {
namespace {

constexpr std::size_t row_overhead = 48;  // bytes of a row over the link beside its payload, about

Result<sqlite::Database> openPart(const std::string& path, LogUse use) {
    if (use == LogUse::Resting) return log_part::openToRead(path);
    auto opened = sqlite::open(path, SQLITE_OPEN_READONLY);
    if (opened) sqlite3_db_config(opened->get(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
    return opened;
}

int partsOf(const std::string& path) {
    int parts = 0;
    std::error_code failure;
    while (std::filesystem::exists(log_format::partPath(path, parts), failure)) ++parts;
    return parts;
}

std::int64_t lastRow(sqlite3* database, LogTable table) {
    const char* sql = table == LogTable::Events ? "SELECT max(row) FROM events" : "SELECT max(row) FROM results";
    return log_part::askInteger(database, sql).value_or(0);
}

/// Those of `wanted`, from the statement's rows.
Result<void> take(sqlite::Statement& statement, const LogRowsWanted& wanted, std::vector<LogRow>& rows) {
    const int numbers = static_cast<int>(numbersOf(wanted.table));
    std::size_t bytes = 0;
    while (true) {
        const auto there = statement.step();
        if (!there) return Error{there.error()};
        if (!*there) return {};
        const auto payload = statement.blob(numbers + 2);
        bytes += payload.size() + row_overhead;
        if (!rows.empty() && bytes > wanted.most_bytes) return {};
        LogRow& row = rows.emplace_back();
        row.row = statement.integer(0);
        for (int i = 0; i < numbers; ++i) row.numbers[static_cast<std::size_t>(i)] = statement.integer(i + 1);
        row.crc = static_cast<std::uint32_t>(statement.integer(numbers + 1));
        row.payload.assign(payload.begin(), payload.end());
    }
}

}  // namespace

Result<LogDescription> describeLog(const std::string& path, LogUse use) {
    LogDescription log;
    const int parts = partsOf(path);
    for (int part = 0; part < parts; ++part) {
        const auto database = openPart(log_format::partPath(path, part), use);
        if (!database) return Error{database.error()};
        const LogHeader header = log_part::headerOf(database->get());
        if (part == 0) log.header = header;
        if (header.started != log.header.started) break;  // of another run, under a name that looks like a part of it
        LogExtent& extent = log.parts.emplace_back();
        // Results first: the events that they came from are there, then.
        extent.results = lastRow(database->get(), LogTable::Results);
        extent.events = lastRow(database->get(), LogTable::Events);
    }
    if (log.parts.empty() || log.header.started == Timestamp{})
        return Error{"cannot open " + path + ": it is not a log, or damaged at its beginning"};
    return log;
}

Result<LogRows> readLogRows(const std::string& path, LogUse use, const LogRowsWanted& wanted) {
    LogRows read;
    read.table = wanted.table;
    read.parts = partsOf(path);
    if (wanted.part < 0 || wanted.part >= read.parts) return read;  // not there yet
    const auto database = openPart(log_format::partPath(path, wanted.part), use);
    if (!database) return Error{database.error()};
    auto statement = sqlite::Statement::prepare(
        database->get(), wanted.table == LogTable::Events
                             ? "SELECT row, number, kind, utc_us, monotonic_us, chunk, chunks, crc, payload FROM "
                               "events WHERE row BETWEEN ?1 AND ?2 ORDER BY row"
                             : "SELECT row, kind, utc_us, crc, payload FROM results WHERE row BETWEEN ?1 AND ?2 "
                               "ORDER BY row");
    if (!statement) return Error{statement.error()};
    statement->bind(1, wanted.first).bind(2, wanted.last);
    if (auto taken = take(*statement, wanted, read.rows); !taken) return Error{taken.error()};
    read.there = lastRow(database->get(), wanted.table);
    return read;
}

}  // namespace echotrail
