#include "core/tracking/target_report.hpp"

#include <gtest/gtest.h>

namespace echotrail {
namespace {

constexpr Timestamp start{};

Track trackAt(double north_m, double east_m, double north_mps, double east_mps) {
    Track track;
    track.id = 3;
    track.state = TrackState::Confirmed;
    track.estimate = {start, {north_m, east_m, north_mps, east_mps}, Eigen::Matrix4d::Identity()};
    track.last_seen = start;
    track.particles = {{{static_cast<float>(north_m), static_cast<float>(east_m)}}, {1.0F}, 1.0};
    return track;
}

TEST(TargetReport, PredictsThePlaceAndItsGrowingUncertainty) {
    const TargetReport report = reportOn(trackAt(10, 0, 1, 0), {}, start + microsecondsFromSeconds(2.0));
    EXPECT_NEAR(report.look.position_m.x(), 12.0, 1e-12);
    EXPECT_NEAR(report.look.range_m, 12.0, 1e-12);
    EXPECT_NEAR(report.look.covariance_m2(0, 0), 1.0 + 4.0, 1e-12);
    EXPECT_NEAR(report.age_s, 2.0, 1e-12);
    EXPECT_TRUE(report.valid);
    EXPECT_FALSE(report.look.seen);
}

TEST(TargetReport, BearingIsFromTheBow) {
    const OwnMotion own{{0, 0, Bearing::degrees(90)}, {0, 0}};
    EXPECT_NEAR(reportOn(trackAt(10, 0, 0, 0), own, start).look.bearing.inDegrees(), -90.0, 1e-9);
}

TEST(TargetReport, ATargetOnCollisionCourseIsDangerous) {
    // They close at 2 m/s, half of it the vehicle's own.
    const OwnMotion own{{0, 0, {}}, {1, 0}};
    const TargetReport report = reportOn(trackAt(20, 0, -1, 0), own, start);
    EXPECT_NEAR(report.time_to_closest_s, 10.0, 1e-9);
    EXPECT_NEAR(report.closest_approach_m, 0.0, 1e-9);
    EXPECT_NEAR(report.risk, 1.0, 1e-9);
}

TEST(TargetReport, OneThatPassesFarOffOrGoesAwayIsNot) {
    const TargetReport passing = reportOn(trackAt(20, 8, -1, 0), {}, start);
    EXPECT_NEAR(passing.closest_approach_m, 8.0, 1e-9);
    EXPECT_EQ(passing.risk, 0.0);
    const TargetReport leaving = reportOn(trackAt(20, 0, 1, 0), {}, start);
    EXPECT_EQ(leaving.time_to_closest_s, 0.0);
    EXPECT_EQ(leaving.risk, 0.0);
}

TEST(TargetReport, ALostTargetSteersNothing) {
    Track track = trackAt(10, 0, 0, 0);
    track.state = TrackState::Lost;
    EXPECT_FALSE(reportOn(track, {}, start).valid);
}

}  // namespace
}  // namespace echotrail
