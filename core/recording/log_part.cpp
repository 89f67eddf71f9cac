#include "core/recording/log_part.hpp"

#include <array>
#include <charconv>
#include <filesystem>

namespace echotrail::log_part {
namespace {

constexpr std::string_view schema =
    "CREATE TABLE session(row INTEGER PRIMARY KEY, key TEXT NOT NULL, crc INTEGER NOT NULL, value BLOB NOT NULL);"
    "CREATE TABLE events(row INTEGER PRIMARY KEY, number INTEGER NOT NULL, kind INTEGER NOT NULL, utc_us INTEGER NOT "
    "NULL, monotonic_us INTEGER NOT NULL, chunk INTEGER NOT NULL, chunks INTEGER NOT NULL, crc INTEGER NOT NULL, "
    "payload BLOB NOT NULL);"
    // The only question that is not asked in order of time; the index holds the answer.
    "CREATE INDEX skipped ON events(payload) WHERE kind = 8;"
    "CREATE TABLE results(row INTEGER PRIMARY KEY, kind INTEGER NOT NULL, utc_us INTEGER NOT NULL, crc INTEGER NOT "
    "NULL, payload BLOB NOT NULL);";

/// Values of the session, in rows of their keys.
Result<void> writeHeader(sqlite3* database, const LogHeader& header, int part) {
    auto statement = sqlite::Statement::prepare(database, "INSERT INTO session(key, crc, value) VALUES(?, ?, ?)");
    if (!statement) return Error{statement.error()};
    const std::array<std::pair<std::string_view, std::string>, 6> entries{
        {{"program_version", header.program_version},
         {"head", header.head},
         {"configuration", header.configuration},
         {"seed", std::to_string(header.seed)},
         {"started_us", std::to_string(header.started.time_since_epoch().count())},
         {"part", std::to_string(part)}}};
    for (const auto& [key, text] : entries) {
        std::size_t at = 0;
        do {
            const auto value =
                log_format::bytesOf(text).subspan(at, std::min(log_format::chunk_bytes, text.size() - at));
            statement->bind(1, key).bind(2, std::int64_t{log_format::sessionCrc(key, value)}).bind(3, value);
            if (auto done = statement->step(); !done) return Error{done.error()};
            statement->reset();
            at += value.size();
        } while (at < text.size());
    }
    return {};
}

Result<void> fill(const std::string& path, const LogHeader& header, int part) {
    auto database = sqlite::open(path, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
    if (!database) return Error{database.error()};
    // Without a journal: a part half made is thrown away.
    const std::string set_up =
        "PRAGMA page_size = " + std::to_string(log_format::page_bytes) +
        "; PRAGMA journal_mode = OFF; PRAGMA synchronous = FULL; BEGIN; PRAGMA application_id = " +
        std::to_string(log_format::application_id) + "; PRAGMA user_version = " + std::to_string(log_format::version) +
        ";" + std::string(schema);
    if (auto done = sqlite::execute(database->get(), set_up); !done) return done;
    if (auto done = writeHeader(database->get(), header, part); !done) return done;
    return sqlite::execute(database->get(), "COMMIT; PRAGMA journal_mode = WAL;");
}

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

enum class WalUse {
    None,     ///< there is none: the file is opened as what cannot change
    Shared,   ///< with its index in shared memory (-shm), only read; needed where a writer is alive
    Private,  ///< with an index of our own, and no lock
};

/// In no use is anything changed or made, in the file or beside it, and a medium that cannot be written will do.
Result<sqlite::Database> openWith(WalUse use, const std::string& path) {
    const char* how = use == WalUse::None     ? "?mode=ro&immutable=1"
                      : use == WalUse::Shared ? "?mode=ro&readonly_shm=1"
                                              : "?mode=ro&vfs=unix-none";
    auto opened = sqlite::open(uriOf(path, how), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
    if (!opened) return opened;
    sqlite3* database = opened->get();
    sqlite3_db_config(database, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
    // What a dead process left of an index can make SQLite wait for one that will never come.
    sqlite3_busy_timeout(database, use == WalUse::Shared ? 200 : 0);
    if (use == WalUse::Private)
        if (auto done = sqlite::execute(database, "PRAGMA locking_mode = EXCLUSIVE"); !done) return Error{done.error()};
    return opened;
}

std::int64_t number(const std::string& text) {
    std::int64_t value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

}  // namespace

Result<void> make(const std::string& path, const LogHeader& header, int part) {
    const std::string made_as = path + "~";
    const auto fail = [&](const std::string& reason) { return Error{"cannot record to " + path + ": " + reason}; };
    std::error_code failure;
    // A write-ahead log left there alone would be taken for that of the new part.
    for (const std::string& taken : {path, path + "-wal", path + "-journal"})
        if (std::filesystem::exists(taken, failure)) return fail(taken + " exists; give another name");
    for (const char* left_over : {"", "-wal", "-shm", "-journal"})
        std::filesystem::remove(made_as + left_over, failure);
    if (auto filled = fill(made_as, header, part); !filled) return fail(filled.error());
    std::filesystem::rename(made_as, path, failure);
    if (failure) return fail(failure.message());
    return {};
}

Result<sqlite::Database> openToWrite(const std::string& path, std::string_view synchronous) {
    auto opened = sqlite::open(path, SQLITE_OPEN_READWRITE);
    if (!opened) return Error{opened.error()};
    // Beginning the write-ahead log syncs the folder, and so the name of the part, too.
    const std::string set_up = "PRAGMA journal_mode = WAL; PRAGMA synchronous = " + std::string(synchronous) +
                               "; PRAGMA wal_autocheckpoint = 256;";
    if (auto done = sqlite::execute(opened->get(), set_up); !done) return Error{done.error()};
    return opened;
}

Result<void> close(sqlite::Database& database) {
    auto done = sqlite::execute(database.get(), "PRAGMA wal_checkpoint(TRUNCATE); PRAGMA journal_mode = DELETE;");
    const bool is_read = !done && sqlite3_errcode(database.get()) == SQLITE_BUSY;
    database.reset();
    return is_read ? Result<void>{} : done;
}

bool hasWal(const std::string& path) {
    constexpr std::size_t header_bytes = 32;  // its own
    std::error_code failure;
    const auto size = std::filesystem::file_size(path + "-wal", failure);
    return !failure && size > header_bytes;
}

Result<sqlite::Database> openToRead(const std::string& path) {
    std::error_code failure;
    const bool has_wal = hasWal(path);
    if (has_wal && std::filesystem::exists(path + "-shm", failure)) {
        auto shared = openWith(WalUse::Shared, path);
        if (shared && sqlite::execute(shared->get(), "SELECT count(*) FROM sqlite_schema")) return shared;
        // The index is not that of this write-ahead log, as after a loss of power: whoever wrote is gone.
    }
    auto opened = openWith(has_wal ? WalUse::Private : WalUse::None, path);
    if (!opened) return Error{"cannot open " + path + ": " + opened.error()};
    return opened;
}

std::optional<std::int64_t> askInteger(sqlite3* database, std::string_view sql, std::int64_t argument) {
    auto statement = sqlite::Statement::prepare(database, sql);
    if (!statement) return std::nullopt;
    if (sql.find("?1") != std::string_view::npos) statement->bind(1, argument);
    const auto row = statement->step();
    if (!row || !*row) return std::nullopt;
    return statement->integer(0);
}

/// From all its rows.
std::string sessionValue(sqlite3* database, std::string_view key) {
    auto rows = sqlite::Statement::prepare(database, "SELECT crc, value FROM session WHERE key = ?1 ORDER BY row");
    if (!rows) return {};
    rows->bind(1, key);
    std::string value;
    for (auto row = rows->step(); row && *row; row = rows->step()) {
        if (rows->integer(0) != std::int64_t{log_format::sessionCrc(key, rows->blob(1))}) return {};
        value += rows->text(1);
    }
    return value;
}

LogHeader headerOf(sqlite3* database) {
    LogHeader header;
    header.program_version = sessionValue(database, "program_version");
    header.head = sessionValue(database, "head");
    header.configuration = sessionValue(database, "configuration");
    header.seed = static_cast<std::uint64_t>(std::strtoull(sessionValue(database, "seed").c_str(), nullptr, 10));
    header.started = Timestamp(Microseconds(number(sessionValue(database, "started_us"))));
    return header;
}

}  // namespace echotrail::log_part
