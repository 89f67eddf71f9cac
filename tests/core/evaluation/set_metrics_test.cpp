#include "core/evaluation/set_metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace echotrail {
namespace {

using Places = std::vector<Eigen::Vector2d>;
using Points = std::vector<ClearMot::Point>;

TEST(Ospa, OneOfTwoTargetsFoundThreeMetresOff) {
    // ((3² + 7.5²) / 2)^½
    EXPECT_NEAR(ospa(Places{{3, 0}}, Places{{0, 0}, {10, 0}}), std::sqrt(65.25 / 2), 1e-12);
    EXPECT_NEAR(ospa(Places{{0, 0}, {10, 0}}, Places{{3, 0}}), std::sqrt(65.25 / 2), 1e-12);
}

TEST(Ospa, IsNothingForEqualSetsAndTheCutoffForAnEmptyOrFarOne) {
    EXPECT_EQ(ospa(Places{}, Places{}), 0.0);
    EXPECT_EQ(ospa(Places{{1, 2}, {3, 4}}, Places{{3, 4}, {1, 2}}), 0.0);
    EXPECT_EQ(ospa(Places{}, Places{{1, 2}}), 7.5);
    EXPECT_EQ(ospa(Places{{1, 2}}, Places{}), 7.5);
    EXPECT_EQ(ospa(Places{{0, 0}}, Places{{20, 0}}), 7.5);
}

TEST(Ospa, PairsForTheLeastSumAndNotTheNearestFirst) {
    // The nearest pair, 3 and 4, would leave 6.5 for 0: 1 + 42.25. The best pairs are 3–0 and 6.5–4: 9 + 6.25.
    EXPECT_NEAR(ospa(Places{{3, 0}, {6.5, 0}}, Places{{0, 0}, {4, 0}}), std::sqrt(15.25 / 2), 1e-12);
}

TEST(Gospa, FallsIntoLocalisationMissedAndFalse) {
    // Found 3 m off; one of two targets missed; one track at nothing: 9, 7.5²/2, 7.5²/2.
    const Gospa parts = gospa(Places{{3, 0}, {0, 40}}, Places{{0, 0}, {30, 0}});
    EXPECT_NEAR(parts.localisation_m2, 9, 1e-12);
    EXPECT_NEAR(parts.missed_m2, 28.125, 1e-12);
    EXPECT_NEAR(parts.false_m2, 28.125, 1e-12);
    EXPECT_NEAR(parts.distance(), std::sqrt(65.25), 1e-12);
}

TEST(Gospa, GrowsWithTheNumberOfMissedTargets) {
    EXPECT_NEAR(gospa(Places{}, Places{{0, 0}, {9, 9}}).distance(), 7.5, 1e-12);  // 2 · c²/2
    EXPECT_NEAR(gospa(Places{{0, 0}}, Places{}).distance(), std::sqrt(28.125), 1e-12);
    EXPECT_EQ(gospa(Places{}, Places{}).distance(), 0.0);
}

TEST(ClearMot, CountsAMissAFalsePositiveAndASwitch) {
    const Points targets{{0, {0, 0}}, {1, {20, 0}}};
    ClearMot mot;
    mot.addFrame(Points{{1, {1, 0}}, {2, {20, 1}}}, targets);  // both found, 1 m off
    mot.addFrame(Points{{1, {0, 2}}, {9, {0, 40}}}, targets);  // one found, one missed, one track at nothing
    mot.addFrame(Points{{1, {0, 0}}, {3, {20, 3}}}, targets);  // both found, one by another track
    const ClearMot::Counts& counts = mot.counts();
    EXPECT_EQ(counts.objects, 6);
    EXPECT_EQ(counts.misses, 1);
    EXPECT_EQ(counts.false_positives, 1);
    EXPECT_EQ(counts.switches, 1);
    EXPECT_EQ(counts.matches, 5);
    EXPECT_NEAR(counts.mota(), 0.5, 1e-12);
    EXPECT_NEAR(counts.motp_m(), 7.0 / 5, 1e-12);
}

TEST(ClearMot, ATargetKeepsItsTrackWhileThatIsNearEnough) {
    ClearMot mot;
    mot.addFrame(Points{{1, {0, 0}}, {2, {4, 0}}}, Points{{0, {0, 0}}, {1, {4, 0}}});
    mot.addFrame(Points{{1, {3, 0}}, {2, {1, 0}}}, Points{{0, {0, 0}}, {1, {4, 0}}});  // the other one is nearer
    EXPECT_EQ(mot.counts().switches, 0);
    EXPECT_EQ(mot.counts().matches, 4);
    mot.addFrame(Points{{1, {8, 0}}, {2, {-4, 0}}}, Points{{0, {0, 0}}, {1, {4, 0}}});  // now too far
    EXPECT_EQ(mot.counts().switches, 2);
    EXPECT_EQ(mot.counts().misses, 0);
}

TEST(ClearMot, ATrackTakesUpOneTargetAlone) {
    ClearMot mot;
    mot.addFrame(Points{{1, {1, 0}}}, Points{{0, {0, 0}}, {1, {2, 0}}});
    EXPECT_EQ(mot.counts().matches, 1);
    EXPECT_EQ(mot.counts().misses, 1);
    EXPECT_EQ(ClearMot().counts().mota(), 0.0);
}

TEST(ComparedSets, LeaveOutDebrisAndTargetsOutOfSightWithTheirTracks) {
    SweepSnapshot snapshot;
    snapshot.objects = {{.target = 0, .position_m = {0, 0}, .visible = true},
                        {.target = 1, .position_m = {30, 0}, .visible = false}};
    snapshot.estimates = {{.track = 1, .position_m = {1, 0}},
                          {.track = 2, .position_m = {31, 0}},                    // of the one out of sight
                          {.track = 3, .position_m = {0, 5}, .on_debris = true},  // a stone near the target
                          {.track = 4, .position_m = {0, 1}, .on_debris = true},  // the target passes over a stone
                          {.track = 5, .position_m = {0, 30}}};                   // of nothing
    const ComparedSets sets = comparedSets(snapshot);
    ASSERT_EQ(sets.targets.size(), 1U);
    EXPECT_EQ(sets.targets[0].id, 0);
    ASSERT_EQ(sets.tracks.size(), 3U);
    EXPECT_EQ(sets.tracks[0].id, 1);
    EXPECT_EQ(sets.tracks[1].id, 4);
    EXPECT_EQ(sets.tracks[2].id, 5);
}

}  // namespace
}  // namespace echotrail
