#pragma once

#include "core/data/area.hpp"
#include "ui/chart/mark.hpp"

#include <QList>

class QSettings;

namespace echotrail {

/// What the operator has drawn, kept in the settings: areas that move with the vehicle for every source, marks and
/// areas on the ground for the recording whose local frame they are in. A head polled live begins a new local frame
/// every time, so its `source` is empty and nothing on the ground is kept.
/// What is read is not trusted: items with numbers out of their limits are left out.
struct Chart {
    QList<Mark> marks;
    QList<Area> areas;
};

inline constexpr int most_kept_sources = 50;  ///< the oldest go

Chart loadChart(QSettings& settings, const QString& source);
void saveChart(QSettings& settings, const QString& source, const Chart& chart);

}  // namespace echotrail
