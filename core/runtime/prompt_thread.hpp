#pragma once

#include <sched.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>

namespace echotrail {

/// Asks that the calling thread, which works for a moment now and then, runs at once when there is something to do,
/// even where something else keeps every processor busy. With the right to it (root, or a limit RTPRIO of at least 1)
/// it becomes a real-time thread of the lowest priority. Else, since Linux 6.12, it asks for the shortest slices of
/// time: of two that wait the one with the shorter slice goes first, while its share stays what it was. Threads it
/// starts are ordinary ones.
/// Whether one of both was granted; sched_setattr(2).
inline bool becomePrompt() {
    struct Attributes {  // the system's header and that of the C library cannot both be read
        std::uint32_t size = sizeof(Attributes), policy = 0;
        std::uint64_t flags = 1;  // SCHED_FLAG_RESET_ON_FORK
        std::int32_t nice = 0;
        std::uint32_t priority = 0;
        std::uint64_t runtime_ns = 0, deadline_ns = 0, period_ns = 0;
    };
    const auto ask = [](const Attributes& wanted) { return syscall(SYS_sched_setattr, 0, &wanted, 0) == 0; };
    if (ask({.policy = SCHED_RR, .priority = 1})) return true;
    Attributes now;
    if (syscall(SYS_sched_getattr, 0, &now, sizeof now, 0) != 0) return false;
    return ask({.nice = now.nice, .runtime_ns = 100'000});
}

}  // namespace echotrail
