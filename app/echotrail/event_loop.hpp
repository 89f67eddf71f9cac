#pragma once

#include <optional>

namespace echotrail {

/// SIGINT and SIGTERM set a flag from here on, and end nothing by themselves.
void catchInterrupts();
bool isInterrupted();

/// Runs Qt's event loop until SIGINT or SIGTERM, or so many seconds, or QCoreApplication::quit(). Gives the reason, as
/// summaries tell it: "interrupted", "duration reached"; nothing where something else quit.
const char* runEventLoop(std::optional<double> duration_s);

}  // namespace echotrail
