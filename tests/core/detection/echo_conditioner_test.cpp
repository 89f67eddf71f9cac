#include "core/detection/echo_conditioner.hpp"

#include "core/base/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace echotrail {
namespace {

Ping pingOf(std::vector<std::uint8_t> levels, double range_m = 10.0) {
    Ping ping;
    ping.range_scale_m = range_m;
    ping.sound_speed_mps = 1500;
    ping.bin_interval_s = 2.0 * range_m / 1500 / static_cast<double>(levels.size());
    ping.levels = std::move(levels);
    return ping;
}

TEST(RunningMedian, EqualsSortingEachWindow) {
    RandomStream random(1, 0, 0);
    std::vector<std::uint8_t> values(97), medians(97);
    for (auto& value : values) value = static_cast<std::uint8_t>(random.bits());
    for (const int window : {1, 3, 11, 31, 301}) {
        runningMedian(values, window, medians);
        for (int i = 0; i < 97; ++i) {
            std::vector<std::uint8_t> sorted(values.begin() + std::max(i - window / 2, 0),
                                             values.begin() + std::min(i + window / 2, 96) + 1);
            std::sort(sorted.begin(), sorted.end());
            EXPECT_EQ(medians[i], sorted[sorted.size() / 2]) << "window " << window << " at " << i;
        }
    }
}

TEST(EchoConditioner, ConstantLineIsItsOwnBackground) {
    EchoConditioner conditioner({});
    EchoRow row;
    conditioner.condition(pingOf(std::vector<std::uint8_t>(642, 60)), row);
    EXPECT_EQ(row.level.size(), 400u);
    EXPECT_NEAR(row.cell_m * 400, 10.0, 1e-9);
    for (std::size_t i = 0; i < 400; ++i) {
        EXPECT_EQ(row.smooth[i], 60);
        EXPECT_EQ(row.background[i], 60);
    }
}

TEST(EchoConditioner, ShortEchoStandsOutWhereItIs) {
    std::vector<std::uint8_t> levels(800, 20);
    std::fill(levels.begin() + 400, levels.begin() + 416, 150);
    EchoConditioner conditioner({});
    EchoRow row;
    for (int i = 0; i < 20; ++i) conditioner.condition(pingOf(std::vector<std::uint8_t>(800, 20)), row);
    conditioner.condition(pingOf(levels), row);
    EXPECT_GT(row.smooth[203] - row.background[203], 100);
    EXPECT_EQ(row.smooth[150] - row.background[150], 0);
}

TEST(EchoConditioner, LineFilledByAnotherSounderIsNoEcho) {
    std::vector<std::uint8_t> levels(800, 10);
    std::fill(levels.begin() + 300, levels.end(), 120);
    EchoConditioner conditioner({});
    EchoRow row;
    conditioner.condition(pingOf(levels), row);
    for (int i = 200; i < 380; ++i) EXPECT_LT(row.smooth[i] - row.background[i], 19) << i;
}

TEST(EchoConditioner, WhatEveryBearingShowsIsBackgroundAndCanBeKept) {
    std::vector<std::uint8_t> levels(800, 10);
    std::fill(levels.begin() + 80, levels.begin() + 100, 140);
    for (const bool remove : {true, false}) {
        EchoConditioner conditioner({.remove_rings = remove});
        EchoRow row;
        for (int i = 0; i < 30; ++i) conditioner.condition(pingOf(levels), row);
        EXPECT_EQ(row.smooth[45] - row.background[45] < 10, remove);
    }
}

TEST(EchoConditioner, TakesLinesOfAnyLength) {
    EchoConditioner conditioner({});
    EchoRow row;
    for (const std::size_t bins : {0u, 1u, 2u, 3u, 4u, 5u, 45u, 399u, 401u, 1500u}) {
        conditioner.condition(pingOf(std::vector<std::uint8_t>(bins, 33)), row);
        EXPECT_EQ(row.level.size(), std::min<std::size_t>(bins, 400));
        for (const auto value : row.smooth) EXPECT_EQ(value, 33);
    }
}

}  // namespace
}  // namespace echotrail
