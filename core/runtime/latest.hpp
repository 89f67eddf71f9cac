#pragma once

#include <mutex>
#include <optional>
#include <utility>

namespace echotrail {

/// A mailbox that holds the newest value only: a slow reader misses values, but never delays the writer.
/// Threads: any number of writers and readers; a value is taken once.
template <class T>
class Latest {
public:
    void put(T value) {
        const std::scoped_lock lock(mutex_);
        value_ = std::move(value);
    }

    /// The newest value put since the last take; none if there was no new one.
    std::optional<T> take() {
        const std::scoped_lock lock(mutex_);
        return std::exchange(value_, std::nullopt);
    }

    /// Whether the last value has been taken, so that a writer can spare itself the making of one nobody will see.
    bool empty() const {
        const std::scoped_lock lock(mutex_);
        return !value_;
    }

private:
    mutable std::mutex mutex_;
    std::optional<T> value_;
};

}  // namespace echotrail
