#include "core/base/random.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace echotrail {
namespace {

TEST(RandomStream, MatchesThePublishedPhiloxVector) {
    // Random123's known-answer test: Philox4x32-10, counter and key all zero.
    RandomStream stream(0, 0, 0);
    EXPECT_EQ(stream.bits(), 0x6627e8d5u);
    EXPECT_EQ(stream.bits(), 0xe169c58du);
    EXPECT_EQ(stream.bits(), 0xbc57ac4cu);
    EXPECT_EQ(stream.bits(), 0x9b00dbd8u);
}

TEST(RandomStream, SameNameSameNumbersOtherNameOthers) {
    RandomStream a(7, 3, 11), b(7, 3, 11), c(7, 3, 12);
    bool differs = false;
    for (int i = 0; i < 100; ++i) {
        const double value = a.gaussian();
        EXPECT_EQ(value, b.gaussian());
        differs |= value != c.gaussian();
    }
    EXPECT_TRUE(differs);
}

TEST(RandomStream, GaussianHasZeroMeanUnitVarianceAndNormalTails) {
    RandomStream stream(1, 2, 3);
    constexpr int n = 200'000;
    double sum = 0, squares = 0;
    int beyond_two = 0;
    for (int i = 0; i < n; ++i) {
        const double value = stream.gaussian();
        ASSERT_TRUE(std::isfinite(value));
        sum += value;
        squares += value * value;
        beyond_two += std::abs(value) > 2.0;
    }
    EXPECT_NEAR(sum / n, 0.0, 4.0 / std::sqrt(n));
    EXPECT_NEAR(squares / n, 1.0, 4.0 * std::sqrt(2.0 / n));
    EXPECT_NEAR(beyond_two / double{n}, 0.0455, 0.002);
}

}  // namespace
}  // namespace echotrail
