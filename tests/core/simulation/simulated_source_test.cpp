#include "core/simulation/simulated_source.hpp"

#include "core/simulation/demonstration.hpp"
#include "core/simulation/ping_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace echotrail {
namespace {

std::unique_ptr<SimulatedSource> open(std::string_view name, std::uint64_t seed = 1) {
    auto opened = openSimulation(name, seed);
    EXPECT_TRUE(opened.has_value());
    return *std::move(opened);
}

std::vector<Ping> take(PingSource& source, int count) {
    std::vector<Ping> pings;
    while (count-- > 0)
        if (auto ping = source.next()) pings.push_back(std::move(*ping));
    return pings;
}

TEST(SimulatedSource, SameSeedGivesTheSameBytes) {
    EXPECT_EQ(take(*open("demonstration", 7), 60), take(*open("demonstration", 7), 60));
}

TEST(SimulatedSource, AnotherSeedGivesOtherEchoesOnTheSameBeams) {
    const auto first = take(*open("demonstration", 7), 3), other = take(*open("demonstration", 8), 3);
    ASSERT_EQ(first.size(), other.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_NE(first[i].levels, other[i].levels);
        EXPECT_EQ(first[i].bearing, other[i].bearing);
        EXPECT_EQ(first[i].time, other[i].time);
    }
}

TEST(SimulatedSource, RewindGivesTheSamePingsAgain) {
    const auto source = open("demonstration");
    const auto before = take(*source, 40);
    source->rewind();
    EXPECT_EQ(take(*source, 40), before);
}

TEST(SimulatedSource, KeptPingsAreThoseThatWouldBeMadeAnew) {
    const auto source = open("demonstration"), kept = open("demonstration");
    kept->keepPings();
    const auto expected = take(*source, 40);
    EXPECT_EQ(take(*kept, 30), std::vector<Ping>(expected.begin(), expected.begin() + 30));
    kept->rewind();
    EXPECT_EQ(take(*kept, 40), expected);  // kept ones, then new ones
}

TEST(SimulatedSource, AllItsScenariosOpenAndHoldWhatTheyAnnounce) {
    for (Scenario scenario : scenarios()) {
        EXPECT_EQ(open(scenario.name)->info().name, scenario.name);
        scenario.duration_s = std::min(scenario.duration_s, 60.0);
        const auto source = std::make_unique<SimulatedSource>(scenario, 1);
        std::uint64_t pings = 0;
        Timestamp last{};
        while (const auto ping = source->next()) {
            EXPECT_EQ(ping->sequence, pings++);
            last = ping->time;
        }
        EXPECT_EQ(pings, source->info().pings);
        EXPECT_EQ(last, source->info().end);
        EXPECT_NEAR(secondsBetween(source->info().start, last), scenario.duration_s, pingInterval(scenario));
    }
}

TEST(SimulatedSource, UnknownNameIsAnErrorThatNamesTheKnownOnes) {
    const auto opened = openSimulation("atlantis", 1);
    ASSERT_FALSE(opened.has_value());
    EXPECT_NE(opened.error().find("atlantis"), std::string::npos);
    for (const Scenario& scenario : scenarios()) EXPECT_NE(opened.error().find(scenario.name), std::string::npos);
}

TEST(SimulatedSource, TheDemonstrationIsTheScenarioOfThatName) {
    auto demonstration = makeDemonstration(5);
    ASSERT_TRUE(demonstration.has_value());
    EXPECT_EQ(take(**demonstration, 5), take(*open("demonstration", 5), 5));
}

TEST(SimulatedSource, DemoIsShortForTheDemonstration) {
    EXPECT_EQ(take(*open("demo", 5), 5), take(*open("demonstration", 5), 5));
}

TEST(SimulatedSource, TheBeamIsOnATargetOnceASweep) {
    Scenario scenario;
    scenario.duration_s = 5.2;
    scenario.targets = {{.path = {{0, 20, 0}}}};
    int on = 0;
    for (const TruthSample& sample : SimulatedSource(scenario, 1).truth()) on += sample.in_beam ? 1 : 0;
    EXPECT_EQ(on, 1);  // half the lobe is narrower than a step
}

TEST(SimulatedSource, NavigationBetweenItsSamplesAgreesWithTheMotion) {
    const auto source = open("demonstration");
    while (const auto ping = source->next()) {
        // When the last echo of a ping comes back, too.
        for (const Timestamp time : {ping->time, ping->time + Microseconds(67'000)}) {
            const auto pose = source->navigation().at(time, 0.05);
            ASSERT_TRUE(pose.has_value());
            const Pose truth = vehiclePose(source->scenario(), secondsBetween(simulation_start, time));
            EXPECT_NEAR(pose->north_m, truth.north_m, 1e-6);
            EXPECT_NEAR(pose->east_m, truth.east_m, 1e-6);
            EXPECT_NEAR(pose->heading - truth.heading, 0.0, radiansFromDegrees(0.001));
        }
    }
}

TEST(SimulatedSource, NavigationBeginsAtTheOriginOfTheLocalFrame) {
    EXPECT_EQ(open("demonstration")->navigation().at(simulation_start, 0.05), Pose{});
}

TEST(SimulatedSource, TruthHoldsEveryPingAndTarget) {
    Scenario scenario = open("deep")->scenario();
    scenario.duration_s = 3.0;
    scenario.targets.push_back({.path = {{0, 10, 0}}});
    SimulatedSource source(scenario, 1);
    const auto truth = source.truth();
    ASSERT_EQ(truth.size(), 2 * source.info().pings);
    for (std::size_t i = 0; const Ping& ping : take(source, static_cast<int>(source.info().pings)))
        for (int target = 0; target < 2; ++target, ++i) {
            EXPECT_EQ(truth[i].time, ping.time);
            EXPECT_EQ(truth[i].target, target);
        }
}

TEST(SimulatedSource, TruthOfAScenarioWithoutTargetsIsEmpty) { EXPECT_TRUE(open("empty")->truth().empty()); }

TEST(SimulatedSource, ATargetIsVisibleOnlyInsideSectorAndRange) {
    struct Case {
        double range_m, bearing_deg;
        bool visible;
    };
    for (const Case& c : {Case{49.9, 0, true}, Case{50.1, 0, false}, Case{20, 44.5, true}, Case{20, 45.5, false},
                          Case{20, -44.5, true}, Case{20, -45.5, false}, Case{20, 180, false}}) {
        Scenario scenario;
        scenario.duration_s = 0.0;
        const double bearing = radiansFromDegrees(c.bearing_deg);
        scenario.targets = {{.path = {{0, c.range_m * std::cos(bearing), c.range_m * std::sin(bearing)}}}};
        const auto truth = SimulatedSource(scenario, 1).truth();
        ASSERT_EQ(truth.size(), 1U);
        EXPECT_EQ(truth[0].visible, c.visible) << c.range_m << " m at " << c.bearing_deg << " deg";
    }
}

}  // namespace
}  // namespace echotrail
