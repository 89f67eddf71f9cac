#include "ui/views/halo.hpp"

#include "ui/views/device_pixels.hpp"
#include "ui/views/stroke_tiles.hpp"

#include <QCache>
#include <QFontMetricsF>
#include <QImage>
#include <array>
#include <cmath>

namespace echotrail {
namespace {

constexpr double halo_width = 1.0;  ///< on either side of the line
constexpr int most_texts = 500;
constexpr double finer = 8.0;  ///< curves become legs that leave them by less than half a pixel divided by this

/// Walks along the corners of a line and takes what its dashes leave of it.
class Dashes {
public:
    Dashes(const QList<double>& lengths, double scale) {
        for (const double length : lengths) lengths_.push_back(length * scale);
    }

    /// `corners` in device pixels, one line. A closed one, whose last corner is its first, has no ends.
    void cut(const QPolygonF& corners, std::vector<StrokeLeg>& legs) const {
        const bool closed = lengths_.empty() && corners.size() > 2 && corners.isClosed();
        std::size_t dash = 0;
        double left = lengths_.empty() ? 0.0 : lengths_[0];  // of this dash or gap
        bool begins = true;
        for (qsizetype i = 0; i + 1 < corners.size(); ++i) {
            const QPointF way = corners[i + 1] - corners[i];
            const double length = std::hypot(way.x(), way.y());
            const bool last = i + 2 == corners.size();
            if (lengths_.empty()) {
                legs.push_back({corners[i], corners[i + 1], closed || i > 0, closed || !last});
                continue;
            }
            for (double at = 0.0; at < length;) {
                const double step = std::min(left, length - at);
                const bool ends = step == left;
                if (dash % 2 == 0)
                    legs.push_back({corners[i] + way * (at / length), corners[i] + way * ((at + step) / length),
                                    !begins, !ends && !last});
                begins = ends;
                at += step;
                left -= step;
                if (!ends) continue;
                dash = (dash + 1) % lengths_.size();
                left = lengths_[dash];
            }
        }
    }

private:
    std::vector<double> lengths_;
};

/// A text with its halo; the same again looks the same.
struct HaloedText {
    QString text;
    QFont font;
    QRgb colour = 0;
    QRgb halo = 0;
    double ratio = 1.0;
    bool operator==(const HaloedText&) const = default;
};

size_t qHash(const HaloedText& it, size_t seed) { return qHashMulti(seed, it.text, it.colour, it.halo); }

/// A text whose width is wanted.
struct MeasuredText {
    QString text;
    QFont font;
    bool operator==(const MeasuredText&) const = default;
};

size_t qHash(const MeasuredText& it, size_t seed) { return qHashMulti(seed, it.text, it.font.weight()); }

/// In device pixels; its offset is from the beginning of the base line to its corner.
QImage pictureOf(const HaloedText& it) {
    // Shifted copies stay as sharp as the text itself.
    static constexpr std::array<std::pair<int, int>, 8> edge{
        {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};
    constexpr int room = 2;  // for the halo, and what letters reach beyond their box
    QImage picture(1, 1, QImage::Format_ARGB32_Premultiplied);
    picture.setDevicePixelRatio(it.ratio);
    const QRectF box = QFontMetricsF(it.font, &picture).boundingRect(it.text).adjusted(-room, -room, room, room);
    const QPoint corner(static_cast<int>(std::floor(box.left() * it.ratio)),
                        static_cast<int>(std::floor(box.top() * it.ratio)));
    const QSize size(static_cast<int>(std::ceil(box.right() * it.ratio)) - corner.x(),
                     static_cast<int>(std::ceil(box.bottom() * it.ratio)) - corner.y());
    picture = QImage(size, QImage::Format_ARGB32_Premultiplied);
    picture.setDevicePixelRatio(it.ratio);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setFont(it.font);
    const QPointF place = -QPointF(corner) / it.ratio;
    painter.setPen(QColor::fromRgba(it.halo));
    for (const auto& [dx, dy] : edge)
        if (qAlpha(it.halo) > 0) painter.drawText(place + QPointF(dx, dy), it.text);
    painter.setPen(QColor::fromRgba(it.colour));
    painter.drawText(place, it.text);
    painter.end();
    picture.setDevicePixelRatio(1.0);
    picture.setOffset(corner);
    return picture;
}

}  // namespace

QPen LineStyle::pen() const {
    QPen pen(colour, width, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
    if (!dashes.isEmpty()) {
        QList<double> pattern;
        for (const double length : dashes) pattern << length / width;
        pen.setDashPattern(pattern);
    }
    return pen;
}

void strokeWithHalo(QPainter& painter, const QPainterPath& path, const LineStyle& style, const QColor& halo) {
    const double scale = deviceScale(painter);
    const double reach = style.width + 2.0 * halo_width;
    const QRectF box = path.controlPointRect().adjusted(-reach, -reach, reach, reach);
    if (scale == 0.0 || (painter.hasClipping() && !painter.clipBoundingRect().intersects(box))) return;
    const Dashes dashes(style.dashes, scale);
    std::vector<StrokeLeg> legs;
    for (QPolygonF& line : path.toSubpathPolygons(painter.deviceTransform() * QTransform::fromScale(finer, finer))) {
        for (QPointF& corner : line) corner /= finer;
        dashes.cut(line, legs);
    }
    paintStroke(painter, legs,
                {0.5 * style.width * scale, (0.5 * style.width + halo_width) * scale, style.colour, halo});
}

void fillDots(QPainter& painter, const QList<QPointF>& places, double radius, const QColor& colour) {
    const QTransform transform = painter.deviceTransform();
    std::vector<StrokeLeg> legs;
    for (const QPointF& place : places) legs.push_back({transform.map(place), transform.map(place), true, true});
    paintStroke(painter, legs, {radius * deviceScale(painter), 0.0, colour, Qt::transparent});
}

double keptWidth(const QPainter& painter, const QFont& font, const QString& text) {
    static QCache<MeasuredText, double> widths(most_texts);
    const MeasuredText wanted{text, font};
    if (const double* width = widths.object(wanted)) return *width;
    const double width = QFontMetricsF(font, painter.device()).horizontalAdvance(text);
    widths.insert(wanted, new double(width));
    return width;
}

void keptText(QPainter& painter, QPointF place, const QString& text, const QColor& colour) {
    textWithHalo(painter, place, text, colour, Qt::transparent);
}

void textWithHalo(QPainter& painter, QPointF place, const QString& text, const QColor& colour, const QColor& halo) {
    if (text.isEmpty()) return;
    static QCache<HaloedText, QImage> pictures(most_texts);
    const HaloedText wanted{text, painter.font(), colour.rgba(), halo.rgba(), deviceScale(painter)};
    QImage* picture = pictures.object(wanted);
    if (!picture) pictures.insert(wanted, picture = new QImage(pictureOf(wanted)));
    const QPointF base = painter.deviceTransform().map(place);
    const DevicePixels pixels(painter);
    painter.drawImage(base.toPoint() + picture->offset(), *picture);  // on whole pixels letters are sharpest
}

}  // namespace echotrail
