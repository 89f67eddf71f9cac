#pragma once

#include "core/runtime/scene.hpp"
#include "ui/style/palette.hpp"
#include "ui/style/ui_metrics.hpp"
#include "ui/views/beam_schedule.hpp"

#include <QPainter>

namespace echotrail {

/// The line where the beam is, outside the fan the ring that says how old each bearing's echoes are (bright: new),
/// a tick at the target's bearing, and the own vehicle.
void paintBeam(QPainter& painter, const Scene& scene, const BeamAges& ages, const FanGeometry& geometry,
               const Palette& palette, const UiMetrics& metrics);

}  // namespace echotrail
