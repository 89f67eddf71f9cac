#include "core/tuning/enhancement_objective.hpp"

#include "core/base/random.hpp"
#include "tests/core/imaging/fan_fixture.hpp"

#include <gtest/gtest.h>

namespace echotrail {
namespace {

FanImage scanned(int rows, int columns, std::uint8_t level) {
    FanImage fan = emptyTile(0, 0, rows, columns, 0.125);
    fan.levels.setTo(level);
    fan.beam_time_ms.setTo(0);
    return fan;
}

/// Speckle of up to `noise` levels about a dark sea, and a patch of `bright` in it.
FanImage sea(int noise, std::uint8_t bright) {
    FanImage fan = scanned(80, 90, 0);
    RandomStream random(5, 0, 0);
    for (int row = 0; row < 80; ++row)
        for (int column = 0; column < 90; ++column)
            fan.levels.at<std::uint8_t>(row, column) = static_cast<std::uint8_t>(40 + noise * random.uniform());
    fan.levels(cv::Rect(40, 30, 8, 8)).setTo(bright);
    return fan;
}

TEST(EnhancementObjective, APictureWithOneStepComesOutAsWorkedByHand) {
    // Half is 0, half is 100: the entropy is 1 bit. At the step the gradient is 4 · 100, in two columns of three
    // pixels that have all their neighbours: E = 2400. ln(ln(2400 + e)) · 6 / 30 · 1 = 2.05212 / 5.
    FanImage fan = scanned(5, 6, 0);
    fan.levels(cv::Rect(3, 0, 3, 5)).setTo(100);
    EXPECT_NEAR(publishedObjective(fan), 0.41042, 1e-5);
}

TEST(EnhancementObjective, UnscannedPixelsAndTheirNeighboursCountForNothing) {
    FanImage fan = scanned(5, 6, 0);
    fan.levels(cv::Rect(3, 0, 3, 5)).setTo(100);
    FanImage wider = emptyTile(0, 0, 9, 12, 0.125);
    fan.levels.copyTo(wider.levels(cv::Rect(4, 2, 6, 5)));
    fan.beam_time_ms.copyTo(wider.beam_time_ms(cv::Rect(4, 2, 6, 5)));
    EXPECT_NEAR(publishedObjective(wider), publishedObjective(fan), 1e-9);
}

TEST(EnhancementObjective, WithoutAnEdgeThereIsNothing) {
    EXPECT_EQ(publishedObjective(scanned(20, 20, 90)), 0.0);
    EXPECT_EQ(guardedObjective(scanned(20, 20, 90), scanned(20, 20, 90)), 0.0);
    EXPECT_EQ(publishedObjective({}), 0.0);
    EXPECT_EQ(guardedObjective({}, {}), 0.0);
    EXPECT_EQ(publishedObjective(emptyTile(0, 0, 9, 9, 0.1)), 0.0);
}

TEST(EnhancementObjective, SpeckleIsTheDeviationForTheContrast) {
    // A chessboard of 0 and 100: deviation 50 in every window, median 0, 99.5th percentile 100.
    FanImage board = scanned(24, 24, 0);
    for (int row = 0; row < 24; ++row)
        for (int column = row % 2; column < 24; column += 2) board.levels.at<std::uint8_t>(row, column) = 100;
    EXPECT_NEAR(speckleOf(board), 0.5, 0.001);
    EXPECT_EQ(speckleOf(scanned(24, 24, 70)), 0.0);
}

TEST(EnhancementObjective, ThePublishedOneRewardsSpeckleAndTheGuardedOneDoesNot) {
    const FanImage plain = sea(12, 200), restless = sea(120, 200);
    EXPECT_GT(publishedObjective(restless), 5 * publishedObjective(plain));
    EXPECT_LT(guardedObjective(plain, restless), 0.2 * guardedObjective(plain, plain));
}

}  // namespace
}  // namespace echotrail
