#include "sample_scene.hpp"
#include "ui/views/beam_schedule.hpp"
#include "ui/views/fan_geometry.hpp"
#include "ui/views/graticule_painter.hpp"
#include "ui/views/track_painter.hpp"

#include <gtest/gtest.h>

namespace echotrail {
namespace {

const Sector ninety{Bearing::degrees(-45.0), radiansFromDegrees(90.0), 20.0};
const QRectF box(0, 0, 1000, 900);

FanGeometry geometryOf(const Pose& pose, Orientation orientation, const Sector& sector = ninety) {
    return fitted(pose, orientation == Orientation::HeadUp ? pose.heading : Bearing(), sector, box, {});
}

TEST(FanGeometry, AheadIsUpAndStarboardIsRightWhenHeadUp) {
    const Pose pose{100.0, -50.0, Bearing::degrees(90.0)};  // bow east
    const FanGeometry geometry = geometryOf(pose, Orientation::HeadUp);
    const QPointF ahead = geometry.toScreen(100.0, -40.0) - geometry.head_px;
    EXPECT_NEAR(ahead.x(), 0.0, 1e-9);
    EXPECT_NEAR(ahead.y(), -10.0 * geometry.px_per_m, 1e-9);
    const QPointF starboard = geometry.toScreen(90.0, -50.0) - geometry.head_px;
    EXPECT_NEAR(starboard.x(), 10.0 * geometry.px_per_m, 1e-9);
    EXPECT_NEAR(starboard.y(), 0.0, 1e-9);
}

TEST(FanGeometry, NorthIsUpWhenNorthUp) {
    const Pose pose{0.0, 0.0, Bearing::degrees(90.0)};
    const FanGeometry geometry = geometryOf(pose, Orientation::NorthUp);
    const QPointF north = geometry.toScreen(10.0, 0.0) - geometry.head_px;
    EXPECT_NEAR(north.x(), 0.0, 1e-9);
    EXPECT_LT(north.y(), 0.0);
    EXPECT_GT(geometry.at(10.0, Bearing()).x(), geometry.head_px.x()) << "the bow points east";
}

TEST(FanGeometry, ScreenAndGroundAgreeBothWays) {
    const Pose pose{3.0, -7.0, Bearing::degrees(-130.0)};
    for (const Orientation orientation : {Orientation::HeadUp, Orientation::NorthUp}) {
        const FanGeometry geometry = geometryOf(pose, orientation);
        const QPointF place(700, 300);
        EXPECT_NEAR(QLineF(geometry.toScreen(geometry.toLocal(place)), place).length(), 0.0, 1e-9);
        EXPECT_NEAR(QLineF(geometry.at(geometry.rangeOf(place), geometry.bearingOf(place)), place).length(), 0.0, 1e-9);
    }
}

TEST(FanGeometry, TheFittedSectorFillsTheBoxAndStaysInside) {
    for (const double width : {60.0, 90.0, 180.0, 270.0, 360.0}) {
        const Sector sector{Bearing::degrees(-width / 2.0), radiansFromDegrees(width), 20.0};
        const FanGeometry geometry = geometryOf({}, Orientation::HeadUp, sector);
        double reach = 0.0;
        for (double degrees = 0.0; degrees <= width; degrees += 1.0) {
            const QPointF rim = geometry.at(20.0, Bearing::degrees(-width / 2.0 + degrees));
            EXPECT_TRUE(box.adjusted(-0.01, -0.01, 0.01, 0.01).contains(rim)) << width << " " << degrees;
            reach = std::max({reach, rim.x() / box.width(), 1.0 - rim.y() / box.height()});
        }
        EXPECT_GT(reach, 0.999) << width;
    }
}

TEST(FanGeometry, TheFullCircleIsInTheMiddle) {
    const FanGeometry geometry =
        geometryOf({}, Orientation::HeadUp, {Bearing::degrees(-180.0), radiansFromDegrees(360.0), 20.0});
    EXPECT_TRUE(geometry.sector.isFullCircle());
    EXPECT_NEAR(QLineF(geometry.head_px, box.center()).length(), 0.0, 1e-6);
}

TEST(BeamSchedule, TheNextLookWaitsForTheBeamToTurnRound) {
    Scene scene = test::bareScene();
    scene.latest.beam = Bearing::degrees(0.0);
    EXPECT_NEAR(*secondsToNextLook(scene, Bearing::degrees(30.0)), 1.0, 1e-9) << "ahead of the beam";
    EXPECT_NEAR(*secondsToNextLook(scene, Bearing::degrees(-15.0)), 3.5, 1e-9) << "to the edge and back";
    scene.turns_clockwise = false;
    EXPECT_NEAR(*secondsToNextLook(scene, Bearing::degrees(-15.0)), 0.5, 1e-9);
    EXPECT_FALSE(secondsToNextLook(scene, Bearing::degrees(60.0))) << "outside the sector";
    scene.sweep_s = 0.0;
    EXPECT_FALSE(secondsToNextLook(scene, Bearing::degrees(0.0))) << "no sweep was whole yet";
}

TEST(BeamSchedule, AgesGrowAwayFromTheBeam) {
    const Scene scene = test::bareScene();
    const BeamAges ages = beamAges(scene, sectorOf(scene));
    ASSERT_EQ(ages.age_s.size(), 91U);
    EXPECT_NEAR(ages.oldest_s, 3.0, 0.1);
    EXPECT_NEAR(static_cast<double>(ages.age_s[90]), 0.0, 0.1);
    EXPECT_NEAR(static_cast<double>(ages.age_s[45]), 1.5, 0.1);
}

TEST(BeamSchedule, WithoutNewEchoesThePictureAges) {
    Scene scene = test::bareScene();
    scene.picture_age_s = 12.0;
    const BeamAges ages = beamAges(scene, sectorOf(scene));
    EXPECT_NEAR(ages.oldest_s, 15.0, 0.1);
    EXPECT_NEAR(static_cast<double>(ages.age_s[90]), 12.0, 0.1);
}

TEST(BeamSchedule, AGrowingSectorIsFittedSymmetrically) {
    Scene scene = test::bareScene();
    scene.sweep_s = 0.0;
    scene.sector_right = Bearing::degrees(-40.0);
    const Sector sector = sectorToFit(scene);
    EXPECT_NEAR(sector.left.inDegrees(), -45.0, 1e-9);
    EXPECT_NEAR(degreesFromRadians(sector.width_rad), 90.0, 1e-9);
}

TEST(Graticule, RingsAreRoundAndNeitherFewNorMany) {
    EXPECT_EQ(ringStep(10.0), 2.0);
    EXPECT_EQ(ringStep(50.0), 10.0);
    for (double range = 2.0; range <= 450.0; range *= 1.07) {
        const double rings = range / ringStep(range);
        EXPECT_GE(rings, 2.4) << range;
        EXPECT_LE(rings, 6.001) << range;
    }
}

TEST(Ellipse, ReachesItsDeviationsAlongItsAxes) {
    Eigen::Matrix2d covariance;
    covariance << 4.0, 0.0, 0.0, 1.0;
    double north = 0.0;
    double east = 0.0;
    for (const Eigen::Vector2d& corner : ellipseOutline({10.0, 0.0}, covariance, 2.0)) {
        north = std::max(north, corner.x() - 10.0);
        east = std::max(east, corner.y());
    }
    EXPECT_NEAR(north, 4.0, 0.02);
    EXPECT_NEAR(east, 2.0, 0.02);
}

}  // namespace
}  // namespace echotrail
