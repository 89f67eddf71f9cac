#include "fan_fixture.hpp"
#include "pictures.hpp"
#include "ui/chart/area_model.hpp"
#include "ui/chart/mark_model.hpp"

namespace echotrail {
namespace {

using test::echoScene;
using test::FanViewTest;
using test::onlyEchoes;
using test::pictureOf;
using test::shared;

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

}  // namespace
}  // namespace echotrail
