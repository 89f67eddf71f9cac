#include "core/pipelines/sweep_follower.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace echotrail {
namespace {

struct Events {
    int turned = 0, ended = 0;
};

Events follow(const std::vector<double>& bearings_deg, double step_deg = 1.8) {
    SweepFollower follower;
    Events events;
    for (std::size_t i = 0; i < bearings_deg.size(); ++i) {
        const auto step = follower.follow(Bearing::degrees(bearings_deg[i]), radiansFromDegrees(step_deg),
                                          Timestamp(Microseconds(100'000 * static_cast<std::int64_t>(i))));
        events.turned += step.turned_round;
        events.ended += step.sweep_ended;
    }
    return events;
}

TEST(SweepFollower, EndsASweepWhereTheBeamTurnsRound) {
    const Events events = follow({0, 1.8, 3.6, 5.4, 3.6, 1.8, 0, 1.8});
    EXPECT_EQ(events.ended, 2);
    EXPECT_EQ(events.turned, 2);
}

TEST(SweepFollower, EndBearingLoggedTwiceIsOneEnd) { EXPECT_EQ(follow({0, 1.8, 3.6, 3.6, 1.8, 0, 0, 1.8}).ended, 2); }

TEST(SweepFollower, FlybackEndsOneSweepOnly) { EXPECT_EQ(follow({0, 1.8, 3.6, 5.4, 7.2, 0, 1.8, 3.6}).ended, 1); }

TEST(SweepFollower, MissingPingsBreakTheMovementButNotTheSweep) {
    const Events events = follow({0, 1.8, 3.6, 12.6, 14.4});
    EXPECT_EQ(events.turned, 1);
    EXPECT_EQ(events.ended, 0);
}

TEST(SweepFollower, SaysWherePingsComeLate) {
    SweepFollower follower;
    for (int i = 0; i < 5; ++i)
        EXPECT_FALSE(
            follower.follow(Bearing::degrees(1.8 * i), 0.03, Timestamp(Microseconds(100'000 * i))).pings_missing);
    EXPECT_FALSE(follower.follow(Bearing::degrees(9.0), 0.03, Timestamp(Microseconds(600'000))).pings_missing);
    EXPECT_TRUE(follower.follow(Bearing::degrees(10.8), 0.03, Timestamp(Microseconds(1'200'000))).pings_missing);
}

TEST(SweepFollower, FullCircleEndsASweepEachTurnWithoutABreakAcrossTheStern) {
    std::vector<double> bearings;
    for (int i = 0; i < 3 * 200 + 1; ++i) bearings.push_back(std::fmod(90 + 1.8 * i, 360.0));
    const Events events = follow(bearings);
    EXPECT_EQ(events.ended, 3);
    EXPECT_EQ(events.turned, 0);
}

}  // namespace
}  // namespace echotrail
