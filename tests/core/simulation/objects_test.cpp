#include "core/simulation/objects.hpp"

#include "core/simulation/acoustics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace echotrail {
namespace {

/// A reflector 20 m ahead, going away, that turns its faces `faces_deg` from its course.
Scenario reflectorAhead(double faces_deg) {
    Scenario scene;
    scene.targets = {{.path = {{-1000, 19, 0}, {1000, 21, 0}}, .reflector_m = 1.0, .faces_deg = faces_deg}};
    return scene;
}

/// Over many seeds, so that scintillation evens out.
double meanPower(const Scenario& scene, double time_s = 0.0) {
    double sum = 0.0;
    for (std::uint64_t seed = 0; seed < 4000; ++seed)
        sum += objectEchoes(scene, seed, {}, time_s).echoes.at(0).power / 4000.0;
    return sum;
}

TEST(ReflectorEcho, IsThatOfItsMirrorImageOnAxis) {
    EXPECT_NEAR(acoustics::decibels(meanPower(reflectorAhead(180))), 10.0, 0.3);
}

TEST(ReflectorEcho, FallsOffItsAxisToThatOfTheBody) {
    EXPECT_NEAR(acoustics::decibels(meanPower(reflectorAhead(200))), 7.0, 0.3);
    EXPECT_NEAR(acoustics::decibels(meanPower(reflectorAhead(0))), -20.0, 0.3);
}

TEST(ReflectorEcho, FadesForTheTimesGiven) {
    Scenario scene = reflectorAhead(180);
    scene.targets[0].fades = {{10, 20, 30}};
    EXPECT_NEAR(acoustics::decibels(meanPower(scene, 15)), -20.0, 0.3);
    EXPECT_NEAR(acoustics::decibels(meanPower(scene, 20)), 10.0, 0.3);
}

TEST(ReflectorEcho, LosesTheLobesHeightBelowTheHead) {
    Scenario scene = reflectorAhead(180);
    const double level = meanPower(scene);
    scene.targets[0].below_head_m = 20.0 * std::tan(radiansFromDegrees(10.0));
    EXPECT_NEAR(acoustics::decibels(level / meanPower(scene)), 6.0, 0.3);  // half power each way, but farther off
}

TEST(Ghosts, FollowTheirTargetAtAFewMetresAndAreWeaker) {
    Scenario scene = reflectorAhead(180);
    scene.multipath_copies = 3;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const auto echoes = objectEchoes(scene, seed, {}, 7.0).echoes;
        ASSERT_EQ(echoes.size(), 4U);
        for (std::size_t i = 1; i < 4; ++i) {
            EXPECT_GE(echoes[i].range_m, echoes[0].range_m + 0.2);
            EXPECT_LE(echoes[i].range_m, echoes[0].range_m + 3.0);
            EXPECT_LE(echoes[i].power, echoes[0].power * acoustics::powerOf(-6.0));
            EXPECT_GE(echoes[i].power, echoes[0].power * acoustics::powerOf(-20.0) * 0.999);
        }
    }
}

TEST(Wake, StaysWhereItWasShedAndDies) {
    Scenario scene;
    scene.targets = {{.path = {{0, 10, 0}, {40, 50, 0}}, .wake_s = 5.0}};
    const auto echoes = objectEchoes(scene, 1, {}, 20.5).echoes;
    ASSERT_EQ(echoes.size(), 6U);
    for (std::size_t age = 0; age < 5; ++age) {
        EXPECT_NEAR(echoes[1 + age].range_m, 30.0 - static_cast<double>(age), 1e-6);
        EXPECT_TRUE(age == 0 || echoes[1 + age].power < echoes[age].power);
    }
}

TEST(Shadows, LieBehindObjectsOnTheBottomAsFarAsTheirHeightReaches) {
    Scenario scene;
    scene.altitude_m = 4.0;
    scene.shadows = true;
    scene.debris = {{.north_m = 20, .size_m = 1.0}};
    const Shadow shadow = objectEchoes(scene, 1, {}, 0.0).shadows.at(0);
    const double range_m = std::hypot(20.0, 3.5);
    EXPECT_NEAR(shadow.near_m, range_m, 1e-9);
    EXPECT_NEAR(shadow.far_m, range_m * 4.0 / 3.0, 1e-9);
    EXPECT_GT(shadow.share, 0.9);
    scene.targets = {{.path = {{0, 20, 0}}, .below_head_m = -3.0}};  // wholly above the head
    EXPECT_TRUE(std::isinf(objectEchoes(scene, 1, {}, 0.0).shadows.at(0).near_m));
}

TEST(Beam, IsOnATargetWithinHalfItsWidth) {
    const Scenario scene = reflectorAhead(180);
    HeadSetup head;
    for (const double degrees : {-1.6, -1.4, 0.0, 1.4, 1.6}) {
        head.bearing = Bearing::degrees(degrees);
        EXPECT_EQ(beamIsOn(scene, scene.targets[0], head, 0.0), std::abs(degrees) < 1.5) << degrees;
    }
    head.bearing = {};
    head.range_m = 15.0;
    EXPECT_FALSE(beamIsOn(scene, scene.targets[0], head, 0.0));
}

}  // namespace
}  // namespace echotrail
