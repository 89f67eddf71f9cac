#pragma once

#include "core/base/result.hpp"
#include "core/base/time.hpp"

#include <string>

namespace echotrail {

/// The folder of recordings, which may not be there yet: `$XDG_DATA_HOME/echotrail/recordings`.
std::string recordingsFolder();

/// A new name by the time (UTC) in the folder of recordings, which is made. The error says that it cannot be made.
Result<std::string> newRecordingPath();

/// What this machine keeps of a tracker's run: named by the tracker and the beginning of its run, so that it is found
/// again; `attempt` counts from 1, where others have the name. Its folder is made.
Result<std::string> keptRecordingPath(const std::string& folder, const std::string& tracker, Timestamp started,
                                      int attempt);

}  // namespace echotrail
