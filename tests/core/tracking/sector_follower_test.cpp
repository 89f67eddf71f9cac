#include "core/tracking/sector_follower.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace echotrail {
namespace {

constexpr double step_deg = 1.8;

TargetOutlook outlook(double range_m, double from_bow_deg, TrackState state = TrackState::Confirmed, int misses = 0,
                      double sigma_m = 0.3) {
    TargetOutlook target{.state = state, .misses = misses, .expected = {}, .across_range_m = 1.0};
    const double azimuth = radiansFromDegrees(from_bow_deg);
    target.expected.mean << range_m * std::cos(azimuth), range_m * std::sin(azimuth), 0, 0;
    target.expected.covariance = sigma_m * sigma_m * Eigen::Matrix4d::Identity();
    return target;
}

FollowParams following() { return {.follow_target = true, .follow_look_round_s = 0.0}; }

/// A follower whose beam has been all over the operator's sector, and goes on to be where it is told.
class Head {
public:
    explicit Head(const FollowParams& params = following(), const HeadSettings& operators = {})
        : follower(params), settings(operators) {
        const ScanSector all = scanSector(settings);
        for (double at = 0; at <= all.width_deg; at += step_deg)
            choose(std::nullopt, (all.left() + radiansFromDegrees(at)).inDegrees());
    }

    std::optional<ScanSector> choose(const std::optional<TargetOutlook>& target, double beam_deg = 0.0) {
        BeamMoment beam;
        beam.time = Timestamp(Microseconds(100'000 * ping++));
        beam.azimuth = Bearing::degrees(beam_deg);
        beam.step_rad = radiansFromDegrees(step_deg);
        beam.beam_width_rad = radiansFromDegrees(3);
        return follower.choose(target, beam, settings);
    }

    SectorFollower follower;
    HeadSettings settings;
    int ping = 0;
};

double left(const ScanSector& sector) { return sector.centre_deg - sector.width_deg / 2; }
double right(const ScanSector& sector) { return sector.centre_deg + sector.width_deg / 2; }

TEST(SectorFollower, OffItNeverNarrowsTheSector) {
    Head head(FollowParams{});
    for (double bearing = -60; bearing <= 60; bearing += 5) EXPECT_FALSE(head.choose(outlook(20, bearing)));
}

TEST(SectorFollower, HoldsTheExpectedPlaceWithItsMarginAndNeverLeavesTheOperatorsSector) {
    for (const double centre : {0.0, -30.0, 170.0})
        for (const double range : {5.0, 20.0, 45.0})
            for (const double sigma : {0.1, 0.5, 1.5})
                for (double bearing = -44; bearing <= 44; bearing += 3.7) {
                    Head head(following(), {.sector_centre_deg = centre, .sector_width_deg = 90});
                    const auto chosen = head.choose(outlook(range, centre + bearing, TrackState::Confirmed, 0, sigma));
                    if (!chosen) continue;  // too much of it is needed
                    EXPECT_TRUE(contains(scanSector(head.settings), *chosen)) << centre << " " << bearing;
                    EXPECT_GE(chosen->width_deg, FollowParams{}.follow_least_width_deg - 1e-6);
                    const double margin = degreesFromRadians(std::atan2(3 * sigma + 0.5, range));
                    const double off =
                        degreesFromRadians(Bearing::degrees(centre + bearing) - Bearing::degrees(chosen->centre_deg));
                    // As much of it as the operator's sector has.
                    const double from = std::max(bearing - margin, -45.0), until = std::min(bearing + margin, 45.0);
                    EXPECT_GE(from - bearing + off, -chosen->width_deg / 2 - 1e-6);
                    EXPECT_LE(until - bearing + off, chosen->width_deg / 2 + 1e-6);
                }
}

TEST(SectorFollower, ATargetInTheMiddleIsScannedSeveralTimesAsOften) {
    Head head;
    const auto chosen = head.choose(outlook(20, 3));
    ASSERT_TRUE(chosen);
    EXPECT_LT(chosen->width_deg, 30);
    EXPECT_LT(left(*chosen), 3 - 5);
    EXPECT_GT(right(*chosen), 3 + 5);
}

TEST(SectorFollower, EdgesAreWholeStepsFromTheEdgeTheHeadCountsFrom) {
    for (const bool inverted : {false, true})
        for (double bearing = -40; bearing < 40; bearing += 2.3) {
            Head head(following(), {.sector_width_deg = 91, .mount_inverted = inverted});
            const auto chosen = head.choose(outlook(20, bearing));
            ASSERT_TRUE(chosen);
            const double anchor = inverted ? -45.5 : 45.5;
            for (const double edge : {left(*chosen), right(*chosen)}) {
                if (std::abs(std::abs(edge) - 45.5) < 1e-6) continue;  // cut off by the operator's sector
                const double steps = (edge - anchor) / step_deg;
                EXPECT_NEAR(steps, std::round(steps), 1e-6);
            }
        }
}

TEST(SectorFollower, IsKeptWhileItWillDo) {
    Head head;
    const auto first = head.choose(outlook(20, 0));
    int changes = 0;
    auto last = first;
    for (double bearing = 0; bearing < 20; bearing += 0.1) {
        const auto chosen = head.choose(outlook(20, bearing));
        changes += chosen != last;
        last = chosen;
    }
    EXPECT_NE(first, last);
    EXPECT_LE(changes, 10) << "20 degrees, with 2 to spare each time";
}

TEST(SectorFollower, EachMissWidensItUntilItIsTheOperatorsAndALostTargetHasNone) {
    Head head;
    double width = head.choose(outlook(20, 3))->width_deg;
    int misses = 1;
    for (; misses < 6; ++misses) {
        const auto chosen = head.choose(outlook(20, 3, TrackState::Coasting, misses));
        if (!chosen) break;
        EXPECT_GT(chosen->width_deg, width) << misses;
        width = chosen->width_deg;
    }
    EXPECT_GT(misses, 2) << "step by step";
    EXPECT_LT(misses, 6);
    EXPECT_FALSE(head.choose(outlook(20, 3, TrackState::Lost, 4)));
    EXPECT_FALSE(head.choose(std::nullopt));
    EXPECT_FALSE(head.choose(outlook(20, 3, TrackState::Tentative)));
    const auto again = head.choose(outlook(20, 3));
    ASSERT_TRUE(again);
    EXPECT_LT(again->width_deg, 30) << "found again";
}

TEST(SectorFollower, NarrowsAgainAfterAMiss) {
    Head head;
    const double before = head.choose(outlook(20, 3))->width_deg;
    EXPECT_GT(head.choose(outlook(20, 3, TrackState::Coasting, 1))->width_deg, before);
    EXPECT_NEAR(head.choose(outlook(20, 3))->width_deg, before, 2 * step_deg);
}

TEST(SectorFollower, ATargetAtTheEdgeIsScannedUpToItAndOneBeyondItLeavesTheWholeSector) {
    Head head;
    const auto chosen = head.choose(outlook(20, 44));
    ASSERT_TRUE(chosen);
    EXPECT_NEAR(right(*chosen), 45, 1e-6);
    EXPECT_GE(chosen->width_deg, FollowParams{}.follow_least_width_deg - 1e-6);
    EXPECT_FALSE(head.choose(outlook(20, 70)));
    EXPECT_FALSE(head.choose(outlook(20, 180)));
}

TEST(SectorFollower, FollowsAcrossTheSternOfAFullCircle) {
    Head head(following(), {.sector_width_deg = 360});
    const auto chosen = head.choose(outlook(20, 179));
    ASSERT_TRUE(chosen);
    EXPECT_LT(chosen->width_deg, 30);
    EXPECT_LT(std::abs(Bearing::degrees(chosen->centre_deg) - Bearing::degrees(179)), radiansFromDegrees(5));
    EXPECT_EQ(head.choose(outlook(20, -179)), chosen) << "two degrees on";
}

TEST(SectorFollower, WhatMayBeAnywhereAboutTheHeadIsLookedForEverywhere) {
    Head head;
    EXPECT_FALSE(head.choose(outlook(2, 3, TrackState::Confirmed, 0, 2.0)));
}

TEST(SectorFollower, LooksRoundNowAndThenUntilTheBeamHasBeenEverywhere) {
    FollowParams params = following();
    params.follow_look_round_s = 5.0;
    Head head(params);
    int narrow = 0;
    while (head.choose(outlook(20, 0))) ++narrow;
    EXPECT_NEAR(narrow, 50, 2) << "pings of 0.1 s";
    for (double beam = 0; beam < 45; beam += step_deg) EXPECT_FALSE(head.choose(outlook(20, 0), beam));
    for (double beam = 45; beam > -43; beam -= step_deg) EXPECT_FALSE(head.choose(outlook(20, 0), beam)) << beam;
    EXPECT_TRUE(head.choose(outlook(20, 0), -45));
}

TEST(SectorFollower, BeginsWhenTheOperatorsSectorHasBeenSeen) {
    Head head;
    ASSERT_TRUE(head.choose(outlook(20, 0)));
    head.settings.sector_width_deg = 120;
    EXPECT_FALSE(head.choose(outlook(20, 0))) << "there is more of it now";
    for (double beam = -60; beam < 58; beam += step_deg) EXPECT_FALSE(head.choose(outlook(20, 0), beam));
    EXPECT_TRUE(head.choose(outlook(20, 0), 60));
}

}  // namespace
}  // namespace echotrail
