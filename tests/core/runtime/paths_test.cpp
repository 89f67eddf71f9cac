#include "core/runtime/paths.hpp"

#include <gtest/gtest.h>

namespace echotrail {
namespace {

Timestamp at(double seconds) { return Timestamp(std::chrono::seconds(1000)) + microsecondsFromSeconds(seconds); }

/// One metre a second to the east.
TimedPose eastward(double seconds) { return {at(seconds), {0.0, seconds, {}}}; }

TEST(Paths, ALongWatchKeepsBothEndsInBoundedRoom) {
    PathKeeper keeper;
    for (int second = 0; second < 20'000; ++second) keeper.add(eastward(second));
    const auto& path = keeper.paths().vehicle;
    EXPECT_LE(path.size(), PathKeeper::most_points);
    EXPECT_GT(path.size(), PathKeeper::most_points / 4);
    EXPECT_EQ(path.front().pose.east_m, 0.0);
    EXPECT_GT(path.back().pose.east_m, 19'900.0);
}

TEST(Paths, OnlyConfirmedLooksAreKeptAndTheOldestTrackGivesWay) {
    PathKeeper keeper;
    TrackLook look;
    look.time = at(0);
    look.track = 1;
    keeper.add(look);
    EXPECT_TRUE(keeper.paths().tracks.empty()) << "tentative";
    look.state = TrackState::Confirmed;
    for (int id = 1; id <= static_cast<int>(PathKeeper::most_tracks) + 1; ++id) {
        look.track = id;
        look.position_m = {1.0 * id, 2.0};
        keeper.add(look);
    }
    EXPECT_EQ(keeper.paths().tracks.size(), PathKeeper::most_tracks);
    EXPECT_FALSE(keeper.paths().tracks.contains(1));
    EXPECT_EQ(keeper.paths().tracks.at(2).front().place_m.x(), 2.0F);
}

TEST(Paths, TheCourseNeedsMovementAndTime) {
    std::vector<TimedPose> path;
    EXPECT_FALSE(courseOf(path));
    for (int second = 0; second <= 20; ++second) path.push_back(eastward(second));
    ASSERT_TRUE(courseOf(path));
    EXPECT_NEAR(courseOf(path)->inDegrees(), 90.0, 1e-9);
    EXPECT_FALSE(courseOf({path.begin(), path.begin() + 5})) << "not long enough";
    for (TimedPose& pose : path) pose.pose.east_m = 0.0;
    EXPECT_FALSE(courseOf(path)) << "lies still";
}

}  // namespace
}  // namespace echotrail
