#include "core/evaluation/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace echotrail {
namespace {

TEST(Quantiles, AreThoseOfTheTables) {
    EXPECT_NEAR(chiSquareQuantile(0.95, 2), -2 * std::log(0.05), 1e-9);
    EXPECT_NEAR(chiSquareQuantile(0.95, 2), nees_of_ellipse, 1e-9);
    EXPECT_NEAR(chiSquareQuantile(0.95, 1), 3.841459, 1e-6);
    EXPECT_NEAR(chiSquareQuantile(0.025, 10), 3.246973, 1e-6);
    EXPECT_NEAR(chiSquareQuantile(0.975, 200), 241.0579, 1e-4);
    EXPECT_NEAR(studentQuantile(0.975, 1), 12.70620, 1e-5);
    EXPECT_NEAR(studentQuantile(0.975, 4), 2.776445, 1e-6);
    EXPECT_NEAR(studentQuantile(0.025, 19), -2.093024, 1e-6);
    EXPECT_NEAR(studentQuantile(0.975, 1e6), 1.959966, 1e-5);
}

TEST(Wilson, OfTenInAHundredAndOfNone) {
    const ConfidenceInterval tenth = wilsonInterval(10, 100);
    EXPECT_NEAR(tenth.low, 0.0552, 1e-4);
    EXPECT_NEAR(tenth.high, 0.1744, 1e-4);
    const ConfidenceInterval none = wilsonInterval(0, 10);
    EXPECT_NEAR(none.low, 0.0, 1e-15);
    EXPECT_NEAR(none.high, 0.2775, 1e-4);  // z² / (n + z²)
    const ConfidenceInterval all = wilsonInterval(10, 10);
    EXPECT_NEAR(all.low, 1 - none.high, 1e-12);
    EXPECT_NEAR(all.high, 1.0, 1e-15);
    EXPECT_EQ(wilsonInterval(0, 0).low, 0.0);
    EXPECT_EQ(wilsonInterval(0, 0).high, 1.0);
}

TEST(Mean, OfThreeValuesWithStudentsInterval) {
    // Deviation 1, two degrees of freedom: 4.302653 / √3.
    const MeanEstimate estimate = meanEstimate(std::vector{1.0, 2.0, 3.0});
    EXPECT_NEAR(estimate.mean, 2.0, 1e-12);
    EXPECT_NEAR(estimate.interval.low, 2 - 2.484138, 1e-6);
    EXPECT_NEAR(estimate.interval.high, 2 + 2.484138, 1e-6);
    EXPECT_EQ(meanEstimate(std::vector{5.0}).interval.high, 5.0);
    EXPECT_EQ(meanEstimate({}).count, 0U);
}

TEST(PoissonRate, OfNoneAndOfThreeEvents) {
    EXPECT_EQ(poissonRateInterval(0, 1).low, 0.0);
    EXPECT_NEAR(poissonRateInterval(0, 1).high, -std::log(0.025), 1e-9);
    EXPECT_NEAR(poissonRateInterval(3, 2).low, 0.618672 / 2, 1e-6);
    EXPECT_NEAR(poissonRateInterval(3, 2).high, 8.767273 / 2, 1e-6);
}

TEST(NeesBounds, OfAHundredRunsAreThoseOfTheLiterature) {
    EXPECT_NEAR(neesBounds(100).low, 1.63, 0.005);
    EXPECT_NEAR(neesBounds(100).high, 2.41, 0.005);
    // With many samples the Gaussian law takes over: 2 ± 1.96 · 2 / √n.
    EXPECT_NEAR(neesBounds(40000).low, 2 - 1.96 * 0.01, 1e-4);
    EXPECT_NEAR(neesBounds(40000).high, 2 + 1.96 * 0.01, 1e-4);
}

TEST(FiveNumbers, AreInterpolatedBetweenNeighbours) {
    const FiveNumbers numbers = fiveNumbers({4, 1, 3, 2});
    EXPECT_EQ(numbers.least, 1.0);
    EXPECT_EQ(numbers.lower, 1.75);
    EXPECT_EQ(numbers.median, 2.5);
    EXPECT_EQ(numbers.upper, 3.25);
    EXPECT_EQ(numbers.greatest, 4.0);
    EXPECT_EQ(median({7}), 7.0);
    EXPECT_EQ(median({}), 0.0);
}

}  // namespace
}  // namespace echotrail
