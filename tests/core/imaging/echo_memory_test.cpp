#include "core/imaging/echo_memory.hpp"

#include <gtest/gtest.h>

namespace echotrail {
namespace {

constexpr int sweep_ms = 1000;

/// 20 × 20 pixels of 1 m, all seen at one moment.
FanImage evenFan(int level, int time_ms) {
    return {cv::Mat(20, 20, CV_8U, cv::Scalar(level)), cv::Mat(20, 20, CV_32S, cv::Scalar(time_ms)), 1.0, 10.0, -10.0};
}

FanImage withEcho(int row, int column, int time_ms) {
    FanImage fan = evenFan(50, time_ms);
    fan.levels(cv::Rect(column - 1, row - 1, 3, 3)) = 200;
    return fan;
}

TEST(EchoMemory, WhatMovesLeavesATrailAndWhatLiesStillDoesNot) {
    EchoMemory memory;
    EXPECT_EQ(memory.remembered(), nullptr);
    for (int sweep = 1; sweep <= 5; ++sweep) {
        FanImage fan = evenFan(50, sweep * sweep_ms);
        fan.levels(cv::Rect(14, 14, 3, 3)) = 200;        // lies still
        fan.levels(cv::Rect(2 * sweep, 4, 3, 3)) = 200;  // goes east
        memory.add(fan);
    }
    const cv::Mat& trail = memory.remembered()->trail_time_ms;
    EXPECT_EQ(trail.at<std::int32_t>(5, 9), 4 * sweep_ms);
    EXPECT_EQ(trail.at<std::int32_t>(5, 11), 5 * sweep_ms);
    EXPECT_EQ(trail.at<std::int32_t>(15, 15), FanImage::never_scanned);
    EXPECT_EQ(trail.at<std::int32_t>(10, 2), FanImage::never_scanned);
}

TEST(EchoMemory, ANewEchoStandsOutFromTheBackgroundAndTheSeaDoesNot) {
    EchoMemory memory;
    for (int sweep = 1; sweep <= 4; ++sweep) memory.add(evenFan(50, sweep * sweep_ms));
    const FanImage seen = withoutBackground(withEcho(8, 8, 5 * sweep_ms), *memory.remembered());
    EXPECT_EQ(seen.levels.at<std::uint8_t>(8, 8), 150);
    EXPECT_EQ(seen.levels.at<std::uint8_t>(15, 15), 0);
}

TEST(EchoMemory, NothingIsShownWhereTheBackgroundIsNotKnownYet) {
    EchoMemory memory;
    memory.add(evenFan(50, sweep_ms));
    const FanImage seen = withoutBackground(withEcho(8, 8, 2 * sweep_ms), *memory.remembered());
    EXPECT_EQ(seen.beam_time_ms.at<std::int32_t>(8, 8), FanImage::never_scanned);
}

TEST(EchoMemory, ARegionNotLookedAtAgainIsNotCountedTwice) {
    EchoMemory memory;
    for (int i = 0; i < 4; ++i) memory.add(evenFan(50, sweep_ms));
    EXPECT_EQ(memory.remembered()->looks.at<std::uint8_t>(3, 3), 1);
}

TEST(EchoMemory, StaysOnTheGroundWhenThePictureFollowsTheVehicle) {
    EchoMemory memory;
    for (int sweep = 1; sweep <= 3; ++sweep) memory.add(withEcho(8, 8, sweep * sweep_ms));
    FanImage moved = withEcho(12, 5, 4 * sweep_ms);  // the same place of the ground
    moved.north_m += 4.0;
    moved.east_m += 3.0;
    EXPECT_EQ(withoutBackground(moved, *memory.remembered()).levels.at<std::uint8_t>(12, 5), 0);
    memory.add(moved);
    EXPECT_EQ(memory.remembered()->looks.at<std::uint8_t>(12, 5), 4);
    EXPECT_EQ(memory.remembered()->looks.at<std::uint8_t>(0, 19), 1) << "new ground";
}

TEST(EchoMemory, AtAnotherPixelSizeItBeginsAnew) {
    EchoMemory memory;
    for (int sweep = 1; sweep <= 3; ++sweep) memory.add(evenFan(50, sweep * sweep_ms));
    FanImage finer = evenFan(50, 4 * sweep_ms);
    finer.pixel_m = 0.5;
    EXPECT_EQ(withoutBackground(finer, *memory.remembered()).beam_time_ms.at<std::int32_t>(3, 3),
              FanImage::never_scanned);
    memory.add(finer);
    EXPECT_EQ(memory.remembered()->looks.at<std::uint8_t>(3, 3), 1);
}

}  // namespace
}  // namespace echotrail
