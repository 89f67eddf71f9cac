#pragma once

#include "core/base/result.hpp"

#include <string>

namespace echotrail {

/// `$XDG_DATA_HOME/echotrail/recordings`, whether or not it is there yet.
std::string recordingsFolder();

/// A new name by the time (UTC) in the folder of recordings, which is made.
/// The error says that the folder cannot be made.
Result<std::string> newRecordingPath();

}  // namespace echotrail
