#include "core/evaluation/truth.hpp"

#include <gtest/gtest.h>

namespace echotrail {
namespace {

const Timestamp start{Microseconds(1'000'000'000)};
Timestamp after(double seconds) { return start + microsecondsFromSeconds(seconds); }

TEST(Truth, IsStraightBetweenSamplesAndNowhereElse) {
    const auto truth = Truth::read(
        "t,target,north_m,east_m,velocity_north_mps,velocity_east_mps,visible\n"
        "0,0,10,0,1,0,1\r\n2,0,12,4,1,2,0\n",
        start);
    ASSERT_TRUE(truth) << truth.error();
    EXPECT_TRUE(truth->at(0, after(1))->position_m.isApprox(Eigen::Vector2d(11, 2)));
    EXPECT_TRUE(truth->at(0, after(1))->velocity_mps.isApprox(Eigen::Vector2d(1, 1)));
    EXPECT_TRUE(truth->hasVelocities());
    EXPECT_TRUE(truth->at(0, after(0.5))->visible);
    EXPECT_FALSE(truth->at(0, after(1.5))->visible);
    EXPECT_FALSE(truth->at(0, after(-0.1)));
    EXPECT_FALSE(truth->at(0, after(2.1)));
}

TEST(Truth, AsSeenFromTheHeadTurnsTheShortWay) {
    const auto truth = Truth::read("t,target,range_m,bearing_deg,visible\n0,0,10,170,1\n1,0,20,-170,1\n", start);
    ASSERT_TRUE(truth) << truth.error();
    const auto middle = truth->at(0, after(0.5));
    EXPECT_FALSE(truth->hasVelocities());
    EXPECT_NEAR(middle->range_m, 15, 1e-12);
    EXPECT_NEAR(std::abs(middle->from_bow.inDegrees()), 180, 1e-9);
}

TEST(Truth, SaysWhichLineIsWrong) {
    const std::string header = "t,target,range_m,bearing_deg,visible\n";
    for (const std::string line : {"0,0,10,170", "0,0,10,170,1,5", "0,0,x,170,1", "0,-1,10,0,1", "0,0.5,10,0,1",
                                   "0,9999999,10,0,1", "nan,0,10,0,1", "1e300,0,10,0,1"}) {
        const auto truth = Truth::read(header + "0,0,1,1,1\n" + line + "\n", start);
        ASSERT_FALSE(truth) << line;
        EXPECT_NE(truth.error().find("line 3"), std::string::npos) << truth.error();
    }
    EXPECT_FALSE(Truth::read(header + "1,0,1,1,1\n0,0,1,1,1\n", start)) << "times that go back";
    EXPECT_FALSE(Truth::read("something,else\n", start));
    EXPECT_FALSE(Truth::read(header, start)) << "no targets";
}

}  // namespace
}  // namespace echotrail
