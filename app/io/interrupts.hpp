#pragma once

namespace echotrail {

/// SIGINT and SIGTERM set a flag from here on, and end nothing by themselves: whoever owns the event loop looks at it.
void catchInterrupts();
bool isInterrupted();

}  // namespace echotrail
