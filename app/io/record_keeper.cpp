#include "app/io/record_keeper.hpp"

#include "app/io/recording_path.hpp"
#include "core/link/link_limits.hpp"

#include <algorithm>
#include <filesystem>

namespace echotrail {
namespace {

constexpr int commit_ms = 500, look_ms = 250;
constexpr std::size_t first_batch = 8 * 1024;
constexpr Microseconds too_long{500'000}, short_enough{200'000};
constexpr std::uint64_t fewest_free_bytes = 200'000'000;
constexpr int most_attempts = 100;

}  // namespace

RecordKeeper::RecordKeeper(std::string folder, std::string recording)
    : folder_(std::move(folder)), recording_(std::move(recording)), batch_(first_batch), commit_(this), look_(this) {
    commit_.setInterval(commit_ms);
    connect(&commit_, &QTimer::timeout, this, &RecordKeeper::commit);
    look_.setInterval(look_ms);
    look_.setSingleShot(true);
    connect(&look_, &QTimer::timeout, this, [this] {
        if (!up_ || !fetch_ || asked_) return;
        asked_ = fetch_->lookForMore(batch_);
        Q_EMIT wantsRows({name_, *asked_});
    });
}

RecordKeeper::~RecordKeeper() { close(); }

void RecordKeeper::linkUp(const std::string& tracker) {
    up_ = true;
    tracker_ = tracker;
    asked_.reset();
    failed_ = false;  // there may be room again
    Q_EMIT wantsDescription(recording_);
    publish(true);
}

void RecordKeeper::linkDown() {
    up_ = false;
    asked_.reset();
    look_.stop();
    commit();
    publish(false);
}

/// After every break: the tracker may have been started anew meanwhile.
void RecordKeeper::takeRecording(const LinkRecording& recording) {
    if (!up_ || failed_) return;
    if (fetch_ && recording.log.header == header_) return askNext();
    if (fetch_) {
        const std::string before = name_;
        close();
        Q_EMIT leftBehind(before);
    }
    if (const auto begun = begin(recording); !begun) return fail(begun.error());
    askNext();
}

Result<void> RecordKeeper::begin(const LinkRecording& recording) {
    header_ = recording.log.header;
    name_ = recording.name;
    const auto path = findPlace(header_);
    if (!path) return Error{path.error()};
    auto copy = LogCopy::open(*path, header_);
    if (!copy) return Error{copy.error()};
    fetch_.emplace(*std::move(copy), recording.log, follows());
    commit_.start();
    return {};
}

/// A copy that was begun before, or a name that is free.
Result<std::string> RecordKeeper::findPlace(const LogHeader& header) {
    for (int attempt = 1; attempt <= most_attempts; ++attempt) {
        auto path = keptRecordingPath(folder_, tracker_, header.started, attempt);
        if (!path) return path;
        std::error_code failure;
        if (std::filesystem::exists(*path, failure) && !LogCopy::isOf(*path, header)) continue;
        lock_ = std::make_unique<QLockFile>(QString::fromStdString(*path + ".lock"));
        lock_->setStaleLockTime(0);  // but that of a process that is gone
        if (lock_->tryLock()) return path;
        return Error{"another window here keeps it already: " + *path};
    }
    return Error{"too many recordings in " + folder_ + " have its name"};
}

void RecordKeeper::askNext() {
    if (!up_ || !fetch_ || asked_) return;
    asked_ = fetch_->next(batch_);
    if (asked_) {
        Q_EMIT wantsRows({name_, *asked_});
    } else if (follows()) {
        look_.start();
    } else {
        close();
        Q_EMIT finished();
        return;
    }
    publish(true);
}

void RecordKeeper::takeRows(const LinkRows& rows, Microseconds beyond) {
    if (!asked_ || !fetch_) return;
    const LogRowsWanted wanted = *std::exchange(asked_, std::nullopt);
    if (beyond > too_long)
        batch_ = std::max(batch_ / 2, link_limits::fewest_rows);
    else if (beyond < short_enough)
        batch_ = std::min(batch_ * 2, link_limits::longest_rows);
    if (const auto taken = fetch_->take(wanted, rows.rows); !taken) return fail(taken.error());
    askNext();
}

void RecordKeeper::takeRefusal(const std::string& reason) {
    asked_.reset();
    if (!up_) return;  // the link was lost before the answer came
    fail(reason);
}

void RecordKeeper::commit() {
    if (!fetch_) return;
    if (const auto done = fetch_->copy().commit(); !done) return fail(done.error());
    std::error_code failure;
    const auto space = std::filesystem::space(folder_, failure);
    const std::uint64_t free_bytes = failure ? 0 : space.available;
    {
        const std::scoped_lock lock(mutex_);
        published_.free_bytes = free_bytes;
    }
    if (!failure && free_bytes < fewest_free_bytes)
        return fail("only " + std::to_string(free_bytes / 1'000'000) + " MB are free in " + folder_);
    publish(up_);
}

void RecordKeeper::close() {
    commit_.stop();
    look_.stop();
    asked_.reset();
    if (!fetch_) return;
    const auto closed = fetch_->copy().close();
    publish(false);
    if (!closed) {
        const std::scoped_lock lock(mutex_);
        published_.error = closed.error();
    }
    fetch_.reset();
    lock_.reset();
}

/// Nothing else ends with it: the picture goes on.
void RecordKeeper::fail(const std::string& reason) {
    failed_ = true;
    close();
    {
        const std::scoped_lock lock(mutex_);
        published_.asking = false;
        published_.error = reason;
    }
    Q_EMIT finished();
}

void RecordKeeper::publish(bool asking) {
    const std::scoped_lock lock(mutex_);
    published_.asking = asking;
    if (!fetch_) return;
    published_.name = name_;
    published_.path = fetch_->copy().path();
    published_.bytes = fetch_->copy().bytes();
    published_.rows = fetch_->progress();
    published_.whole = published_.rows.rows == published_.rows.there;
}

KeptRecording RecordKeeper::state() const {
    const std::scoped_lock lock(mutex_);
    return published_;
}

}  // namespace echotrail
