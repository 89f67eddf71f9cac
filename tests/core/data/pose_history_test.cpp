#include <gtest/gtest.h>

#include "core/data/pose.hpp"

namespace echotrail {
namespace {

Timestamp at(double seconds) { return Timestamp(microsecondsFromSeconds(seconds)); }

TEST(PoseHistory, WithoutNavigationEveryPoseIsTheIdentity) {
    EXPECT_EQ(PoseHistory().at(at(5), 0.3), Pose{});
}

TEST(PoseHistory, InterpolatesAndTurnsTheShortWayRound) {
    PoseHistory history;
    history.add({at(0), {0, 0, Bearing::degrees(350)}});
    history.add({at(1), {2, -4, Bearing::degrees(10)}});
    const auto pose = history.at(at(0.25), 1.0);
    ASSERT_TRUE(pose);
    EXPECT_NEAR(pose->north_m, 0.5, 1e-9);
    EXPECT_NEAR(pose->east_m, -1.0, 1e-9);
    EXPECT_NEAR(pose->heading.inDegrees(), -5.0, 1e-9);
}

TEST(PoseHistory, SaysThereIsAGapRatherThanGuessing) {
    PoseHistory history;
    history.add({at(0), {}});
    history.add({at(10), {}});
    EXPECT_TRUE(history.at(at(0.2), 0.3));
    EXPECT_FALSE(history.at(at(5), 0.3));
    EXPECT_FALSE(history.at(at(11), 0.3));
    EXPECT_FALSE(history.at(at(-1), 0.3));
}

TEST(PoseHistory, IsNotChangedByASampleThatComesLaterThanTheGap) {
    PoseHistory history;
    history.add({at(0), {}});
    const auto early = history.at(at(0.2), 0.3);
    history.add({at(0.6), {10, 0, {}}});
    EXPECT_EQ(history.at(at(0.2), 0.3), early);
}

TEST(PoseHistory, ForgetsWhatIsOldInTime) {
    PoseHistory history;
    for (int i = 0; i < 1000; ++i) {
        history.add({at(i), {1.0 * i, 0, {}}});
        history.forgetBefore(at(i - 100));
        EXPECT_TRUE(history.at(at(std::max(0, i - 100)), 0.3));
    }
    EXPECT_FALSE(history.at(at(700), 0.3));
    EXPECT_EQ(history.at(at(950), 0.3)->north_m, 950.0);
}

TEST(PoseHistory, RefusesSamplesOutOfOrder) {
    PoseHistory history;
    history.add({at(1), {1, 0, {}}});
    history.add({at(0.5), {9, 0, {}}});
    history.add({at(1), {9, 0, {}}});
    EXPECT_EQ(history.refused(), 2u);
    EXPECT_EQ(history.at(at(1), 0.3)->north_m, 1.0);
}

}  // namespace
}  // namespace echotrail
