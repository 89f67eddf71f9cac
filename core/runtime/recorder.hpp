#pragma once

#include "core/data/event.hpp"
#include "core/recording/log_writer.hpp"
#include "core/runtime/bounded_queue.hpp"

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <variant>

namespace echotrail {

enum class DiskState { Good, Low, Full };

/// What the recorder is doing, for a person to read.
struct RecorderStatus {
    bool recording = false;
    std::string path;         ///< of the part being written
    std::uint64_t bytes = 0;  ///< written so far, all parts
    std::uint64_t free_bytes = 0;
    DiskState disk = DiskState::Good;
    std::size_t queued = 0;     ///< rows that are not on disk yet
    std::uint64_t unsaved = 0;  ///< rows that could not be written
    std::string error;          ///< why recording stopped: one line
};

/// What the tracker found at an update: a row of the log beside the events.
struct ResultRow {
    UpdateKind kind = UpdateKind::Track;
    Timestamp time{};
    std::string text;  ///< a JSON object
};

/// Writes a log on a thread of its own and commits twice a second.
/// Threads: add() from any; it returns at once unless the disk is further behind than memory allows.
/// Promise: what add() took is written in that order; close(), or destruction, waits until all of it is on disk. Where
///          writing fails, recording ends: what was not committed, and what follows, is counted as unsaved, and the
///          status says why.
class Recorder {
public:
    explicit Recorder(std::unique_ptr<LogWriter> log);
    ~Recorder();
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    // Quietly: the log's thread, woken for every row, would take the processor from whoever has the next thing to do.
    void add(Event event) { queue_.pushQuietly(std::move(event)); }
    void add(ResultRow row) { queue_.pushQuietly(std::move(row)); }
    void close();
    RecorderStatus status() const;

private:
    using Row = std::variant<Event, ResultRow>;
    void run();
    void write(const Row& row);
    void fail(const std::string& reason);
    void look();

    std::unique_ptr<LogWriter> log_;
    BoundedQueue<Row> queue_;
    std::uint64_t uncommitted_ = 0;  ///< rows since the last commit; the writing thread's own
    mutable std::mutex mutex_;       ///< of status_
    RecorderStatus status_;
    std::jthread thread_;  // last, so that it ends before what it uses
};

}  // namespace echotrail
