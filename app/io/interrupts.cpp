#include "app/io/interrupts.hpp"

#include <csignal>

namespace echotrail {
namespace {

volatile std::sig_atomic_t interrupted = 0;

}  // namespace

void catchInterrupts() {
    std::signal(SIGINT, [](int) { interrupted = 1; });
    std::signal(SIGTERM, [](int) { interrupted = 1; });
}

bool isInterrupted() { return interrupted != 0; }

}  // namespace echotrail
