#pragma once

#include "core/base/result.hpp"
#include "core/data/source.hpp"

#include <memory>
#include <optional>
#include <string>

namespace echotrail {

struct RecordingOptions {
    std::optional<double> sound_speed_mps;    ///< overrides what the file stores
    double default_sound_speed_mps = 1490.0;  ///< where it stores none
    bool without_pings = false;               ///< a log of our own opens even where it holds no ping yet
};

/// Opens a recording read-only, whatever its name: a Seanet Pro log (.V4LOG), or the raw byte stream of a head.
/// The file is gone through once, for its extent; it is never in memory as a whole. A damaged file opens as long as
/// it holds one whole scan line: the counts say what was lost. The error is one line that says what is wrong.
Result<std::unique_ptr<PingSource>> openRecording(const std::string& path, const RecordingOptions& options = {});

}  // namespace echotrail
