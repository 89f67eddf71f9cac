#include "core/runtime/recorder.hpp"

#include <filesystem>

namespace echotrail {
namespace {

constexpr std::size_t longest_queue = 200'000;  // some ten minutes of the reads of a busy link
constexpr std::chrono::milliseconds commit_interval{500}, take_interval{50};
constexpr std::uint64_t low_bytes = 2'000'000'000, full_bytes = 200'000'000;

}  // namespace

Recorder::Recorder(std::unique_ptr<LogWriter> log) : log_(std::move(log)), queue_(longest_queue) {
    status_.recording = true;
    look();
    thread_ = std::jthread([this] { run(); });
}

Recorder::~Recorder() { close(); }

void Recorder::close() {
    queue_.close();
    if (thread_.joinable()) thread_.join();
}

RecorderStatus Recorder::status() const {
    const std::scoped_lock lock(mutex_);
    RecorderStatus status = status_;
    status.queued += queue_.size();
    return status;
}

void Recorder::run() {
    auto last_commit = std::chrono::steady_clock::now();
    bool dirty = false;
    while (!queue_.ended()) {
        for (const Row& row : queue_.take(take_interval)) {
            write(row);
            dirty = true;
        }
        if (std::chrono::steady_clock::now() - last_commit < commit_interval && !queue_.ended()) continue;
        last_commit = std::chrono::steady_clock::now();
        if (dirty && log_)
            if (const auto committed = log_->commit(); !committed) fail(committed.error());
        dirty = false;
        uncommitted_ = 0;
        look();
    }
    if (log_)
        if (const auto closed = log_->close(); !closed) fail(closed.error());
    const std::scoped_lock lock(mutex_);
    status_.recording = false;
}

void Recorder::write(const Row& row) {
    if (!log_) {
        const std::scoped_lock lock(mutex_);
        ++status_.unsaved;
        return;
    }
    const auto* event = std::get_if<Event>(&row);
    const ResultRow* result = std::get_if<ResultRow>(&row);
    const auto written = event ? log_->add(*event) : log_->addUpdate(result->kind, result->time, result->text);
    ++uncommitted_;
    if (!written) fail(written.error());
}

/// The tracker goes on without a log: it is the vehicle's eye.
void Recorder::fail(const std::string& reason) {
    log_.reset();
    const std::scoped_lock lock(mutex_);
    status_.recording = false;
    status_.error = reason;
    status_.unsaved += uncommitted_;
}

/// How much room there is.
void Recorder::look() {
    if (!log_) return;
    const std::string path = log_->path();
    std::error_code failure;
    const auto space = std::filesystem::space(std::filesystem::path(path).parent_path().empty()
                                                  ? std::filesystem::path(".")
                                                  : std::filesystem::path(path).parent_path(),
                                              failure);
    const std::scoped_lock lock(mutex_);
    status_.path = path;
    status_.bytes = log_->bytes();
    if (failure) return;
    status_.free_bytes = space.available;
    status_.disk = space.available < full_bytes  ? DiskState::Full
                   : space.available < low_bytes ? DiskState::Low
                                                 : DiskState::Good;
}

}  // namespace echotrail
