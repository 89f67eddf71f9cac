#include "core/imaging/local_enhancement.hpp"

#include "core/base/random.hpp"
#include "tests/core/imaging/fan_fixture.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace echotrail {
namespace {

FanImage scannedTile(int rows, int columns, std::uint8_t level) {
    FanImage tile = emptyTile(0, 0, rows, columns, 0.125);
    tile.levels.setTo(level);
    tile.beam_time_ms.setTo(0);
    return tile;
}

/// The equation as it is printed, pixel by pixel.
int expectedLevel(const FanImage& fan, int row, int column, const LocalEnhancementParams& p) {
    double fan_sum = 0, fan_count = 0, sum = 0, squares = 0, count = 0;
    const int reach = p.enhance_window_pixels / 2;
    for (int r = 0; r < fan.levels.rows; ++r)
        for (int c = 0; c < fan.levels.cols; ++c) {
            if (!isPainted(fan, r, c)) continue;
            const double f = fan.levels.at<std::uint8_t>(r, c) / 255.0;
            fan_sum += f;
            ++fan_count;
            if (std::abs(r - row) > reach || std::abs(c - column) > reach) continue;
            sum += f;
            squares += f * f;
            ++count;
        }
    const double m = sum / count, deviation = std::sqrt(std::max(squares / count - m * m, 0.0));
    const double f = fan.levels.at<std::uint8_t>(row, column) / 255.0;
    const double g = p.enhance_k * (fan_sum / fan_count) / (deviation + p.enhance_b) * (f - p.enhance_c * m) +
                     std::pow(m, p.enhance_a);
    return static_cast<int>(std::lround(255.0 * std::clamp(g, 0.0, 1.0)));
}

TEST(LocalEnhancement, AHandWorkedPatchComesOutAsWorkedByHand) {
    // One bright pixel, f = 1, in a dark 5×5 patch: m = D = 1/25, deviation = sqrt(1/25 - 1/625) = 0.19596.
    FanImage fan = scannedTile(5, 5, 0);
    fan.levels.at<std::uint8_t>(2, 2) = 255;
    const FanImage enhanced = enhanceLocally(fan, {});
    // [0.04 / (0.19596 + 0.3)] (1 - 0.5 * 0.04) + 0.04 = 0.11904
    EXPECT_EQ(enhanced.levels.at<std::uint8_t>(2, 2), 30);
    // [0.04 / 0.49596] (0 - 0.5 * 0.04) + 0.04 = 0.03839, for a neighbour with all 25 pixels in its window; the window
    // of the neighbour at (1, 2) has 20: m = 0.05, deviation = 0.21794; [0.04 / 0.51794] (-0.025) + 0.05 = 0.04807
    EXPECT_EQ(enhanced.levels.at<std::uint8_t>(1, 2), 12);
}

TEST(LocalEnhancement, EveryPixelFollowsTheEquation) {
    FanImage fan = scannedTile(24, 31, 0);
    RandomStream random(11, 1, 0);
    for (int row = 0; row < 24; ++row)
        for (int column = 0; column < 31; ++column) {
            fan.levels.at<std::uint8_t>(row, column) = static_cast<std::uint8_t>(random.bits() & 0x7F);
            if (random.uniform() < 0.2) fan.beam_time_ms.at<std::int32_t>(row, column) = FanImage::never_scanned;
        }
    for (const auto& params : {LocalEnhancementParams{}, LocalEnhancementParams{0.7, 0.05, 0.9, 1.4, 7},
                               LocalEnhancementParams{1.5, 0.5, 0.0, 0.5, 31}}) {
        const FanImage enhanced = enhanceLocally(fan, params);
        for (int row = 0; row < 24; ++row)
            for (int column = 0; column < 31; ++column) {
                const int level = enhanced.levels.at<std::uint8_t>(row, column);
                const int expected = isPainted(fan, row, column) ? expectedLevel(fan, row, column, params) : 0;
                EXPECT_NEAR(level, expected, isPainted(fan, row, column) ? 1 : 0) << row << ' ' << column;
            }
    }
}

TEST(LocalEnhancement, WhatWasNeverScannedDoesNotCount) {
    FanImage fan = scannedTile(9, 9, 100);
    const int alone = enhanceLocally(fan, {}).levels.at<std::uint8_t>(4, 2);
    FanImage wider = scannedTile(9, 20, 255);
    wider.beam_time_ms.setTo(FanImage::never_scanned);
    fan.levels.copyTo(wider.levels(cv::Rect(0, 0, 9, 9)));
    fan.beam_time_ms.copyTo(wider.beam_time_ms(cv::Rect(0, 0, 9, 9)));
    const FanImage enhanced = enhanceLocally(wider, {});
    for (int column = 0; column < 20; ++column)
        EXPECT_EQ(enhanced.levels.at<std::uint8_t>(4, column), column < 9 ? alone : 0) << column;
}

TEST(LocalEnhancement, AConstantFanStaysConstantAndADarkOneDark) {
    // Deviation 0: g = [D / 0.3] (D - 0.5 D) + D with D = 51 / 255 = 0.2, that is 0.26667.
    const FanImage constant = enhanceLocally(scannedTile(12, 12, 51), {});
    EXPECT_EQ(cv::countNonZero(constant.levels != 68), 0);
    // D = 0: nothing is amplified, and 0^a = 0.
    EXPECT_EQ(cv::countNonZero(enhanceLocally(scannedTile(12, 12, 0), {}).levels), 0);
}

TEST(LocalEnhancement, AnEmptyOrUnscannedFanGivesNothing) {
    EXPECT_TRUE(enhanceLocally({}, {}).empty());
    const FanImage unscanned = enhanceLocally(emptyTile(0, 0, 7, 7, 0.1), {});
    EXPECT_EQ(cv::countNonZero(unscanned.levels), 0);
}

}  // namespace
}  // namespace echotrail
