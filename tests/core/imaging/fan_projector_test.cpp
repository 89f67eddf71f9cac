#include "core/imaging/fan_projector.hpp"

#include "core/base/random.hpp"
#include "core/imaging/wedge_painter.hpp"
#include "tests/core/imaging/fan_fixture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <deque>
#include <limits>

namespace echotrail {
namespace {

constexpr double range_m = 50.0;
constexpr int bins = 200;

/// A turn of the beam seen from a vehicle that moves and yaws; a ping lasts 70 ms.
std::deque<OwnedRay> turnWhileMoving(double north_mps, double east_mps, double yaw_dps, std::uint8_t constant = 0) {
    std::deque<OwnedRay> rays;
    for (int k = 0; k <= 200; ++k) {
        RandomStream random(3, 2, k);
        std::vector<std::uint8_t> levels(bins, constant);
        if (constant == 0)
            for (auto& level : levels) level = static_cast<std::uint8_t>(random.bits() & 0xFF);
        const double time = 0.07 * k;
        rays.emplace_back(std::move(levels), 1.8 * k, range_m / bins);
        Ray& ray = rays.back().ray;
        ray.azimuth_rad = wrapRadians(radiansFromDegrees(1.8 * k + yaw_dps * time));
        ray.turn_rad_per_m = radiansFromDegrees(yaw_dps) / 1500.0;
        ray.origin_north_m = north_mps * time;
        ray.origin_east_m = east_mps * time;
        ray.drift_north = north_mps / 1500.0;
        ray.drift_east = east_mps / 1500.0;
        ray.time_ms = static_cast<std::int32_t>(70 * k);
    }
    return rays;
}

bool sameBytes(const FanImage& a, const FanImage& b) {
    return a.levels.size() == b.levels.size() && a.north_m == b.north_m && a.east_m == b.east_m &&
           std::memcmp(a.levels.data, b.levels.data, a.levels.total()) == 0 &&
           std::memcmp(a.beam_time_ms.data, b.beam_time_ms.data, 4 * a.beam_time_ms.total()) == 0;
}

TEST(FanProjector, APictureThatFollowedTheVehicleEqualsOnePaintedAtOnce) {
    const auto rays = turnWhileMoving(1.0, -0.8, 4.0);
    FanProjector projector({});
    for (const OwnedRay& owned : rays) projector.add(owned.ray, range_m, false);

    FanImage whole = projector.image().clone();
    ASSERT_NE(whole.north_m, 60.0) << "the picture is meant to have moved";
    whole.levels.setTo(0);
    whole.beam_time_ms.setTo(FanImage::never_scanned);
    for (std::size_t k = 1; k < rays.size(); ++k) paintWedge(rays[k - 1].ray, rays[k].ray, {0, range_m}, whole);
    EXPECT_TRUE(sameBytes(projector.image(), whole));
}

TEST(FanProjector, APixelIsA400thOfTheRangeAndTheTileReachesTenMetresFurther) {
    const OwnedRay ray(std::vector<std::uint8_t>(bins, 9), 0, range_m / bins);
    FanProjector projector({});
    EXPECT_TRUE(projector.image().empty());
    projector.add(ray.ray, range_m, false);
    EXPECT_DOUBLE_EQ(projector.image().pixel_m, 0.125);
    EXPECT_EQ(projector.image().levels.size(), cv::Size(961, 961));
    EXPECT_EQ(projector.image().rowOf(0.0), 480.0);
    EXPECT_EQ(projector.image().columnOf(0.0), 480.0);
    EXPECT_EQ(cv::countNonZero(projector.image().levels), 0) << "one line alone encloses nothing";
}

TEST(FanProjector, ConstantEchoesStayConstantWhileTheVehicleMovesAndTurns) {
    FanProjector projector({});
    for (const OwnedRay& owned : turnWhileMoving(1.5, 0.3, -6.0, 90)) projector.add(owned.ray, range_m, false);
    const FanImage& image = projector.image();
    const cv::Mat scanned = image.beam_time_ms != FanImage::never_scanned;
    EXPECT_GT(cv::countNonZero(scanned), 350000);
    EXPECT_EQ(cv::countNonZero((image.levels != 90) & scanned), 0);
}

TEST(FanProjector, NothingIsPaintedAcrossABreak) {
    const auto rays = turnWhileMoving(0, 0, 0);
    FanProjector projector({});
    projector.add(rays[0].ray, range_m, true);
    projector.add(rays[1].ray, range_m, true);
    EXPECT_EQ(cv::countNonZero(projector.image().beam_time_ms != FanImage::never_scanned), 0);
    projector.add(rays[2].ray, range_m, false);
    EXPECT_GT(cv::countNonZero(projector.image().beam_time_ms != FanImage::never_scanned), 2000);
}

TEST(FanProjector, KeepsItsOwnCopyOfTheLastLine) {
    FanProjector projector({}), careful({});
    auto rays = turnWhileMoving(0, 0, 0);
    projector.add(rays[0].ray, range_m, false);
    careful.add(rays[0].ray, range_m, false);
    std::fill(rays[0].levels.begin(), rays[0].levels.end(), std::uint8_t{255});
    projector.add(rays[1].ray, range_m, false);
    rays[0].levels = turnWhileMoving(0, 0, 0)[0].levels;
    careful.add(rays[1].ray, range_m, false);
    EXPECT_TRUE(sameBytes(projector.image(), careful.image()));
}

TEST(FanProjector, AChangeOfRangeKeepsThePicture) {
    FanProjector projector({});
    const auto rays = turnWhileMoving(0, 0, 0, 120);
    for (const OwnedRay& owned : rays) projector.add(owned.ray, range_m, false);
    projector.add(rays.back().ray, range_m / 2, true);  // in: 25 m
    const FanImage& image = projector.image();
    EXPECT_DOUBLE_EQ(image.pixel_m, 0.0625);
    EXPECT_EQ(cv::countNonZero(image.levels != 120), 0) << "the old picture fills the new one";
    EXPECT_EQ(image.beam_time_ms.at<std::int32_t>(100, image.levels.cols / 2 + 3), 0) << "north: the first ping";
    projector.add(rays.back().ray, 2 * range_m, true);  // out: 100 m
    const int shown = static_cast<int>(image.levels.total());
    EXPECT_DOUBLE_EQ(image.pixel_m, 0.25);
    EXPECT_EQ(image.levels.at<std::uint8_t>(image.levels.rows / 2, image.levels.cols / 2 + 100), 120);
    EXPECT_LT(cv::countNonZero(image.levels), shown / 4);
}

TEST(FanProjector, ResetForgets) {
    const auto rays = turnWhileMoving(0, 0, 0, 50);
    FanProjector projector({});
    for (int k = 0; k < 5; ++k) projector.add(rays[k].ray, range_m, false);
    projector.reset();
    EXPECT_TRUE(projector.image().empty());
    projector.add(rays[5].ray, range_m, false);
    EXPECT_EQ(cv::countNonZero(projector.image().levels), 0) << "no wedge with a line from before";
}

TEST(FanProjector, SurvivesPlacesAndRangesThatMakeNoSense) {
    auto rays = turnWhileMoving(0, 0, 0, 50);
    FanProjector projector({});
    projector.add(rays[0].ray, range_m, false);
    rays[1].ray.origin_north_m = std::numeric_limits<double>::quiet_NaN();
    projector.add(rays[1].ray, range_m, false);
    projector.add(rays[2].ray, 0.0, false);
    projector.add(rays[3].ray, -1.0, false);
    EXPECT_EQ(cv::countNonZero(projector.image().levels), 0);
    projector.add(rays[4].ray, range_m, false);
    projector.add(rays[5].ray, range_m, false);
    EXPECT_GT(cv::countNonZero(projector.image().levels), 2000);
}

/// The greatest distance between a point scatterer and its place in a sweep drawn with or without the pings' own poses:
/// 1 m/s ahead, 0.3 m/s to starboard, 4 degrees per second of yaw, a turn in 10 s (method card, section b).
double worstPointError(bool corrected, double scatterer_deg, double scatterer_m) {
    const auto pose_at = [](double t) {
        return Pose{1.0 * t, 0.3 * t, Bearing::degrees(4.0 * t)};  // along the first heading, for simplicity
    };
    const Eigen::Vector2d point =
        Eigen::Vector2d(std::cos(radiansFromDegrees(scatterer_deg)), std::sin(radiansFromDegrees(scatterer_deg))) *
        scatterer_m;
    FanProjector projector({});
    for (int k = 0; k <= 400; ++k) {
        const double t = 10.0 * k / 400;
        Ping ping;
        ping.bearing = Bearing::degrees(0.9 * k);
        ping.step_rad = radiansFromDegrees(0.9);
        ping.sound_speed_mps = 1500;
        ping.bin_interval_s = 2 * 0.125 / 1500;
        ping.levels.assign(400, 0);
        const HeadPolar seen = headFromLocal(point, pose_at(t + scatterer_m / 1500.0), {});
        const double off_axis = std::abs(seen.bearing - ping.bearing) / radiansFromDegrees(1.5);
        const double level = 200.0 * std::exp(-2.0 * off_axis * off_axis);
        const auto bin = static_cast<std::size_t>(seen.range_m / 0.125);
        if (bin < ping.levels.size()) ping.levels[bin] = static_cast<std::uint8_t>(level);
        const Pose at_transmit = corrected ? pose_at(t) : pose_at(0),
                   at_end = corrected ? pose_at(t + 50 / 1500.0) : pose_at(0);
        projector.add(makeRay(ping, at_transmit, at_end, {}, {}), 50.0, k == 0);
    }
    const FanImage& image = projector.image();
    double weight = 0;
    Eigen::Vector2d centre(0, 0);
    for (int row = 0; row < image.levels.rows; ++row)
        for (int column = 0; column < image.levels.cols; ++column) {
            const double level = image.levels.at<std::uint8_t>(row, column);
            weight += level;
            centre += level * Eigen::Vector2d(image.northOf(row), image.eastOf(column));
        }
    return (centre / weight - point).norm();
}

TEST(FanProjector, APointScattererLiesWhereItIsOnlyWithMotionCorrection) {
    for (const double bearing : {60.0, 140.0, 220.0, 300.0}) {
        EXPECT_LE(worstPointError(true, bearing, 30.0), 0.14) << bearing;
        const double uncorrected = worstPointError(false, bearing, 30.0);
        EXPECT_GE(uncorrected, 2.0) << bearing;
        EXPECT_LE(uncorrected, 30.0) << bearing;
    }
}

}  // namespace
}  // namespace echotrail
