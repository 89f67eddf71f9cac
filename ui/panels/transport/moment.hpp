#pragma once

#include "core/base/time.hpp"

#include <QString>
#include <optional>

namespace echotrail {

/// Reads a moment as people type it into "Go to": `83.5` or `83.5 s` seconds from `start`; `1:23.5` or `0:01:23.5` the
/// same; `2010-05-23T08:00:12.950`, with a space or a Z if wanted, UTC. Nothing for any other text.
std::optional<Timestamp> momentFromText(const QString& text, Timestamp start);

/// "00:01:23.5": time since the start of a recording.
QString elapsedText(double seconds);

}  // namespace echotrail
