#pragma once

#include <QColor>
#include <QImage>
#include <QPointF>
#include <QWidget>
#include <cstdlib>

namespace echotrail::test {

inline QImage pictureOf(QWidget& widget, double ratio = 1.0) {
    QImage picture(widget.size() * ratio, QImage::Format_RGB32);
    picture.setDevicePixelRatio(ratio);
    widget.render(&picture);
    return picture;
}

/// Middle of the pixels brighter than any grey of the sample's ground.
inline QPointF brightSpot(const QImage& picture, const QRect& within) {
    double x = 0.0;
    double y = 0.0;
    int count = 0;
    for (int row = within.top(); row <= within.bottom(); ++row)
        for (int column = within.left(); column <= within.right(); ++column) {
            if (qGray(picture.pixel(column, row)) < 170) continue;  // the age ring has 158
            x += column;
            y += row;
            ++count;
        }
    return count > 0 ? QPointF(x / count, y / count) : QPointF(-1, -1);
}

inline int pixelsLike(const QImage& picture, const QColor& colour) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            if (picture.pixel(x, y) == colour.rgb()) ++count;
    return count;
}

/// Those of which no channel differs by more.
inline int pixelsNear(const QImage& picture, const QColor& colour, int most) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            const QRgb pixel = picture.pixel(x, y);
            count += std::abs(qRed(pixel) - colour.red()) <= most && std::abs(qGreen(pixel) - colour.green()) <= most &&
                     std::abs(qBlue(pixel) - colour.blue()) <= most;
        }
    return count;
}

}  // namespace echotrail::test
