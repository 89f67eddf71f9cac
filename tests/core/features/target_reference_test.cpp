#include "core/features/target_reference.hpp"

#include "core/base/angles.hpp"
#include "core/features/likeness_deviations.hpp"
#include "core/features/region_shape.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace echotrail {
namespace {

EchoGeometry at(double range_m) { return {range_m, radiansFromDegrees(3.0), 0.7}; }

/// What the sonar shows of an object of the given extent (method card, section e).
RegionFeatures seen(double across_m, double along_m, double range_m) {
    const double across = std::hypot(across_m, 1.41 * radiansFromDegrees(3.0) * range_m);
    const double along = std::hypot(along_m, 0.7);
    const double e = across / along, root = (e - 1 / e) / (4 * M_PI);
    return {M_PI / 4 * across * along, momentFeature(root * root), along, across};
}

TEST(TargetReference, PredictsItsOwnLookAndThatAtOtherRanges) {
    const TargetReference reference(seen(1.0, 0.3, 20), at(20));
    for (const double range : {8.0, 20.0, 45.0}) {
        const RegionFeatures expected = reference.expected(at(range)), true_look = seen(1.0, 0.3, range);
        EXPECT_NEAR(expected.area_m2, true_look.area_m2, 1e-9);
        EXPECT_NEAR(expected.moment, true_look.moment, 1e-9);
    }
}

TEST(TargetReference, PurerLooksCountForMoreThanThoseThatHaveRunIntoSomethingElse) {
    const RegionFeatures pure = seen(1.0, 0.3, 5), merged = seen(4.0, 0.3, 5);
    TargetReference first_merged(merged, at(5)), first_pure(pure, at(5));
    EXPECT_FALSE(first_merged.settled());
    for (int i = 0; i < 5; ++i) {
        first_merged.learn(pure, at(5), 0.1);
        first_pure.learn(merged, at(5), 0.1);
    }
    EXPECT_TRUE(first_merged.settled());
    const double extent = merged.across_range_m - pure.across_range_m;
    EXPECT_LT(first_merged.expected(at(5)).across_range_m, pure.across_range_m + 0.05 * extent);
    EXPECT_LT(first_pure.expected(at(5)).across_range_m, pure.across_range_m + 0.6 * extent);
}

TEST(TargetReference, FollowsAStrongerEchoFasterThanAFaintOne) {
    const auto levelAfter = [](double first_db, double then_db) {
        RegionFeatures a = seen(1.0, 0.3, 5), b = a;
        a.level_db = first_db;
        b.level_db = then_db;
        TargetReference reference(a, at(5));
        for (int i = 0; i < 8; ++i) reference.learn(b, at(5), 0.1);
        return reference.expected(at(5)).level_db;
    };
    EXPECT_GT(levelAfter(40, 60), 58);
    EXPECT_GT(levelAfter(60, 40), 45);
}

TEST(TargetReference, LearnsNothingWhereItIsToldNotTo) {
    TargetReference reference(seen(1.0, 0.3, 5), at(5));
    const double before = reference.expected(at(5)).area_m2;
    for (int i = 0; i < 20; ++i) reference.learn(seen(4.0, 0.3, 5), at(5), 0.0);
    EXPECT_EQ(reference.expected(at(5)).area_m2, before);
}

TEST(TargetReference, LearnsSlowlyAndNeverBeyondTwiceTheFirst) {
    TargetReference reference(seen(1.0, 0.3, 5), at(5));
    for (int i = 0; i < 5; ++i) reference.learn(seen(1.0, 0.3, 5), at(5), 1.0);
    const double before = reference.expected(at(5)).area_m2;
    reference.learn(seen(4.0, 0.3, 5), at(5), 1.0);
    EXPECT_LT(reference.expected(at(5)).area_m2, 1.06 * before);
    for (int i = 0; i < 200; ++i) reference.learn(seen(9.0, 0.3, 5), at(5), 1.0);
    EXPECT_NEAR(reference.expected(at(5)).across_range_m, 2 * seen(1.0, 0.3, 5).across_range_m, 1e-6);
}

TEST(Likeness, IsOneForItselfAndFallsWithDifference) {
    const RegionFeatures a = seen(1, 0.3, 20), b = seen(2, 0.3, 20), c = seen(5, 1, 20);
    for (const Fusion fusion : {Fusion::Product, Fusion::Sum}) {
        LikenessParams params;
        params.fusion = fusion;
        EXPECT_DOUBLE_EQ(likeness(a, a, params), 1.0);
        EXPECT_LT(likeness(b, a, params), 1.0);
        EXPECT_LT(likeness(c, a, params), likeness(b, a, params));
        EXPECT_GE(likeness(c, a, params), 0.0);
    }
}

TEST(Likeness, TenPercentOfAreaAtAQuarterSigmaKeepsItsWeight) {
    RegionFeatures a = seen(1, 0.3, 20), b = a;
    b.area_m2 *= 1.1;
    LikenessParams published;
    published.area_sigma = 0.25;
    EXPECT_NEAR(likeness(b, a, published), 0.92, 0.015);  // method card, section 0: 0.92 with the squared form
}

TEST(Likeness, IsMadeOfTheDeviationsThatCanBeReadOneByOne) {
    const RegionFeatures expected{1.0, -1.4, 0.8, 1.5, 20.0, 50.0};
    const RegionFeatures region{2.0, -1.1, 0.9, 2.6, 12.0, 45.0};
    LikenessParams params;
    params.area_sigma = std::log(2.0);
    params.moment_sigma = 0.6;
    params.strength_sigma_db = 4.0;
    const LikenessDeviations off = likenessDeviations(region, expected, params);
    EXPECT_NEAR(off.area, 1.0, 1e-12);
    EXPECT_NEAR(off.moment, 0.5, 1e-12);
    EXPECT_NEAR(off.strength, -2.0, 1e-12);
    EXPECT_NEAR(off.level, -0.5, 1e-12);
    EXPECT_NEAR(likeness(region, expected, params), std::exp(-0.5 * 1.25), 1e-12);
    EXPECT_NEAR(levelLikeness(region.level_db, expected.level_db, params), std::exp(-0.125), 1e-12);
    params.strength_sigma_db = 1000.0;
    EXPECT_EQ(likenessDeviations(region, expected, params).strength, 0.0) << "left out";
}

}  // namespace
}  // namespace echotrail
