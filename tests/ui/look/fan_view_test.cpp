#include "colour_measures.hpp"
#include "fan_fixture.hpp"
#include "pictures.hpp"
#include "ui/views/fan_badges.hpp"

#include <QWheelEvent>

namespace echotrail {
namespace {

using test::brightSpot;
using test::echoScene;
using test::FanViewTest;
using test::onlyEchoes;
using test::pictureOf;
using test::pixelsLike;
using test::pixelsNear;
using test::shared;

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
    EXPECT_GT(pixelsNear(off({}), palette.region, 40), 20);
    EXPECT_EQ(pixelsNear(off({&Layers::regions_kept, &Layers::regions_dropped}), palette.region, 40), 0);
    EXPECT_GT(pixelsLike(off({}), palette.danger), 0);
    EXPECT_EQ(pixelsLike(off({&Layers::tracks, &Layers::ellipses}), palette.danger), 0);
    EXPECT_NE(off({}), off({&Layers::particles}));
    EXPECT_NE(off({}), off({&Layers::region_of_interest}));
    EXPECT_NE(off({}), off({&Layers::history}));
    EXPECT_NE(off({}), off({&Layers::graticule}));
    EXPECT_NE(off({}), off({&Layers::echoes}));
}

TEST_F(FanViewTest, ATracksNameStandsBesideItsSymbol) {
    view_.setScene(test::shared(test::fullScene()));
    const QImage without = pictureOf(view_);
    view_.setTrackNames({{1, "buoy"}});
    EXPECT_NE(pictureOf(view_), without);
    view_.setTrackNames({});
    EXPECT_EQ(pictureOf(view_), without);
}

TEST_F(FanViewTest, TheInsetIsTitledWithTheTracksNameAsFarAsThereIsRoom) {
    Layers layers = test::onlyEchoes();
    layers.echoes = false;
    layers.inset = true;
    view_.setLayers(layers);
    view_.setScene(test::shared(test::fullScene()));
    // The title's line, and the edge beside it that stays clear, from the right edge of the inset.
    const QRect inset(view_.width() - 208, view_.height() - 208, 200, 200);
    const QColor ink = paletteOf(Theme::Dusk).track;
    const auto titleEnd = [&] {
        const QImage picture = pictureOf(view_);
        int end = 0;
        for (int x = 0; x < inset.width(); ++x)
            for (int y = 4; y < 20; ++y)
                if (picture.pixelColor(inset.x() + x, inset.y() + y) == ink) end = x;
        return end;
    };
    const int bare = titleEnd();
    EXPECT_GT(bare, 20);
    view_.setTrackNames({{1, "buoy"}});
    EXPECT_GT(titleEnd(), bare + 15);
    view_.setTrackNames({{1, QString(16, 'W')}});
    EXPECT_GT(titleEnd(), inset.width() - 40);
    EXPECT_LE(titleEnd(), inset.width() - 8) << "too long, it ends in an ellipsis and the magnification";
}

TEST_F(FanViewTest, TheNextLookIsAtTheTracksName) {
    const Scene scene = test::fullScene();
    const BeamAges ages;
    FanMoment moment;
    moment.scene = &scene;
    moment.ages = &ages;
    const auto said = [&] { return sweepLines(moment, paletteOf(Theme::Dusk)).back().front().text; };
    EXPECT_EQ(said(), "Next look at T01 in ");
    moment.track_names = {{1, "buoy"}};
    EXPECT_EQ(said(), "Next look at T01 buoy in ");
    moment.track_names = {{1, "the eastern buoy"}};
    EXPECT_EQ(said(), QString::fromUtf8("Next look at T01 the eastern… in "));
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
