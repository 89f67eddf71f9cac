#include "core/imaging/ray.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace echotrail {
namespace {

constexpr Timestamp first_ping{std::chrono::seconds(1'000'000)};

Ping pingAt(double head_degrees) {
    Ping ping;
    ping.time = first_ping + std::chrono::milliseconds(1234);
    ping.bearing = Bearing::degrees(head_degrees);
    ping.step_rad = radiansFromDegrees(0.9);
    ping.bin_interval_s = 40e-6;
    ping.sound_speed_mps = 1500.0;
    ping.levels.assign(1000, 7);  // 30 m
    return ping;
}

HeadSettings oddMounting(bool inverted) {
    HeadSettings mount;
    mount.mount_inverted = inverted;
    mount.mount_heading_deg = -35.0;
    mount.mount_forward_m = 1.7;
    mount.mount_starboard_m = -0.4;
    return mount;
}

TEST(Frames, HeadToLocalAndBackComesOutTheSame) {
    for (const bool inverted : {false, true}) {
        const HeadSettings mount = oddMounting(inverted);
        for (int degrees = -180; degrees < 180; degrees += 11) {
            const Pose vehicle{123.4, -987.6, Bearing::degrees(3.0 * degrees)};
            const HeadPolar seen{0.5 + 0.25 * (degrees + 180), Bearing::degrees(degrees)};
            const Eigen::Vector2d place = localFromHead(seen, vehicle, mount);
            const HeadPolar back = headFromLocal(place, vehicle, mount);
            EXPECT_NEAR(back.range_m, seen.range_m, 1e-9);
            EXPECT_NEAR(back.bearing - seen.bearing, 0.0, 1e-9);
            EXPECT_LT((localFromHead(back, vehicle, mount) - place).norm(), 1e-3);
        }
    }
}

TEST(Frames, TheHeadsZeroIsAhead) {
    const Pose vehicle{10.0, 20.0, Bearing::degrees(90)};  // the bow points east
    const Eigen::Vector2d ahead = localFromHead({5.0, Bearing::degrees(0)}, vehicle, {});
    EXPECT_LT((ahead - Eigen::Vector2d(10, 25)).norm(), 1e-9);
    const Eigen::Vector2d starboard = localFromHead({5.0, Bearing::degrees(90)}, vehicle, {});
    EXPECT_LT((starboard - Eigen::Vector2d(5, 20)).norm(), 1e-9);
}

TEST(Frames, AnInvertedHeadIsMirrored) {
    HeadSettings mount;
    mount.mount_inverted = true;
    const Eigen::Vector2d port = localFromHead({5.0, Bearing::degrees(90)}, {}, mount);
    EXPECT_LT((port - Eigen::Vector2d(0, -5)).norm(), 1e-9);
    mount.mount_heading_deg = 180.0;  // looks aft, and still turns the other way round
    const Eigen::Vector2d aft = localFromHead({5.0, Bearing::degrees(90)}, {}, mount);
    EXPECT_LT((aft - Eigen::Vector2d(0, 5)).norm(), 1e-9);
}

TEST(Frames, TheMountingShiftsAndTurnsTheHead) {
    HeadSettings mount;
    mount.mount_heading_deg = 90.0;
    mount.mount_forward_m = 2.0;
    mount.mount_starboard_m = 1.0;
    const Pose vehicle{0.0, 0.0, Bearing::degrees(-90)};  // the bow points west, starboard north
    const Eigen::Vector2d place = localFromHead({3.0, Bearing::degrees(0)}, vehicle, mount);
    EXPECT_LT((place - Eigen::Vector2d(1 + 3, -2)).norm(), 1e-9);
    const HeadPolar from_bow = bowPolarFromLocal(place, vehicle, mount);
    EXPECT_NEAR(from_bow.range_m, 3.0, 1e-9);
    EXPECT_NEAR(from_bow.bearing.inDegrees(), 90.0, 1e-9);
}

TEST(Ray, AnEchoLiesWhereTheHeadWasMidFlight) {
    // The vehicle moves and yaws; at range r the pose is that at t + r / c.
    const HeadSettings mount = oddMounting(false);
    const Ping ping = pingAt(60);
    const auto pose_after = [](double seconds) {
        return Pose{5 + 2.0 * seconds, -3 + 0.7 * seconds, Bearing::degrees(30 + 20 * seconds)};
    };
    const Ray ray = makeRay(ping, pose_after(0), pose_after(30.0 / 1500.0), mount, first_ping);
    for (const double range : {0.0, 1.0, 12.5, 30.0}) {
        const Eigen::Vector2d place = localFromHead({range, ping.bearing}, pose_after(range / 1500.0), mount);
        EXPECT_LT((ray.at(range) - place).norm(), 1e-3) << range;
    }
    EXPECT_EQ(ray.time_ms, 1234);
    EXPECT_DOUBLE_EQ(ray.farEnd(), 30.0);
    EXPECT_EQ(ray.levels.data(), ping.levels.data());
}

TEST(Ray, TurningThroughNorthTakesTheShortWay) {
    const Ping ping = pingAt(0);
    const Ray ray = makeRay(ping, {0, 0, Bearing::degrees(179.5)}, {0, 0, Bearing::degrees(-179.5)}, {}, first_ping);
    EXPECT_NEAR(ray.turn_rad_per_m * 30.0, radiansFromDegrees(1.0), 1e-12);
}

TEST(Ray, WithoutBinsItStandsStill) {
    Ping ping = pingAt(0);
    ping.levels.clear();
    const Ray ray = makeRay(ping, {}, {1, 1, Bearing::degrees(5)}, {}, first_ping);
    EXPECT_EQ(ray.drift_north, 0.0);
    EXPECT_EQ(ray.turn_rad_per_m, 0.0);
}

}  // namespace
}  // namespace echotrail
