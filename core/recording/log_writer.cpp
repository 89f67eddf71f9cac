#include "core/recording/log_writer.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

namespace echotrail {
namespace {

using log_format::rowCrc;

constexpr std::string_view schema =
    "CREATE TABLE session(row INTEGER PRIMARY KEY, key TEXT NOT NULL, crc INTEGER NOT NULL, value BLOB NOT NULL);"
    "CREATE TABLE events(row INTEGER PRIMARY KEY, number INTEGER NOT NULL, kind INTEGER NOT NULL, utc_us INTEGER NOT "
    "NULL, monotonic_us INTEGER NOT NULL, chunk INTEGER NOT NULL, chunks INTEGER NOT NULL, crc INTEGER NOT NULL, "
    "payload BLOB NOT NULL);"
    // The only question that is not asked in order of time; the index holds the answer.
    "CREATE INDEX skipped ON events(payload) WHERE kind = 8;"
    "CREATE TABLE results(row INTEGER PRIMARY KEY, kind INTEGER NOT NULL, utc_us INTEGER NOT NULL, crc INTEGER NOT "
    "NULL, payload BLOB NOT NULL);";

std::int64_t microseconds(Timestamp time) { return time.time_since_epoch().count(); }

}  // namespace

Result<std::unique_ptr<LogWriter>> LogWriter::create(const std::string& path, const LogHeader& header,
                                                     const LogOptions& options) {
    // A second part left over from another run would be in the way when this one gets there.
    std::error_code failure;
    if (const std::string second = log_format::partPath(path, 1); std::filesystem::exists(second, failure))
        return Error{"cannot record to " + path + ": " + second + " exists; give another name"};
    std::unique_ptr<LogWriter> writer(new LogWriter(path, header, options));
    if (auto begun = writer->beginPart(0); !begun) return Error{begun.error()};
    return writer;
}

LogWriter::~LogWriter() {
    // Whoever wants to know whether it worked has called close() before.
    [[maybe_unused]] const auto closed = close();
}

/// A part is made under another name and given its own when its tables and header are on the disk, so that at no
/// moment a killed process leaves a file that does not open.
Result<void> LogWriter::beginPart(int part) {
    path_ = log_format::partPath(first_path_, part);
    part_ = part;
    const std::string made_as = path_ + "~";
    const auto fail = [&](const std::string& reason) { return Error{"cannot record to " + path_ + ": " + reason}; };
    std::error_code failure;
    // A write-ahead log left there alone would be taken for that of the new part.
    for (const std::string& taken : {path_, path_ + "-wal", path_ + "-journal"})
        if (std::filesystem::exists(taken, failure)) return fail(taken + " exists; give another name");
    for (const char* left_over : {"", "-wal", "-shm", "-journal"})
        std::filesystem::remove(made_as + left_over, failure);
    if (auto made = makePart(made_as); !made) return fail(made.error());
    std::filesystem::rename(made_as, path_, failure);
    if (failure) return fail(failure.message());
    if (auto opened = openPart(); !opened) return fail(opened.error());
    return {};
}

Result<void> LogWriter::makePart(const std::string& path) const {
    auto database = sqlite::open(path, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
    if (!database) return Error{database.error()};
    // Without a journal: a part half made is thrown away.
    const std::string set_up =
        "PRAGMA page_size = " + std::to_string(log_format::page_bytes) +
        "; PRAGMA journal_mode = OFF; PRAGMA synchronous = FULL; BEGIN; PRAGMA application_id = " +
        std::to_string(log_format::application_id) + "; PRAGMA user_version = " + std::to_string(log_format::version) +
        ";" + std::string(schema);
    if (auto done = sqlite::execute(database->get(), set_up); !done) return done;
    if (auto done = writeHeader(database->get()); !done) return done;
    return sqlite::execute(database->get(), "COMMIT; PRAGMA journal_mode = WAL;");
}

Result<void> LogWriter::openPart() {
    auto opened = sqlite::open(path_, SQLITE_OPEN_READWRITE);
    if (!opened) return Error{opened.error()};
    database_ = *std::move(opened);
    // Beginning the write-ahead log syncs the folder, and so the name of the part, too.
    const std::string set_up = "PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL; PRAGMA wal_autocheckpoint = 256;";
    if (auto done = sqlite::execute(database_.get(), set_up); !done) return done;
    auto event = sqlite::Statement::prepare(
        database_.get(),
        "INSERT INTO events(number, kind, utc_us, monotonic_us, chunk, chunks, crc, payload) VALUES(?,?,?,?,?,?,?,?)");
    if (!event) return Error{event.error()};
    auto result =
        sqlite::Statement::prepare(database_.get(), "INSERT INTO results(kind, utc_us, crc, payload) VALUES(?,?,?,?)");
    if (!result) return Error{result.error()};
    add_event_.emplace(*std::move(event));
    add_result_.emplace(*std::move(result));
    return {};
}

Result<void> LogWriter::writeHeader(sqlite3* database) const {
    auto statement = sqlite::Statement::prepare(database, "INSERT INTO session(key, crc, value) VALUES(?, ?, ?)");
    if (!statement) return Error{statement.error()};
    const std::array<std::pair<std::string_view, std::string>, 6> entries{
        {{"program_version", header_.program_version},
         {"head", header_.head},
         {"configuration", header_.configuration},
         {"seed", std::to_string(header_.seed)},
         {"started_us", std::to_string(microseconds(header_.started))},
         {"part", std::to_string(part_)}}};
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

Result<void> LogWriter::begin() {
    if (in_transaction_) return {};
    if (auto done = sqlite::execute(database_.get(), "BEGIN"); !done) return done;
    in_transaction_ = true;
    return {};
}

Result<void> LogWriter::add(const Event& event) {
    if (auto begun = begin(); !begun) return begun;
    const std::span<const std::uint8_t> payload(event.payload);
    const std::size_t chunks =
        std::max<std::size_t>(1, (payload.size() + log_format::chunk_bytes - 1) / log_format::chunk_bytes);
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
        const std::size_t at = chunk * log_format::chunk_bytes;
        const auto part = payload.subspan(at, std::min(log_format::chunk_bytes, payload.size() - at));
        const std::array<std::int64_t, 6> numbers{static_cast<std::int64_t>(event.number),
                                                  static_cast<std::int64_t>(event.kind),
                                                  microseconds(event.utc),
                                                  event.monotonic.count(),
                                                  static_cast<std::int64_t>(chunk),
                                                  static_cast<std::int64_t>(chunks)};
        for (std::size_t i = 0; i < numbers.size(); ++i) add_event_->bind(static_cast<int>(i) + 1, numbers[i]);
        add_event_->bind(7, std::int64_t{rowCrc(numbers, part)}).bind(8, part);
        const auto done = add_event_->step();
        add_event_->reset();
        if (!done) return Error{done.error()};
        part_bytes_ += part.size();
    }
    return {};
}

Result<void> LogWriter::addUpdate(UpdateKind kind, Timestamp time, const std::string& text) {
    if (auto begun = begin(); !begun) return begun;
    const auto payload = log_format::bytesOf(text);
    const std::array<std::int64_t, 2> numbers{static_cast<std::int64_t>(kind), microseconds(time)};
    add_result_->bind(1, numbers[0])
        .bind(2, numbers[1])
        .bind(3, std::int64_t{rowCrc(numbers, payload)})
        .bind(4, payload);
    const auto done = add_result_->step();
    add_result_->reset();
    if (!done) return Error{done.error()};
    part_bytes_ += payload.size();
    return {};
}

Result<void> LogWriter::commit() {
    if (in_transaction_) {
        if (auto done = sqlite::execute(database_.get(), "COMMIT"); !done) return done;
        in_transaction_ = false;
    }
    if (part_bytes_ < options_.part_bytes) return {};
    if (auto closed = closePart(); !closed) return closed;
    return beginPart(part_ + 1);
}

Result<void> LogWriter::closePart() {
    add_event_.reset();
    add_result_.reset();
    earlier_bytes_ += std::exchange(part_bytes_, 0);
    // One plain file: it can be copied, and opened where nothing may be written.
    auto done = sqlite::execute(database_.get(), "PRAGMA wal_checkpoint(TRUNCATE); PRAGMA journal_mode = DELETE;");
    // Somebody reads it now: it stays two files, which open as well.
    const bool is_read = !done && sqlite3_errcode(database_.get()) == SQLITE_BUSY;
    database_.reset();
    return is_read ? Result<void>{} : done;
}

Result<void> LogWriter::close() {
    if (!database_) return {};
    if (in_transaction_) {
        if (auto done = sqlite::execute(database_.get(), "COMMIT"); !done) return done;
        in_transaction_ = false;
    }
    return closePart();
}

std::uint64_t LogWriter::bytes() const { return earlier_bytes_ + part_bytes_; }

}  // namespace echotrail
