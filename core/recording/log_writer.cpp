#include "core/recording/log_writer.hpp"

#include "core/recording/log_part.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

namespace echotrail {
namespace {

using log_format::rowCrc;

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

Result<void> LogWriter::beginPart(int part) {
    path_ = log_format::partPath(first_path_, part);
    part_ = part;
    if (auto made = log_part::make(path_, header_, part); !made) return made;
    if (auto opened = openPart(); !opened) return Error{"cannot record to " + path_ + ": " + opened.error()};
    return {};
}

Result<void> LogWriter::openPart() {
    auto opened = log_part::openToWrite(path_, "FULL");
    if (!opened) return Error{opened.error()};
    database_ = *std::move(opened);
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
    return log_part::close(database_);
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
