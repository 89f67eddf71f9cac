#include "core/link/link_control.hpp"
#include "tests/core/link/sample_values.hpp"

#include <gtest/gtest.h>

namespace echotrail {
namespace {

using test::at;

TEST(ControlDesk, WhoAsksFirstHoldsIt) {
    ControlDesk desk;
    EXPECT_TRUE(desk.act(ControlAction::Ask, 1, "bridge", at(0)));
    EXPECT_TRUE(desk.holds(1));
    EXPECT_EQ(desk.state().holder_name, "bridge");
    EXPECT_FALSE(desk.holds(0)) << "nobody holds nothing";
}

TEST(ControlDesk, TheHolderGivesItToWhoHasAsked) {
    ControlDesk desk;
    ASSERT_TRUE(desk.act(ControlAction::Ask, 1, "bridge", at(0)));
    ASSERT_TRUE(desk.act(ControlAction::Ask, 2, "shore", at(1)));
    EXPECT_TRUE(desk.holds(1)) << "asking takes nothing";
    EXPECT_EQ(desk.state().asking_name, "shore");
    EXPECT_FALSE(desk.act(ControlAction::Give, 2, "shore", at(2))) << "only the holder gives";
    ASSERT_TRUE(desk.act(ControlAction::Give, 1, "bridge", at(2)));
    EXPECT_TRUE(desk.holds(2));
    EXPECT_EQ(desk.state().asking, 0U);
}

TEST(ControlDesk, WhoKeepsItRefusesWhoHasAsked) {
    ControlDesk desk;
    ASSERT_TRUE(desk.act(ControlAction::Ask, 1, "bridge", at(0)));
    ASSERT_TRUE(desk.act(ControlAction::Ask, 2, "shore", at(1)));
    ASSERT_TRUE(desk.act(ControlAction::Keep, 1, "bridge", at(2)));
    EXPECT_TRUE(desk.holds(1));
    EXPECT_FALSE(desk.act(ControlAction::Take, 2, "shore", at(60))) << "it was refused and has to be asked for again";
}

TEST(ControlDesk, NobodyTakesItBeforeTheHolderHadTimeToAnswer) {
    ControlDesk desk;
    ASSERT_TRUE(desk.act(ControlAction::Ask, 1, "bridge", at(0)));
    EXPECT_FALSE(desk.act(ControlAction::Take, 2, "shore", at(100))) << "it must be asked for first";
    ASSERT_TRUE(desk.act(ControlAction::Ask, 2, "shore", at(100)));
    ASSERT_TRUE(desk.act(ControlAction::Ask, 2, "shore", at(110))) << "asking again does not begin anew";
    const auto early = desk.act(ControlAction::Take, 2, "shore", at(114));
    ASSERT_FALSE(early);
    EXPECT_EQ(early.error(), "bridge has 1 s left to answer");
    EXPECT_TRUE(desk.act(ControlAction::Take, 2, "shore", at(115)));
    EXPECT_TRUE(desk.holds(2));
}

TEST(ControlDesk, OneAsksAtATime) {
    ControlDesk desk;
    ASSERT_TRUE(desk.act(ControlAction::Ask, 1, "bridge", at(0)));
    ASSERT_TRUE(desk.act(ControlAction::Ask, 2, "shore", at(1)));
    EXPECT_FALSE(desk.act(ControlAction::Ask, 3, "pier", at(2)));
    desk.left(2);
    EXPECT_TRUE(desk.act(ControlAction::Ask, 3, "pier", at(3)));
}

TEST(ControlDesk, WhoLeavesLeavesItToWhoHasAskedOrToNobody) {
    ControlDesk desk;
    ASSERT_TRUE(desk.act(ControlAction::Ask, 1, "bridge", at(0)));
    ASSERT_TRUE(desk.act(ControlAction::Ask, 2, "shore", at(1)));
    desk.left(1);
    EXPECT_TRUE(desk.holds(2));
    desk.left(2);
    EXPECT_EQ(desk.state(), LinkControl{});
    EXPECT_TRUE(desk.act(ControlAction::Give, 2, "shore", at(9)).error().size() > 0);
}

}  // namespace
}  // namespace echotrail
