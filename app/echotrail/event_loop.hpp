#pragma once

#include "app/io/interrupts.hpp"

#include <optional>

namespace echotrail {

/// Runs Qt's event loop until SIGINT or SIGTERM, or so many seconds, or QCoreApplication::quit(). Gives the reason, as
/// summaries tell it: "interrupted", "duration reached"; nothing where something else quit.
const char* runEventLoop(std::optional<double> duration_s);

}  // namespace echotrail
