#include "ui/views/graticule_painter.hpp"

#include "ui/style/formatter.hpp"
#include "ui/views/device_pixels.hpp"
#include "ui/views/halo.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace echotrail {
namespace {

constexpr double line_opacity = 0.42;
constexpr double outer_opacity = 0.80;
constexpr double head_opacity = 0.75;
constexpr double label_distance =
    26.0;  ///< from the outer ring to the middle of a bearing's label, beyond the age ring

QColor faded(QColor colour, double opacity) {
    colour.setAlphaF(static_cast<float>(opacity));
    return colour;
}

double qtDegrees(double screen_angle) { return 90.0 - degreesFromRadians(screen_angle); }

QPainterPath ring(const FanGeometry& geometry, double range_m) {
    const double radius = range_m * geometry.px_per_m;
    const QRectF box(geometry.head_px - QPointF(radius, radius), QSizeF(2.0 * radius, 2.0 * radius));
    QPainterPath path;
    if (geometry.sector.isFullCircle()) {
        path.addEllipse(box);
        return path;
    }
    const double start = qtDegrees(geometry.screenAngle(geometry.sector.left));
    path.arcMoveTo(box, start);
    path.arcTo(box, start, -degreesFromRadians(geometry.sector.width_rad));
    return path;
}

/// What is painted and with what.
struct Canvas {
    QPainter& painter;
    const FanGeometry& geometry;
    const Palette& palette;
    UiMetrics metrics;
    QRectF view;

    void spoke(Bearing bearing, double from_m, const LineStyle& style) const {
        painter.setPen(style.pen());
        painter.drawLine(geometry.at(from_m, bearing), geometry.at(geometry.sector.range_m, bearing));
    }
};

void paintLines(const Canvas& canvas) {
    const FanGeometry& geometry = canvas.geometry;
    const Sector& sector = geometry.sector;
    const double step = ringStep(sector.range_m);
    const LineStyle dotted{faded(canvas.palette.graticule, line_opacity), 1.0, {1.0, 3.0}};
    canvas.painter.setBrush(Qt::NoBrush);
    canvas.painter.setPen(dotted.pen());
    for (int i = 1; i * step < sector.range_m - 0.1 * step; ++i) canvas.painter.drawPath(ring(geometry, i * step));
    for (int mark = -180; mark < 180; mark += markStep(sector)) {
        const Bearing bearing = Bearing::degrees(mark);
        if (mark != 0 && sector.contains(bearing)) canvas.spoke(bearing, step, dotted);
    }
    const QColor outer = faded(canvas.palette.graticule, outer_opacity);
    canvas.painter.setPen(QPen(outer, 1.0));
    canvas.painter.drawPath(ring(geometry, sector.range_m));
    if (!sector.isFullCircle())
        for (const double share : {0.0, 1.0}) canvas.spoke(sector.left + share * sector.width_rad, 0.0, {outer, 1.0});
    if (sector.contains(Bearing())) canvas.spoke(Bearing(), 0.0, {faded(canvas.palette.mark, head_opacity * 0.6), 1.0});
}

/// The label of a ring beside the sector's edge; where that is out of sight, on the ring at the next bearing in sight.
void paintRingLabel(const Canvas& canvas, double range_m, const QString& text, double side) {
    const FanGeometry& geometry = canvas.geometry;
    const Sector& sector = geometry.sector;
    const QFontMetricsF font(canvas.painter.font(), canvas.painter.device());
    const double width = font.horizontalAdvance(text);
    const Bearing edge = side < 0 ? sector.left : sector.left + sector.width_rad;
    const double gap = canvas.metrics.length(12.0);
    constexpr int tries = 24;
    for (int i = 0; i <= tries / 2; ++i) {
        const Bearing bearing = edge + -side * sector.width_rad * i / tries;
        const double angle = geometry.screenAngle(bearing);
        QPointF place = geometry.at(range_m, bearing);
        // Off the edge, square to it; a full circle has none.
        if (i == 0 && !sector.isFullCircle())
            place += side * (gap + width / 2.0 * std::abs(std::cos(angle))) * QPointF(std::cos(angle), std::sin(angle));
        const QRectF box(place.x() - width / 2.0, place.y() - font.ascent() / 2.0, width, font.ascent());
        if (!canvas.view.contains(box)) continue;
        textWithHalo(canvas.painter, {box.x(), box.bottom() - font.descent() / 2.0}, text,
                     faded(canvas.palette.mark, 0.72), canvas.palette.halo);
        return;
    }
}

void paintRingLabels(const Canvas& canvas) {
    const Sector& sector = canvas.geometry.sector;
    const double step = ringStep(sector.range_m);
    const auto label = [&](double range_m, bool unit) {
        const QString text = Formatter::number(range_m, step < 1.0 ? 1 : 0) + (unit ? " m" : "");
        for (const double side : {-1.0, 1.0}) {
            if (sector.isFullCircle() && side > 0) continue;
            paintRingLabel(canvas, range_m, text, side);
        }
    };
    for (int i = 1; i * step < sector.range_m - 0.1 * step; ++i) label(i * step, false);
    label(sector.range_m, true);
}

void paintBearingLabels(const Canvas& canvas, bool heading_known) {
    const FanGeometry& geometry = canvas.geometry;
    const QFont large = canvas.painter.font();
    const double away = canvas.metrics.length(label_distance) / geometry.px_per_m;
    const QFontMetricsF font(large, canvas.painter.device());
    for (int mark = -180; mark < 180; mark += markStep(geometry.sector)) {
        const Bearing bearing = Bearing::degrees(mark);
        if (!geometry.sector.contains(bearing) &&
            std::abs(bearing - geometry.sector.centre()) > geometry.sector.width_rad / 2.0 + radiansFromDegrees(0.5))
            continue;
        const double angle = geometry.screenAngle(bearing);
        QPointF place = geometry.at(geometry.sector.range_m + away, bearing);
        place += QPointF(canvas.metrics.length(8.0) * std::sin(angle), 0);
        const auto centred = [&](double y, const QString& text, const QColor& colour) {
            textWithHalo(canvas.painter, {place.x() - keptWidth(canvas.painter, large, text) / 2.0, y}, text, colour,
                         canvas.palette.halo);
        };
        const double line = font.height() * 0.92;
        const double first = place.y() + font.ascent() / 2.0 - (heading_known ? line / 2.0 : 0.0);
        centred(first, Formatter::bearingMark(mark), canvas.palette.mark);
        if (!heading_known) continue;
        const long from_north =
            std::lround(degreesFromRadians((bearing + geometry.heading.inRadians()).inRadians()) + 360.0) % 360;
        centred(first + line, QString("%1°T").arg(from_north, 3, 10, QChar('0')), faded(canvas.palette.mark, 0.72));
    }
}

/// Squares that together hold all of a picture that is not transparent: most of a graticule is.
QList<QRect> partsOf(const QImage& picture) {
    constexpr int side = 32;
    QList<QRect> parts;
    const auto isEmpty = [&](const QRect& part) {
        for (int y = part.top(); y <= part.bottom(); ++y) {
            const auto* pixel = reinterpret_cast<const QRgb*>(picture.constScanLine(y));
            if (std::any_of(pixel + part.left(), pixel + part.right() + 1, [](QRgb each) { return each != 0; }))
                return false;
        }
        return true;
    };
    for (int y = 0; y < picture.height(); y += side)
        for (int x = 0; x < picture.width(); x += side)
            if (const QRect part = QRect(x, y, side, side) & picture.rect(); !isEmpty(part)) parts << part;
    return parts;
}

}  // namespace

double ringStep(double range_m) {
    constexpr double most_rings = 6.0;
    const double least = std::max(range_m, 0.1) / most_rings;
    const double decade = std::pow(10.0, std::floor(std::log10(least)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (digit * decade >= least * (1.0 - 1e-9)) return digit * decade;
    return 10.0 * decade;
}

int markStep(const Sector& sector) { return sector.width_rad <= radiansFromDegrees(150.0) ? 15 : 30; }

void GraticulePainter::paint(QPainter& painter, const QSize& size, const FanGeometry& geometry, const Palette& palette,
                             const QFont& font, bool heading_known) {
    // Where the vehicle is does not show in the lines; its heading only through the screen's up.
    FanGeometry fixed = geometry;
    fixed.north_m = fixed.east_m = 0.0;
    fixed.up = Bearing::radians(geometry.up - geometry.heading);
    fixed.heading = Bearing();
    const double ratio = painter.device()->devicePixelRatioF();
    const UiMetrics metrics(font);
    const QFont small = metrics.sized(font, 11.0);
    const Key key{size, fixed, palette.canvas.rgb(), font, ratio};
    if (picture_.isNull() || key != key_) {
        key_ = key;
        picture_ = QImage(size * ratio, QImage::Format_ARGB32_Premultiplied);
        picture_.setDevicePixelRatio(ratio);
        picture_.fill(Qt::transparent);
        QPainter still(&picture_);
        still.setRenderHint(QPainter::Antialiasing);
        still.setFont(small);
        const Canvas canvas{still, fixed, palette, metrics, QRectF(QPointF(), size)};
        paintLines(canvas);
        paintRingLabels(canvas);
        still.end();
        picture_.setDevicePixelRatio(1.0);
        parts_ = partsOf(picture_);
    }
    const QPointF corner = painter.deviceTransform().map(QPointF());
    {
        const DevicePixels pixels(painter);
        for (const QRect& part : parts_) painter.drawImage(corner.toPoint() + part.topLeft(), picture_, part);
    }
    painter.setFont(small);
    paintBearingLabels({painter, geometry, palette, metrics, QRectF(QPointF(), size)}, heading_known);
}

}  // namespace echotrail
