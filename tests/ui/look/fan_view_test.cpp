#include "ui/views/fan_view.hpp"

#include "colour_measures.hpp"
#include "sample_scene.hpp"
#include "ui/chart/area_model.hpp"
#include "ui/chart/mark_model.hpp"
#include "ui/views/orientation.hpp"

#include <gtest/gtest.h>

#include <QApplication>
#include <QTest>
#include <QWheelEvent>

namespace echotrail {
namespace {

using test::shared;

QImage pictureOf(FanView& view, double ratio = 1.0) {
    QImage picture(view.size() * ratio, QImage::Format_RGB32);
    picture.setDevicePixelRatio(ratio);
    view.render(&picture);
    return picture;
}

/// Middle of the pixels brighter than any grey of the sample's ground.
QPointF brightSpot(const QImage& picture, const QRect& within) {
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

int pixelsLike(const QImage& picture, const QColor& colour) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            if (picture.pixel(x, y) == colour.rgb()) ++count;
    return count;
}

Layers onlyEchoes() {
    Layers layers;
    for (bool Layers::*layer :
         {&Layers::regions_kept, &Layers::regions_dropped, &Layers::particles, &Layers::tracks, &Layers::ellipses,
          &Layers::history, &Layers::region_of_interest, &Layers::graticule, &Layers::inset})
        layers.*layer = false;
    return layers;
}

/// The beam points aft, so that only echoes are bright ahead.
Scene echoScene() {
    Scene scene = test::bareScene();
    scene.latest.beam = Bearing::degrees(180.0);
    return scene;
}

class FanViewTest : public testing::Test {
protected:
    FanViewTest() {
        applyTheme(*qApp, Theme::Dusk);
        view_.resize(1000, 900);
        view_.setEcho({EchoMap::Grey, 0.0, 80.0, 0.0});
        view_.show();
        QObject::connect(&view_, &FanView::designated, [this](double range_m, Bearing from_bow) {
            ++designations_;
            range_ = range_m;
            bearing_ = from_bow;
        });
    }
    ~FanViewTest() override { applyFontScale(*qApp, 1.0); }

    /// The view as it is before zooming and dragging.
    FanGeometry geometry() const {
        return fitted(view_.scene()->latest.pose, upOf(*view_.scene(), view_.orientation()),
                      sectorToFit(*view_.scene()), view_.rect(), QMarginsF(44, 58, 44, 22));
    }
    /// The sea stays dark, an echo bright.
    void showOnlyBrightEchoes() {
        view_.setLayers(onlyEchoes());
        view_.setEcho({EchoMap::Grey, 10.0, 60.0, 0.0});
    }
    void click(const QPointF& place, Qt::KeyboardModifiers keys = {}) {
        QTest::mouseClick(&view_, Qt::LeftButton, keys, place.toPoint());
    }

    FanView view_;
    int designations_ = 0;
    double range_ = 0.0;
    Bearing bearing_;
};

TEST_F(FanViewTest, AnEchoAheadIsUpAndOneToStarboardIsRight) {
    Scene scene = echoScene();
    test::brighten(scene.fan, 14.0, 0.0);
    showOnlyBrightEchoes();
    view_.setScene(shared(scene));
    const QPointF head = geometry().head_px;
    const QPointF ahead = brightSpot(pictureOf(view_), QRect(200, 150, 600, 400));
    EXPECT_NEAR(ahead.x(), head.x(), 1.0);
    EXPECT_NEAR(head.y() - ahead.y(), 14.0 * geometry().px_per_m, 2.0);
    Scene starboard = echoScene();
    test::brighten(starboard.fan, 10.0, 5.0);
    view_.setScene(shared(starboard));
    const QPointF right = brightSpot(pictureOf(view_), QRect(200, 150, 600, 500));
    EXPECT_NEAR(right.x() - head.x(), 5.0 * geometry().px_per_m, 2.0);
    EXPECT_NEAR(head.y() - right.y(), 10.0 * geometry().px_per_m, 2.0);
}

TEST_F(FanViewTest, HeadUpTurnsTheGroundAndNorthUpDoesNot) {
    Scene scene = echoScene();
    scene.latest.pose.heading = Bearing::degrees(20.0);
    scene.navigation_known = true;
    test::brighten(scene.fan, 14.0, 0.0);
    showOnlyBrightEchoes();
    view_.setScene(shared(scene));
    const QPointF turned = brightSpot(pictureOf(view_), QRect(120, 150, 700, 450));
    EXPECT_NEAR(degreesFromRadians(geometry().bearingOf(turned).inRadians()), -20.0, 0.3);
    EXPECT_LT(turned.x(), geometry().head_px.x() - 50.0) << "what is north lies to port of a bow of 20°";
    view_.setOrientation(Orientation::NorthUp);
    const QRectF about(geometry().toScreen(14.0, 0.0) - QPointF(60, 60), QSizeF(120, 120));
    const QPointF straight = brightSpot(pictureOf(view_), about.toRect());
    EXPECT_NEAR(straight.x(), geometry().head_px.x(), 1.5);
}

TEST_F(FanViewTest, AnOldBeamIsDarkerButNeverByMoreThanTheFade) {
    Scene scene = test::bareScene();
    scene.fan = test::greyFan(200);
    view_.setLayers(onlyEchoes());
    view_.setEcho({EchoMap::Grey, 0.0, 80.0, most_fade});
    view_.setScene(shared(scene));
    const QImage picture = pictureOf(view_);
    const auto grey = [&](double degrees) {
        return qGray(picture.pixel(geometry().at(14.0, Bearing::degrees(degrees)).toPoint()));
    };
    EXPECT_LT(grey(-40.0), grey(0.0));
    EXPECT_LT(grey(0.0), grey(35.0));
    EXPECT_GE(grey(-44.0), static_cast<int>(grey(35.0) * (1.0 - most_fade)) - 2);
}

TEST_F(FanViewTest, ALayerTurnedOffTakesItsColourAway) {
    view_.setScene(shared(test::fullScene()));
    const auto off = [&](std::initializer_list<bool Layers::*> gone) {
        Layers layers;
        layers.inset = false;
        for (bool Layers::*layer : gone) layers.*layer = false;
        view_.setLayers(layers);
        return pictureOf(view_);
    };
    const Palette& palette = paletteOf(Theme::Dusk);
    EXPECT_GT(pixelsLike(off({}), palette.region), 0);
    EXPECT_EQ(pixelsLike(off({&Layers::regions_kept, &Layers::regions_dropped}), palette.region), 0);
    EXPECT_GT(pixelsLike(off({}), palette.danger), 0);
    EXPECT_EQ(pixelsLike(off({&Layers::tracks, &Layers::ellipses}), palette.danger), 0);
    EXPECT_NE(off({}), off({&Layers::particles}));
    EXPECT_NE(off({}), off({&Layers::region_of_interest}));
    EXPECT_NE(off({}), off({&Layers::history}));
    EXPECT_NE(off({}), off({&Layers::graticule}));
    EXPECT_NE(off({}), off({&Layers::echoes}));
}

TEST_F(FanViewTest, NothingIsBrighterAtNightThanTheMarks) {
    applyTheme(*qApp, Theme::Night);
    Scene scene = test::fullScene();
    scene.fan = test::greyFan(255);
    for (const EchoMap map : echo_maps) {
        view_.setEcho({map, 0.0, 80.0, 0.0});
        view_.setScene(shared(scene));
        const QImage picture = pictureOf(view_);
        const double most = test::luminance(paletteOf(Theme::Night).mark) + 0.002;
        double brightest = 0.0;
        for (int y = 0; y < picture.height(); y += 1)
            for (int x = 0; x < picture.width(); x += 1)
                if (qGray(picture.pixel(x, y)) > 120)
                    brightest = std::max(brightest, test::luminance(QColor(picture.pixel(x, y))));
        EXPECT_LE(brightest, most) << echoMapTitle(map).toStdString();
    }
}

TEST_F(FanViewTest, IsPaintedInEveryPaletteAtEveryTextSizeAndPixelRatio) {
    view_.setScene(shared(test::fullScene()));
    for (const Theme theme : {Theme::Day, Theme::Dusk, Theme::Night})
        for (const double scale : {0.8, 1.0, 1.5, 2.0})
            for (const double ratio : {1.0, 2.0}) {
                applyTheme(*qApp, theme);
                applyFontScale(*qApp, scale);
                const QImage picture = pictureOf(view_, ratio);
                EXPECT_EQ(picture.width(), static_cast<int>(1000 * ratio));
                EXPECT_GT(pixelsLike(picture, paletteOf(theme).track), 20) << scale << " " << ratio;
                EXPECT_GT(pixelsLike(picture, paletteOf(theme).canvas), 1000) << scale << " " << ratio;
            }
}

TEST_F(FanViewTest, EmptyScenesAndNoSceneArePaintedToo) {
    EXPECT_GT(pixelsLike(pictureOf(view_), paletteOf(Theme::Dusk).canvas), 1000);
    view_.setScene(shared(Scene{}));
    EXPECT_GT(pixelsLike(pictureOf(view_), paletteOf(Theme::Dusk).canvas), 1000);
    Scene scene = test::fullScene();
    scene.fan = {};
    view_.setScene(shared(scene));
    view_.resize(10, 10);
    pictureOf(view_);
}

TEST_F(FanViewTest, AClickOnATrackDesignatesIt) {
    view_.setScene(shared(test::fullScene()));
    std::vector<int> selected;
    QObject::connect(&view_, &FanView::trackSelected, [&](int id) { selected.push_back(id); });
    click(geometry().toScreen(16.0, -5.0) + QPointF(4, 3));
    EXPECT_EQ(designations_, 1);
    EXPECT_NEAR(range_, std::hypot(16.0, 5.0), 1e-6) << "the track's place, not the hand's";
    EXPECT_EQ(selected, std::vector<int>{2});
}

TEST_F(FanViewTest, ControlClickOnlySelects) {
    view_.setScene(shared(test::fullScene()));
    click(geometry().toScreen(16.0, -5.0), Qt::ControlModifier);
    EXPECT_EQ(designations_, 0);
    EXPECT_EQ(view_.selectedTrack(), 2);
}

TEST_F(FanViewTest, AClickOnARegionOrAnEchoDesignatesThatPlace) {
    view_.setScene(shared(test::fullScene()));
    click(geometry().toScreen(17.3, 1.2));
    EXPECT_NEAR(range_, std::hypot(17.0, 1.0), 1e-6) << "the region's middle";
    click(geometry().toScreen(13.0, -8.0));
    EXPECT_EQ(designations_, 2);
    EXPECT_NEAR(range_, std::hypot(13.0, 8.0), 0.05);
    EXPECT_NEAR(bearing_.inDegrees(), -31.6, 0.2);
}

TEST_F(FanViewTest, ADragAMeasureOrAClickBeyondTheRangeDesignatesNothing) {
    view_.setScene(shared(test::fullScene()));
    const QPoint from = geometry().toScreen(13.0, -8.0).toPoint();
    QTest::mousePress(&view_, Qt::LeftButton, {}, from);
    QTest::mouseMove(&view_, from + QPoint(80, 40));
    QTest::mouseRelease(&view_, Qt::LeftButton, {}, from + QPoint(80, 40));
    view_.resetView();
    click(QPointF(30, 500));
    view_.setMeasuring(true);
    click(geometry().toScreen(12.0, 2.0));
    EXPECT_EQ(designations_, 0);
}

TEST_F(FanViewTest, TheWheelKeepsThePlaceUnderTheCursor) {
    Scene scene = echoScene();
    test::brighten(scene.fan, 14.0, 3.0);
    showOnlyBrightEchoes();
    view_.setScene(shared(scene));
    const QPointF place = geometry().toScreen(14.0, 3.0);
    QWheelEvent event(place, view_.mapToGlobal(place), {}, {0, 360}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(&view_, &event);
    const QRect about = QRectF(place - QPointF(80, 80), QSizeF(160, 160)).toRect();
    EXPECT_NEAR(QLineF(brightSpot(pictureOf(view_), about), place).length(), 0.0, 2.0);
}

class FanChartTest : public FanViewTest {
protected:
    FanChartTest() {
        view_.setChart(marks_, areas_);
        view_.setScene(shared(test::fullScene()));
    }
    QPoint at(double north, double east) const { return geometry().toScreen(north, east).toPoint(); }
    void drag(QPoint from, QPoint to) {
        QTest::mousePress(&view_, Qt::LeftButton, {}, from);
        QTest::mouseMove(&view_, (from + to) / 2);
        QTest::mouseMove(&view_, to);
        QTest::mouseRelease(&view_, Qt::LeftButton, {}, to);
    }
    QUndoStack undo_;
    MarkModel marks_{undo_};
    AreaModel areas_{undo_};
};

TEST_F(FanChartTest, AMarkGoesUnderTheCursorElseOnTheTarget) {
    EXPECT_EQ(view_.setMark(), 1);
    EXPECT_LT((marks_.marks()[0].place_m - Eigen::Vector2d(12.0, 2.0)).norm(), 1e-9) << "T01 is designated";
    QTest::mouseMove(&view_, at(15.0, -3.0));
    EXPECT_EQ(view_.setMark(), 2);
    EXPECT_LT((marks_.marks()[1].place_m - Eigen::Vector2d(15.0, -3.0)).norm(), 0.05);
}

TEST_F(FanChartTest, AMarkStaysOnTheGroundWhileTheVehicleMoves) {
    view_.setLayers([] {
        Layers layers = onlyEchoes();
        layers.echoes = false;
        return layers;
    }());
    Scene scene = echoScene();
    scene.navigation_known = true;
    view_.setScene(shared(scene));
    marks_.add({12.0, 3.0}, test::scene_time);
    const auto flag = [&] {
        const QPoint staff = (geometry().toScreen(12.0, 3.0) - QPointF(0, 5)).toPoint();
        const QImage picture = pictureOf(view_);
        int most = 0;  // the line may lie between two pixels
        for (const int aside : {-1, 0, 1}) most = std::max(most, qGray(picture.pixel(staff + QPoint(aside, 0))));
        return most;
    };
    EXPECT_GT(flag(), 120);
    scene.latest.pose = {4.0, -2.0, Bearing::degrees(25.0)};
    view_.setScene(shared(scene));
    EXPECT_GT(flag(), 120);
}

TEST_F(FanChartTest, ADragLaysTheMeasureAndItsEndsCanBeDraggedOn) {
    // The platform tells of the cursor at its own time, and its readout is not what is compared: without a cursor.
    const auto picture = [&] {
        QCoreApplication::processEvents();
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(&view_, &leave);
        return pictureOf(view_);
    };
    view_.setMeasuring(true);
    const QImage before = picture();
    drag(at(10.0, 0.0), at(14.0, 0.0));
    const QImage laid = picture();
    EXPECT_NE(before, laid);
    QTest::mouseMove(&view_, at(8.0, 6.0));
    EXPECT_EQ(picture(), laid) << "the end does not follow the hand any more";
    drag(at(10.0, 0.0), at(9.0, 5.0));
    EXPECT_NE(picture(), laid);
    EXPECT_EQ(designations_, 0);
    QTest::keyClick(&view_, Qt::Key_Escape);
    EXPECT_FALSE(view_.measures());
}

TEST_F(FanChartTest, TheMeasureSaysRangeAndBearing) {
    FanGeometry view = geometry();
    view.heading = Bearing::degrees(10.0);
    const Measurement leg{{10.0, 0.0}, {10.0, 4.0}};
    EXPECT_EQ(measuredText(leg, view, true), QString::fromUtf8("4.00 m  090.0°T  080.0°R"));
    EXPECT_EQ(measuredText(leg, view, false), QString::fromUtf8("4.00 m  080.0°R"));
}

TEST_F(FanChartTest, ClicksDrawAGuardZoneThatGoesWithTheVehicle) {
    view_.drawArea(Area::Kind::Guard);
    for (const auto& [north, east] : {std::pair{6.0, -3.0}, {9.0, -3.0}, {9.0, 3.0}, {3.0, 3.0}})
        click(at(north, east));
    QTest::keyClick(&view_, Qt::Key_Backspace);
    click(at(6.0, 3.0));
    EXPECT_TRUE(areas_.areas().isEmpty()) << "not closed yet";
    QTest::keyClick(&view_, Qt::Key_Return);
    ASSERT_EQ(areas_.areas().size(), 1);
    EXPECT_EQ(designations_, 0);
    const Area& zone = areas_.areas()[0];
    EXPECT_TRUE(zone.with_vehicle);
    EXPECT_TRUE(holds(zone, {7.5F, 0.0F}, {}));
    EXPECT_FALSE(holds(zone, {4.5F, 2.5F}, {}));
    EXPECT_FALSE(view_.drawsArea());
}

TEST_F(FanChartTest, EscGivesAnAreaUpAndTwoCornersAreNone) {
    QStringList said;
    QObject::connect(&view_, &FanView::said, [&](const QString& text) { said << text; });
    view_.drawArea(Area::Kind::Veto);
    click(at(6.0, -3.0));
    click(at(9.0, -3.0));
    QTest::keyClick(&view_, Qt::Key_Return);
    EXPECT_EQ(said.size(), 1);
    EXPECT_TRUE(view_.drawsArea());
    QTest::keyClick(&view_, Qt::Key_Escape);
    EXPECT_FALSE(view_.drawsArea());
    EXPECT_TRUE(areas_.areas().isEmpty());
}

TEST_F(FanChartTest, ACornerIsDraggedInOneUndoableStep) {
    areas_.add({Area::Kind::Veto, "", false, {{14.0F, -8.0F}, {17.0F, -8.0F}, {17.0F, -3.0F}}});
    drag(at(14.0, -8.0), at(12.0, -9.0));
    EXPECT_NEAR(areas_.areas()[0].corners_m[0].x(), 12.0F, 0.05F);
    EXPECT_NEAR(areas_.areas()[0].corners_m[0].y(), -9.0F, 0.05F);
    undo_.undo();
    EXPECT_EQ(areas_.areas()[0].corners_m[0].x(), 14.0F);
    EXPECT_EQ(designations_, 0);
    EXPECT_FALSE(view_.isOffCentre()) << "the picture stayed";
}

TEST_F(FanChartTest, WhatTheHandHoldsIsLetGoWhenTheSourceCloses) {
    areas_.add({Area::Kind::Veto, "", false, {{14.0F, -8.0F}, {17.0F, -8.0F}, {17.0F, -3.0F}}});
    QTest::mousePress(&view_, Qt::LeftButton, {}, at(14.0, -8.0));
    view_.setScene(nullptr);
    QTest::mouseMove(&view_, {400, 400});
    QTest::mouseRelease(&view_, Qt::LeftButton, {}, {400, 400});
    EXPECT_EQ(areas_.areas()[0].corners_m[0].x(), 14.0F);
    view_.setScene(shared(test::fullScene()));
    view_.drawArea(Area::Kind::Guard);
    for (const auto& [north, east] : {std::pair{6.0, -3.0}, {9.0, -3.0}, {9.0, 3.0}}) click(at(north, east));
    view_.setScene(nullptr);
    QTest::keyClick(&view_, Qt::Key_Return);
    pictureOf(view_);
    EXPECT_EQ(areas_.areas().size(), 1);
}

TEST_F(FanChartTest, TheCursorsPlaceIsTextForAClipboard) {
    EXPECT_EQ(view_.cursorText(), "");
    Scene scene = test::fullScene();
    view_.setScene(shared(scene));
    QTest::mouseMove(&view_, view_.rect().center());
    EXPECT_TRUE(view_.cursorText().startsWith("N ")) << view_.cursorText().toStdString();
    scene.plane = LocalPlane({radiansFromDegrees(60.0), radiansFromDegrees(5.0)});
    view_.setScene(shared(scene));
    EXPECT_TRUE(view_.cursorText().startsWith("60.000")) << view_.cursorText().toStdString();
}

TEST_F(FanViewTest, CourseUpTurnsTheWayTheVehicleGoesAndNamesWhatItLacks) {
    Scene scene = echoScene();
    scene.latest.pose.heading = Bearing::degrees(20.0);
    EXPECT_TRUE(missingInput(scene, Orientation::NorthUp).contains("heading"));
    EXPECT_TRUE(missingInput(scene, Orientation::CourseUp).contains("position"));
    scene.navigation_known = true;
    EXPECT_TRUE(missingInput(scene, Orientation::CourseUp).contains("moves"));
    EXPECT_EQ(upOf(scene, Orientation::CourseUp).inDegrees(), scene.latest.pose.heading.inDegrees());
    scene.course = Bearing::degrees(50.0);
    EXPECT_TRUE(missingInput(scene, Orientation::CourseUp).isEmpty());
    test::brighten(scene.fan, 10.0, 8.0);
    showOnlyBrightEchoes();
    view_.setOrientation(Orientation::CourseUp);
    view_.setScene(shared(scene));
    const QRectF about(geometry().toScreen(10.0, 8.0) - QPointF(60, 60), QSizeF(120, 120));
    const QPointF seen = brightSpot(pictureOf(view_), about.toRect());
    EXPECT_NEAR(degreesFromRadians(std::atan2(seen.x() - geometry().head_px.x(), geometry().head_px.y() - seen.y())),
                38.7 - 50.0, 0.5);
}

TEST_F(FanViewTest, TheCursorsPlaceCanBePutInTheMiddleAndBack) {
    view_.setScene(shared(test::fullScene()));
    QTest::mouseMove(&view_, {300, 300});
    view_.centreOnCursor();
    EXPECT_TRUE(view_.isOffCentre());
    view_.resetView();
    EXPECT_FALSE(view_.isOffCentre());
}

/// Two sweeps of even sea, and a picture with an echo that is new.
Scene rememberingScene() {
    Scene scene = echoScene();
    EchoMemory memory;
    FanImage fan = test::greyFan(60);
    for (int sweep = 0; sweep < 3; ++sweep) {
        FanImage seen = fan.clone();
        seen.beam_time_ms += sweep * 3000;
        if (sweep == 2) test::brighten(seen, 14.0, 0.0);
        memory.add(seen);
    }
    scene.fan.beam_time_ms += 3 * 3000;
    scene.remembered = memory.remembered();
    return scene;
}

TEST_F(FanViewTest, MovingOnlyTakesAwayWhatIsAlwaysThere) {
    Scene scene = rememberingScene();
    test::brighten(scene.fan, 10.0, 5.0);
    Layers layers = onlyEchoes();
    view_.setLayers(layers);
    view_.setScene(shared(scene));
    const QPoint sea = geometry().toScreen(16.0, -6.0).toPoint();
    const QPoint echo = geometry().toScreen(10.0, 5.0).toPoint();
    EXPECT_GT(qGray(pictureOf(view_).pixel(sea)), 30);
    layers.moving = true;
    view_.setLayers(layers);
    EXPECT_LT(qGray(pictureOf(view_).pixel(sea)), 15);
    EXPECT_GT(qGray(pictureOf(view_).pixel(echo)), 150);
}

TEST_F(FanViewTest, ATrailIsColouredAndNeverHidesAnEcho) {
    Scene scene = rememberingScene();
    Layers layers = onlyEchoes();
    view_.setLayers(layers);
    view_.setScene(shared(scene));
    const QPoint place = geometry().toScreen(14.0, 0.3).toPoint();
    const auto blueness = [&] {
        const QColor pixel(pictureOf(view_).pixel(place));
        return pixel.blue() - pixel.red();
    };
    EXPECT_LT(blueness(), 20);
    layers.trails = true;
    view_.setLayers(layers);
    EXPECT_GT(blueness(), 60);
    test::brighten(scene.fan, 14.0, 0.0);
    view_.setScene(shared(scene));
    EXPECT_GT(QColor(pictureOf(view_).pixel(place)).red(), 150) << "the echo of now";
}

}  // namespace
}  // namespace echotrail
