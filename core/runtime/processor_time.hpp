#pragma once

#include <time.h>

namespace echotrail {

/// Processor time of the calling thread in seconds, since it began: what others do on the machine does not count.
inline double processorSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace echotrail
