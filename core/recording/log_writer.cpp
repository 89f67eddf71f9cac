#include "core/recording/log_writer.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

namespace echotrail {
namespace {

using log_format::rowCrc;

constexpr std::string_view schema =
    "CREATE TABLE session(key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;"
    "CREATE TABLE events(row INTEGER PRIMARY KEY, number INTEGER NOT NULL, kind INTEGER NOT NULL, utc_us INTEGER NOT "
    "NULL, monotonic_us INTEGER NOT NULL, chunk INTEGER NOT NULL, chunks INTEGER NOT NULL, crc INTEGER NOT NULL, "
    "payload BLOB NOT NULL);"
    // The only question that is not asked in order of time; there are few of them.
    "CREATE INDEX skipped ON events(number) WHERE kind = 8;"
    "CREATE TABLE results(row INTEGER PRIMARY KEY, kind INTEGER NOT NULL, utc_us INTEGER NOT NULL, crc INTEGER NOT "
    "NULL, payload BLOB NOT NULL);";

std::int64_t microseconds(Timestamp time) { return time.time_since_epoch().count(); }

}  // namespace

Result<std::unique_ptr<LogWriter>> LogWriter::create(const std::string& path, const LogHeader& header,
                                                     const LogOptions& options) {
    std::unique_ptr<LogWriter> writer(new LogWriter(path, header, options));
    if (auto begun = writer->beginPart(0); !begun) return Error{begun.error()};
    return writer;
}

LogWriter::~LogWriter() {
    // Whoever wants to know whether it worked has called close() before.
    [[maybe_unused]] const auto closed = close();
}

Result<void> LogWriter::beginPart(int part) {
    const std::string path = log_format::partPath(first_path_, part);
    std::error_code failure;
    if (std::filesystem::exists(path, failure))
        return Error{"cannot record to " + path + ": the file exists; give another name"};
    auto opened = sqlite::open(path, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
    if (!opened) return Error{"cannot record to " + path + ": " + opened.error()};
    database_ = *std::move(opened);
    path_ = path;
    part_ = part;
    const std::string set_up =
        "PRAGMA page_size = " + std::to_string(log_format::page_bytes) +
        "; PRAGMA application_id = " + std::to_string(log_format::application_id) +
        "; PRAGMA user_version = " + std::to_string(log_format::version) +
        "; PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL; PRAGMA wal_autocheckpoint = 256;";
    if (auto done = sqlite::execute(database_.get(), set_up); !done)
        return Error{"cannot record to " + path + ": " + done.error()};
    if (auto done = sqlite::execute(database_.get(), "BEGIN;" + std::string(schema)); !done) return done;
    in_transaction_ = true;
    if (auto done = writeHeader(); !done) return done;
    if (auto done = commit(); !done) return done;
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

Result<void> LogWriter::writeHeader() {
    auto statement = sqlite::Statement::prepare(database_.get(), "INSERT INTO session(key, value) VALUES(?, ?)");
    if (!statement) return Error{statement.error()};
    const std::array<std::pair<std::string_view, std::string>, 6> rows{
        {{"program_version", header_.program_version},
         {"head", header_.head},
         {"configuration", header_.configuration},
         {"seed", std::to_string(header_.seed)},
         {"started_us", std::to_string(microseconds(header_.started))},
         {"part", std::to_string(part_)}}};
    for (const auto& [key, value] : rows) {
        if (auto done = statement->bind(1, key).bind(2, std::string_view(value)).step(); !done)
            return Error{done.error()};
        statement->reset();
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
    const std::span<const std::uint8_t> payload(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
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
    database_.reset();
    return done;
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
