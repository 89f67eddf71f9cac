#pragma once

#include "ui/style/palette.hpp"
#include "ui/style/ui_metrics.hpp"
#include "ui/views/fan_geometry.hpp"

#include <QFont>
#include <QImage>
#include <QList>
#include <QPainter>

namespace echotrail {

/// Distance between range rings: a round number that gives three to six of them.
double ringStep(double range_m);
/// Degrees between bearing marks.
int markStep(const Sector& sector);

/// Range rings, bearing lines, the sector's edges and their labels. All but the labels of true bearings are kept as
/// a picture until the geometry, the colours or the text size change.
class GraticulePainter {
public:
    void paint(QPainter& painter, const QSize& size, const FanGeometry& geometry, const Palette& palette,
               const QFont& font, bool heading_known);

private:
    struct Key {
        QSize size;
        FanGeometry geometry;
        QRgb canvas = 0;
        QFont font;
        double device_pixel_ratio = 0.0;
        bool operator==(const Key&) const = default;
    };
    Key key_;
    QImage picture_;
    QList<QRect> parts_;  ///< of it where there is something, in its pixels
};

}  // namespace echotrail
