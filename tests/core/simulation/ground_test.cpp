#include "core/simulation/ground.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace echotrail {
namespace {

struct Moments {
    double mean = 0.0, square = 0.0;
};

Moments over(int count, auto&& value) {
    Moments m;
    for (int i = 0; i < count; ++i) {
        const double v = value(i);
        m.mean += v / count;
        m.square += v * v / count;
    }
    return m;
}

TEST(GammaNumbers, HaveUnitMeanAndTheVarianceOfTheirShape) {
    for (const double shape : {0.7, 1.5, 5.0}) {
        const Moments m = over(100'000, [&](int i) { return gammaNumber(shape, 4, 5, static_cast<std::uint64_t>(i)); });
        EXPECT_NEAR(m.mean, 1.0, 0.02) << shape;
        EXPECT_NEAR(m.square - m.mean * m.mean, 1.0 / shape, 0.06 / shape) << shape;
    }
}

TEST(GaussianAbove, IsTheKnownQuantile) {
    EXPECT_NEAR(gaussianAbove(0.5), 0.0, 1e-9);
    EXPECT_NEAR(gaussianAbove(0.15), 1.0364, 1e-4);
}

TEST(Ground, TextureWithSpeckleHasTheIndexOfItsShape) {
    // The mean square of a K-distributed power over the square of its mean: 2 (1 + 1/shape), speckle giving the 2.
    Scenario scene;
    scene.bottom_texture = 1.5;
    const Moments m = over(100'000, [&](int i) { return groundStrength(scene, 3, i / 300, i % 300, 9.0); });
    EXPECT_NEAR(2.0 * m.square / (m.mean * m.mean), 2.0 * (1.0 + 1.0 / 1.5), 0.1);
}

TEST(Ground, RockCoversItsShareInPatchesOfSomeMetres) {
    Scenario scene;
    scene.rock_share = 0.15;
    scene.rock_db = 10.0;
    int rock = 0, borders = 0;
    bool before = false;
    for (int i = 0; i < 160'000; ++i) {
        const bool here = groundStrength(scene, 3, i / 400, i % 400, gaussianAbove(0.15)) > 5.0;
        rock += here ? 1 : 0;
        borders += here != before ? 1 : 0;
        before = here;
    }
    EXPECT_NEAR(rock / 160'000.0, 0.15, 0.03);
    EXPECT_LT(borders, 160'000 * 0.06);  // by pure chance 25 % of the cells would border on another kind
}

TEST(Ground, BelongsToTheWorldNotToTheBeam) {
    Scenario scene;
    scene.bottom_texture = 0.7;
    acoustics::Lobe narrow;
    narrow.width_rad = 1e-6;
    // The place 20 m north of the origin, 5 m below, from two sides.
    const double slant_m = std::hypot(20.2, 5.0);
    GroundMemory ground(scene, 1), same(scene, 1);
    GroundAlongBeam north(ground, {0, 0.2, {}}, {}, 5.0, narrow);
    GroundAlongBeam south(same, {40.4, 0.2, {}}, Bearing::degrees(180), 5.0, narrow);
    EXPECT_NEAR(north.at(slant_m), south.at(slant_m), 1e-12);
    EXPECT_NE(north.at(slant_m), north.at(slant_m + 2.0));
}

TEST(Ground, ItsMemoryHoldsWhatTheLawSaysHoweverFarApartTheCellsAre) {
    Scenario scene;
    scene.bottom_texture = 0.7;
    scene.rock_share = 0.1;
    const double rock_above = gaussianAbove(scene.rock_share);
    GroundMemory ground(scene, 4);
    for (int round = 0; round < 2; ++round)
        for (const std::int64_t north : {-257, -1, 0, 255, 256, 5000})
            for (const std::int64_t east : {-256, 0, 3, 259})
                EXPECT_EQ(ground.strengthAt(north, east), groundStrength(scene, 4, north, east, rock_above));
}

TEST(Ground, IsEvenWhereNothingIsSaidOfIt) {
    const Scenario scene;
    GroundMemory ground(scene, 1);
    GroundAlongBeam even(ground, {}, {}, 5.0, {});
    EXPECT_EQ(even.at(20.0), 1.0);
}

TEST(Ground, ItsMeanAlongBeamsIsThatOfItsCells) {
    Scenario scene;
    scene.bottom_texture = 1.0;
    GroundMemory ground(scene, 1);
    const Moments m = over(20'000, [&](int i) {
        GroundAlongBeam beam(ground, {100.0 * (i / 150), 100.0 * (i % 150), {}}, {}, 5.0, {});
        return beam.at(40.0);
    });
    EXPECT_NEAR(m.mean, 1.0, 0.03);
    EXPECT_LT(m.square - m.mean * m.mean, 0.6);  // several patches in the lobe even out
}

}  // namespace
}  // namespace echotrail
