#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <utility>

namespace echotrail {

/// A queue that never drops: a writer waits where it is full. How full it is can be asked, so that nobody need wait
/// unawares.
/// Threads: any number of writers, one reader.
template <class T>
class BoundedQueue {
public:
    explicit BoundedQueue(std::size_t capacity) : capacity_(capacity) {}

    void push(T value) {
        pushQuietly(std::move(value));
        // Not under the lock: the reader, awake at once, would only wait for it, and on a busy computer the writer that
        // holds it may not go on for milliseconds.
        filled_.notify_one();
    }
    /// The same without waking the reader, who finds it when the time of take() is up.
    void pushQuietly(T value) {
        std::unique_lock lock(mutex_);
        room_.wait(lock, [this] { return queue_.size() < capacity_; });
        queue_.push_back(std::move(value));
    }

    /// Everything there is, as soon as there is something, the queue is closed, or the time is up: then possibly
    /// nothing.
    std::deque<T> take(std::chrono::milliseconds longest_wait) {
        std::unique_lock lock(mutex_);
        filled_.wait_for(lock, longest_wait, [this] { return !queue_.empty() || closed_; });
        std::deque<T> all = std::exchange(queue_, {});
        room_.notify_all();
        return all;
    }

    /// Nothing more will be pushed.
    void close() {
        const std::scoped_lock lock(mutex_);
        closed_ = true;
        filled_.notify_all();
    }
    /// Closed, and all was taken.
    bool ended() const {
        const std::scoped_lock lock(mutex_);
        return closed_ && queue_.empty();
    }
    std::size_t size() const {
        const std::scoped_lock lock(mutex_);
        return queue_.size();
    }

private:
    mutable std::mutex mutex_;
    std::condition_variable filled_, room_;
    std::deque<T> queue_;
    std::size_t capacity_;
    bool closed_ = false;
};

}  // namespace echotrail
