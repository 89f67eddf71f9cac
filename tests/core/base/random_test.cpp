#include "core/base/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

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

TEST(RandomStream, ManyGaussiansAtOnceAreBoxMullerOfTheSameWords) {
    constexpr std::size_t row = 64;  // a batch holds 64 blocks: first the first numbers of all, then the second, …
    std::vector<float> numbers(4 * row);
    RandomStream(5, 6, 7).fillGaussian(numbers);
    RandomStream words(5, 6, 7);
    for (std::size_t block = 0; block < row; ++block)
        for (std::size_t half = 0; half < 4; half += 2) {
            const double u = ((words.bits() >> 8) + 0.5) * 0x1p-24;
            const double radius = std::sqrt(-2.0 * std::log(u));
            const double angle = 2.0 * std::numbers::pi * words.bits() * 0x1p-32;
            EXPECT_NEAR(numbers[half * row + block], radius * std::cos(angle), 2e-6);
            EXPECT_NEAR(numbers[(half + 1) * row + block], radius * std::sin(angle), 2e-6);
        }
}

TEST(RandomStream, ManyGaussiansAtOnceStartTheSameHoweverManyAreTaken) {
    std::vector<float> few(300), many(2000), next(300);
    RandomStream(5, 6, 7).fillGaussian(many);
    RandomStream stream(5, 6, 7);
    stream.fillGaussian(few);
    stream.fillGaussian(next);
    EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
    EXPECT_NE(few, next);
}

TEST(RandomStream, ManyGaussiansAtOnceHaveTheMomentsOfTheNormal) {
    std::vector<float> numbers(400'000);
    RandomStream(1, 2, 3).fillGaussian(numbers);
    const double n = static_cast<double>(numbers.size());
    double sum = 0, squares = 0, fourth = 0, neighbours = 0, greatest = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const double x = numbers[i];
        sum += x;
        squares += x * x;
        fourth += x * x * x * x;
        if (i > 0) neighbours += x * numbers[i - 1];
        greatest = std::max(greatest, std::abs(x));
    }
    EXPECT_NEAR(sum / n, 0.0, 4.0 / std::sqrt(n));
    EXPECT_NEAR(squares / n, 1.0, 4.0 * std::sqrt(2.0 / n));
    EXPECT_NEAR(fourth / n, 3.0, 4.0 * std::sqrt(96.0 / n));
    EXPECT_NEAR(neighbours / n, 0.0, 4.0 / std::sqrt(n));
    EXPECT_GT(greatest, 4.0);
    EXPECT_LT(greatest, 5.9);
}

}  // namespace
}  // namespace echotrail
