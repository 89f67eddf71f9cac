#pragma once

#include "core/base/result.hpp"

#include <sqlite3.h>

#include <cassert>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

/// As much of SQLite as the log needs: handles that close themselves, errors as values.
namespace echotrail::sqlite {

struct CloseDatabase {
    void operator()(sqlite3* database) const { sqlite3_close(database); }
};
struct Finalise {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Database = std::unique_ptr<sqlite3, CloseDatabase>;

inline Error errorOf(sqlite3* database, const std::string& what) {
    return Error{what + ": " + (database ? sqlite3_errmsg(database) : "out of memory")};
}

/// `flags` as of sqlite3_open_v2; `uri` may be a path.
inline Result<Database> open(const std::string& uri, int flags) {
    sqlite3* raw = nullptr;
    const int code = sqlite3_open_v2(uri.c_str(), &raw, flags, nullptr);
    Database database(raw);
    if (code != SQLITE_OK) return errorOf(raw, "cannot open the log");
    sqlite3_busy_timeout(raw, 5000);
    return database;
}

inline Result<void> execute(sqlite3* database, const std::string& sql) {
    if (sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK)
        return errorOf(database, "the log refuses a step");
    return {};
}

/// One prepared statement. Order: bind every parameter (from 1), step() until it gives no row, reset().
class Statement {
public:
    static Result<Statement> prepare(sqlite3* database, std::string_view sql) {
        sqlite3_stmt* raw = nullptr;
        if (sqlite3_prepare_v2(database, sql.data(), static_cast<int>(sql.size()), &raw, nullptr) != SQLITE_OK)
            return errorOf(database, "the log is not one of ours");
        return Statement(database, raw);
    }

    Statement& bind(int index, std::int64_t value) { return check(sqlite3_bind_int64(handle_.get(), index, value)); }
    /// The text or bytes must live until the statement is reset.
    Statement& bind(int index, std::string_view text) {
        return check(
            sqlite3_bind_text(handle_.get(), index, text.data(), static_cast<int>(text.size()), SQLITE_STATIC));
    }
    Statement& bind(int index, std::span<const std::uint8_t> bytes) {
        // A null pointer would bind NULL, not an empty blob.
        const void* data = bytes.empty() ? static_cast<const void*>("") : bytes.data();
        return check(sqlite3_bind_blob(handle_.get(), index, data, static_cast<int>(bytes.size()), SQLITE_STATIC));
    }

    /// True: there is a row. False: the statement is done.
    Result<bool> step() {
        const int code = sqlite3_step(handle_.get());
        if (code == SQLITE_ROW) return true;
        if (code == SQLITE_DONE) return false;
        return errorOf(database_, "the log cannot be read or written");
    }
    void reset() { sqlite3_reset(handle_.get()); }

    std::int64_t integer(int column) const { return sqlite3_column_int64(handle_.get(), column); }
    std::string text(int column) const {
        const auto bytes = blob(column);
        return {bytes.begin(), bytes.end()};
    }
    /// Valid until the next step.
    std::span<const std::uint8_t> blob(int column) const {
        const auto* data = static_cast<const std::uint8_t*>(sqlite3_column_blob(handle_.get(), column));
        return {data, static_cast<std::size_t>(sqlite3_column_bytes(handle_.get(), column))};
    }

private:
    Statement(sqlite3* database, sqlite3_stmt* raw) : database_(database), handle_(raw) {}
    Statement& check([[maybe_unused]] int code) {
        assert(code == SQLITE_OK);
        return *this;
    }
    sqlite3* database_;
    std::unique_ptr<sqlite3_stmt, Finalise> handle_;
};

}  // namespace echotrail::sqlite
