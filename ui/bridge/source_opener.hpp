#pragma once

#include "core/base/result.hpp"
#include "core/data/source.hpp"

#include <QString>
#include <atomic>
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <thread>

namespace echotrail {

/// Opens sources on a thread of its own, so that a slow drive never stops a window.
/// Threads: one owner calls it; the opener given to start() runs elsewhere and must not touch the owner's objects.
class SourceOpener {
public:
    using Outcome = Result<std::unique_ptr<PingSource>>;
    using Opener = std::function<Outcome()>;

    /// Begins to open; what was being opened before is no longer waited for.
    void start(Opener opener);
    /// The result is thrown away when it comes. Reading a file cannot be broken off, so its thread ends by itself.
    void cancel();
    bool busy() const { return current_ != nullptr; }
    /// What came of the newest start(), once.
    std::optional<Outcome> take();

private:
    struct Job {
        std::optional<Outcome> outcome;  ///< written before `done`
        std::atomic<bool> done = false;
        std::jthread thread;  // last, so that it ends before what it writes to
    };
    std::list<std::unique_ptr<Job>> jobs_;
    Job* current_ = nullptr;
};

}  // namespace echotrail
