#include "core/tracking/track_life.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace echotrail {
namespace {

Timestamp at(double seconds) { return Timestamp(microsecondsFromSeconds(seconds)); }

Track newborn() {
    Track track;
    track.existence = LifeParams().birth_existence;
    track.looks = 1;
    return track;
}

TEST(Existence, EvidenceOfOneChangesNothingAndItStaysAProbability) {
    EXPECT_NEAR(existenceAfter(0.3, 1.0), 0.3, 1e-12);
    EXPECT_GT(existenceAfter(0.3, 20), 0.8);
    EXPECT_LT(existenceAfter(0.9, 0.1), 0.5);
    double r = 0.5;
    for (int i = 0; i < 100; ++i) r = existenceAfter(r, 1e6);
    EXPECT_LT(r, 1.0);
    EXPECT_LT(existenceAfter(r, 1e-9), 0.01);  // still able to change its mind
}

TEST(TrackLife, ConfirmedAtTheThirdClearLookAndNotBefore) {
    Track track = newborn();
    advanceLife(track, LookResult::Seen, 50, at(5), {});
    EXPECT_EQ(track.state, TrackState::Tentative);
    advanceLife(track, LookResult::Seen, 50, at(10), {});
    EXPECT_EQ(track.state, TrackState::Confirmed);
}

TEST(TrackLife, IsNotConfirmedWhileNobodyCanSayWhereItIs) {
    Track track = newborn();
    track.estimate.covariance.topLeftCorner<2, 2>() = Eigen::Vector2d(36.0, 0.01).asDiagonal();
    for (int i = 1; i <= 6; ++i) advanceLife(track, LookResult::Seen, 1e4, at(i), {});
    EXPECT_EQ(track.state, TrackState::Tentative);
    track.estimate.covariance.topLeftCorner<2, 2>() = Eigen::Vector2d(1.0, 0.01).asDiagonal();
    advanceLife(track, LookResult::Seen, 1e4, at(7), {});
    EXPECT_EQ(track.state, TrackState::Confirmed);
}

TEST(TrackLife, CoastsAfterAMissComesBackWithAnEchoAndIsLostAfterFourMisses) {
    Track track = newborn();
    for (int i = 1; i <= 6; ++i) advanceLife(track, LookResult::Seen, 1e4, at(i), {});
    advanceLife(track, LookResult::Missed, 0.5, at(7), {});
    EXPECT_EQ(track.state, TrackState::Coasting);
    advanceLife(track, LookResult::Seen, 50, at(8), {});
    EXPECT_EQ(track.state, TrackState::Confirmed);
    for (int i = 0; i < 3; ++i) advanceLife(track, LookResult::Missed, 0.9, at(9 + i), {});
    EXPECT_EQ(track.state, TrackState::Coasting);
    advanceLife(track, LookResult::Missed, 0.9, at(12), {});
    EXPECT_EQ(track.state, TrackState::Lost);
    reacquire(track, at(13));
    EXPECT_EQ(track.state, TrackState::Confirmed);
}

TEST(TrackLife, WhatWasNotLookedAtIsNoMiss) {
    Track track = newborn();
    for (int i = 1; i <= 3; ++i) advanceLife(track, LookResult::Seen, 100, at(i), {});
    const Track before = track;
    for (int i = 0; i < 20; ++i) advanceLife(track, LookResult::NotLookedAt, 0.1, at(4 + i), {});
    EXPECT_EQ(track.state, TrackState::Confirmed);
    EXPECT_EQ(track.existence, before.existence);
    EXPECT_EQ(track.misses, 0);
}

TEST(TrackLife, SearchWidensUpToALimitAndStaysPositiveDefinite) {
    Track track = newborn();
    track.estimate.covariance << 1, 0, .5, 0, 0, 1, 0, .5, .5, 0, 1, 0, 0, .5, 0, 1;
    const double before = track.estimate.covariance(0, 0);
    widenSearch(track, {});
    EXPECT_NEAR(track.estimate.covariance(0, 0), 1.5 * before, 1e-12);
    for (int i = 0; i < 40; ++i) widenSearch(track, {});
    EXPECT_LE(track.estimate.covariance(0, 0), 64.0 + 1e-9);
    EXPECT_GT(track.estimate.covariance.determinant(), 0);
    EXPECT_EQ(track.estimate.covariance, track.estimate.covariance.transpose());
}

}  // namespace
}  // namespace echotrail
