#pragma once

#include "core/runtime/scene.hpp"
#include "ui/views/fan_settings.hpp"

#include <QString>

namespace echotrail {

/// What points up on the screen, from north; the bow where the orientation lacks an input.
Bearing upOf(const Scene& scene, Orientation orientation);
/// Names what an orientation lacks, for a person; empty where it can be honoured.
QString missingInput(const Scene& scene, Orientation orientation);
/// "HEAD UP"
QString orientationBadge(Orientation orientation);

}  // namespace echotrail
