#pragma once

#include "ui/style/palette.hpp"
#include "ui/style/ui_metrics.hpp"

namespace echotrail {

/// The application's style sheet: one template, filled with the palette's roles and with lengths that follow the text.
QString styleSheet(const Palette& palette, const UiMetrics& metrics);

}  // namespace echotrail
