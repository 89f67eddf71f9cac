#include "core/tuning/particle_swarm.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace echotrail {
namespace {

using Evaluate = std::function<void(std::span<const SwarmPoint>, std::span<double>)>;

/// Greatest, 0, at (0.1, 0.2, 0.3, 0.4).
double sphere(const SwarmPoint& point) {
    double sum = 0;
    for (std::size_t d = 0; d < point.size(); ++d) sum += std::pow(point[d] - 0.1 * static_cast<double>(d + 1), 2);
    return -sum;
}

Evaluate each(const std::function<double(const SwarmPoint&)>& of) {
    return [of](std::span<const SwarmPoint> points, std::span<double> values) {
        for (std::size_t i = 0; i < points.size(); ++i) values[i] = of(points[i]);
    };
}

const std::vector<Bounds> cube(4, Bounds{-1.0, 1.0});
const SwarmPoint corner(4, 1.0);

TEST(ParticleSwarm, FindsTheTopOfASphereInFourDimensions) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        const SwarmResult found = maximise(each(sphere), cube, corner, seed);
        EXPECT_GT(found.value, -0.02) << seed;
        EXPECT_EQ(found.value, sphere(found.best));
        EXPECT_EQ(found.evaluations, 600);
        for (std::size_t d = 0; d < 4; ++d) EXPECT_NEAR(found.best[d], 0.1 * static_cast<double>(d + 1), 0.15) << seed;
    }
}

TEST(ParticleSwarm, OneSeedGivesOneAnswer) {
    const SwarmResult a = maximise(each(sphere), cube, corner, 7), b = maximise(each(sphere), cube, corner, 7);
    EXPECT_EQ(a.best, b.best);
    EXPECT_EQ(a.value, b.value);
    EXPECT_NE(a.best, maximise(each(sphere), cube, corner, 8).best);
}

TEST(ParticleSwarm, StaysWithinItsBoundsAndReachesThem) {
    const std::vector<Bounds> bounds{{0.0, 1.5}, {0.01, 0.5}};
    const auto evaluate = each([&](const SwarmPoint& point) {
        for (std::size_t d = 0; d < bounds.size(); ++d) {
            EXPECT_GE(point[d], bounds[d].low);
            EXPECT_LE(point[d], bounds[d].high);
        }
        return point[0] - point[1];  // greatest in a corner
    });
    const SwarmResult found = maximise(evaluate, bounds, {9.0, -9.0}, 1);
    EXPECT_EQ(found.best, (SwarmPoint{1.5, 0.01}));
}

TEST(ParticleSwarm, WhatIsNoNumberIsNeverTheBest) {
    const auto evaluate = each([](const SwarmPoint& point) { return point[0] > 0 ? std::nan("") : point[0]; });
    const SwarmResult found = maximise(evaluate, {{-1.0, 1.0}}, {0.5}, 3);
    EXPECT_LE(found.best[0], 0.0);
    EXPECT_GT(found.value, -0.1);
}

TEST(ParticleSwarm, CancelledItGivesWhatItHasFound) {
    int asked = 0;
    const SwarmResult found = maximise(each(sphere), cube, corner, 1, {}, [&] { return ++asked > 3; });
    EXPECT_EQ(found.evaluations, 60);
    EXPECT_EQ(found.value, sphere(found.best));
}

}  // namespace
}  // namespace echotrail
