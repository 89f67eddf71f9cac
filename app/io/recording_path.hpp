#pragma once

#include "core/base/result.hpp"

#include <string>

namespace echotrail {

/// A new name by the time (UTC) in the folder of recordings, which is made: `$XDG_DATA_HOME/echotrail/recordings/`.
/// The error says that the folder cannot be made.
Result<std::string> newRecordingPath();

}  // namespace echotrail
