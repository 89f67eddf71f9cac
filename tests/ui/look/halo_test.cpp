#include "ui/views/halo.hpp"

#include <gtest/gtest.h>

#include <QImage>
#include <algorithm>
#include <cmath>
#include <functional>

namespace echotrail {
namespace {

constexpr QSize size(200, 160);

QImage painted(const std::function<void(QPainter&)>& paint, double ratio = 1.0) {
    QImage picture(size * ratio, QImage::Format_ARGB32_Premultiplied);
    picture.setDevicePixelRatio(ratio);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    paint(painter);
    painter.end();
    return picture;
}

/// In pixels: the sum of their opacities.
double area(const QImage& picture) {
    double sum = 0.0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) sum += qAlpha(picture.pixel(x, y)) / 255.0;
    return sum;
}

int mostOpaque(const QImage& picture) {
    int most = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) most = std::max(most, qAlpha(picture.pixel(x, y)));
    return most;
}

QPainterPath line(QPointF from, QPointF to) {
    QPainterPath path(from);
    path.lineTo(to);
    return path;
}

TEST(Strokes, CoverWhatTheirWidthAndLengthComeToAtEveryAngle) {
    for (const double degrees : {0.0, 17.0, 45.0, 80.0, 90.0, 133.0}) {
        const QPointF way(100.0 * std::cos(degrees * 0.0174533), 100.0 * std::sin(degrees * 0.0174533));
        const QPointF from = QPointF(100.3, 80.6) - way / 2.0;
        const auto stroke = [&](QPainter& painter) {
            strokeWithHalo(painter, line(from, from + way), {Qt::white, 1.6}, Qt::transparent);
        };
        EXPECT_NEAR(area(painted(stroke)), 160.0, 5.0) << degrees;
        EXPECT_NEAR(area(painted(stroke, 2.0)), 640.0, 20.0) << degrees;
        const auto with_halo = [&](QPainter& painter) {
            strokeWithHalo(painter, line(from, from + way), {Qt::white, 1.6}, Qt::black);
        };
        EXPECT_NEAR(area(painted(with_halo)), 360.0, 8.0) << degrees;
    }
}

TEST(Strokes, WhatLiesOverItselfCountsOnce) {
    QColor faint(Qt::white);
    faint.setAlpha(100);
    QPainterPath path = line({20, 20}, {180, 140});
    path.lineTo(20, 140);
    path.lineTo(180, 20);
    path.addEllipse(QPointF(100, 80), 40, 40);
    const QImage picture = painted([&](QPainter& painter) {
        strokeWithHalo(painter, path, {faint, 3.0}, Qt::transparent);
    });
    EXPECT_NEAR(mostOpaque(picture), 100, 1);
}

TEST(Strokes, AreTheSameWhereverTheyLie) {
    QPainterPath path;
    path.addEllipse(QPointF(60, 60), 41.3, 22.7);
    const auto stroke = [&](QPoint by) {
        return painted([&](QPainter& painter) {
            painter.translate(by);
            strokeWithHalo(painter, path, {Qt::green, 1.3, {5.0, 3.0}}, Qt::black);
        });
    };
    const QPoint by(37, 23);
    const QImage first = stroke({});
    const QImage moved = stroke(by);
    for (int y = 30; y < 90; ++y)
        for (int x = 10; x < 110; ++x) {
            const QRgb a = first.pixel(x, y);
            const QRgb b = moved.pixel(QPoint(x, y) + by);
            EXPECT_LE(std::abs(qAlpha(a) - qAlpha(b)), 2) << x << " " << y;
            EXPECT_LE(std::abs(qGreen(a) - qGreen(b)), 2) << x << " " << y;
        }
}

TEST(Strokes, DashesAreDrawnAndGapsAreNot) {
    const QImage picture = painted([](QPainter& painter) {
        strokeWithHalo(painter, line({10.0, 50.5}, {190.0, 50.5}), {Qt::white, 1.0, {6.0, 4.0}}, Qt::transparent);
    });
    EXPECT_NEAR(area(picture), 18 * 6.0, 1.0);
    EXPECT_EQ(qAlpha(picture.pixel(12, 50)), 255);
    EXPECT_EQ(qAlpha(picture.pixel(17, 50)), 0);
    EXPECT_EQ(qAlpha(picture.pixel(23, 50)), 255);
}

TEST(Strokes, StayWithinTheClipAndThePicture) {
    const QImage picture = painted([](QPainter& painter) {
        painter.setClipRect(QRect(50, 40, 60, 60));
        strokeWithHalo(painter, line({-1e6, 60.0}, {1e6, 90.0}), {Qt::white, 2.0}, Qt::black);
        strokeWithHalo(painter, line({std::nan(""), 60.0}, {90.0, 90.0}), {Qt::white, 2.0}, Qt::black);
    });
    EXPECT_GT(area(picture), 100.0);
    for (const QPoint outside : {QPoint(30, 75), QPoint(130, 75), QPoint(199, 75)})
        EXPECT_EQ(qAlpha(picture.pixel(outside)), 0);
}

TEST(Dots, CoverTheirDiscs) {
    const QImage picture = painted([](QPainter& painter) {
        fillDots(painter, {{40.2, 50.7}, {90.0, 70.5}}, 4.0, Qt::white);
    });
    EXPECT_NEAR(area(picture), 2.0 * 3.14159 * 16.0, 3.0);
}

TEST(KeptTexts, LookLikeTextsThatAreDrawnOnTheNearestWholePixel) {
    for (const double ratio : {1.0, 2.0})
        for (const QPointF away : {QPointF(0.0, 0.0), QPointF(0.2, 0.1), QPointF(-0.2, -0.2)}) {
            const QPointF place(20.0, 60.0);
            const QImage kept =
                painted([&](QPainter& painter) { keptText(painter, place + away, "T01 26.1 m", Qt::white); }, ratio);
            const QImage drawn = painted(
                [&](QPainter& painter) {
                    painter.setPen(Qt::white);
                    painter.drawText(place, "T01 26.1 m");
                },
                ratio);
            EXPECT_GT(area(drawn), 50.0);
            EXPECT_EQ(kept, drawn) << ratio << " " << away.x();
        }
}

}  // namespace
}  // namespace echotrail
