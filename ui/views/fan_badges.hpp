#pragma once

#include "ui/views/badge_painter.hpp"
#include "ui/views/fan_picture.hpp"

namespace echotrail {

/// What the badges in the corners say: the cursor's readout and the tools in hand; how the picture is shown; the sweep
/// and the next look at the target.
QList<BadgeLine> cursorLines(const FanMoment& moment, const Palette& palette);
QList<BadgeLine> viewLines(const FanMoment& moment, const Palette& palette);
QList<BadgeLine> sweepLines(const FanMoment& moment, const Palette& palette);

}  // namespace echotrail
