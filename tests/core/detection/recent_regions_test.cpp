#include "core/detection/recent_regions.hpp"

#include <gtest/gtest.h>

namespace echotrail {
namespace {

constexpr MultipathRule rule{.farthest_m = 3.0, .weaker_db = 6.0};

Region at(double range_m, double bearing_deg, double peak_db, double seconds = 0.0) {
    Region region;
    region.time = Timestamp(microsecondsFromSeconds(100.0 + seconds));
    region.range_m = range_m;
    region.bearing = Bearing::degrees(bearing_deg);
    region.peak_db = peak_db;
    region.features.across_range_m = 1.5;
    return region;
}

TEST(RecentRegions, ExplainAWeakerOneALittleBehind) {
    RecentRegions recent;
    recent.add({at(20, 5, 60)});
    EXPECT_TRUE(recent.explain(at(21.5, 5, 50), rule));
    EXPECT_FALSE(recent.explain(at(21.5, 5, 55), rule)) << "hardly weaker";
    EXPECT_FALSE(recent.explain(at(18.5, 5, 50), rule)) << "nearer";
    EXPECT_FALSE(recent.explain(at(24, 5, 50), rule)) << "too far behind";
    EXPECT_FALSE(recent.explain(at(21.5, 12, 50), rule)) << "another bearing";
    EXPECT_FALSE(recent.explain(at(21.5, 5, 50, 4.0), rule)) << "another passage of the beam";
    EXPECT_FALSE(recent.explain(at(20, 5, 60), rule)) << "itself";
}

TEST(RecentRegions, SayWhetherAPlaceLayInAMass) {
    Region mass = at(20, 0, 60);
    mass.position_m = {20, 0};
    mass.features.along_range_m = 4;
    mass.features.across_range_m = 8;
    RecentRegions recent;
    recent.add({mass});
    EXPECT_FALSE(recent.hasMassAt({20, 0}, mass.time)) << "no mass";
    mass.clutter_mass = true;
    recent.add({mass});
    EXPECT_TRUE(recent.hasMassAt({21.5, 3.5}, mass.time));
    EXPECT_FALSE(recent.hasMassAt({22.5, 0}, mass.time)) << "behind";
    EXPECT_FALSE(recent.hasMassAt({20, 4.5}, mass.time)) << "beside";
    EXPECT_FALSE(recent.hasMassAt({20, 0}, mass.time + Microseconds(3'000'000))) << "another passage of the beam";
}

TEST(RecentRegions, AMassExplainsNothingAndOldOnesAreForgotten) {
    RecentRegions recent;
    Region mass = at(20, 5, 60);
    mass.clutter_mass = true;
    recent.add({mass});
    EXPECT_FALSE(recent.explain(at(21.5, 5, 50), rule));
    recent.add({at(20, 5, 60), at(40, 30, 60, 10.0)});
    EXPECT_FALSE(recent.explain(at(21.5, 5, 50), rule));
}

}  // namespace
}  // namespace echotrail
