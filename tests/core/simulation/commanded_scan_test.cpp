#include "core/simulation/commanded_scan.hpp"

#include "core/simulation/ping_model.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace echotrail {
namespace {

TEST(CommandedScan, UncommandedItIsTheScenariosOwn) {
    for (const Scenario& scenario : scenarios()) {
        CommandedScan scan(scenario);
        for (std::uint64_t ping = 0; ping < 250; ++ping) {
            const CommandedScan::Look look = scan.next();
            EXPECT_EQ(look.number, ping);
            EXPECT_NEAR(look.bearing - pingBearing(scenario, ping), 0.0, 1e-9) << scenario.name << " " << ping;
        }
    }
}

TEST(CommandedScan, TakesANewSectorWhenTheTransmissionUnderWayIsOver) {
    CommandedScan scan(Scenario{});
    for (int i = 0; i < 20; ++i) scan.next();
    scan.command({18.0, 18.0});
    EXPECT_NEAR(scan.next().bearing.inDegrees(), -9.0, 1e-9) << "20 steps of 1.8 degrees from -45: under way";
    EXPECT_NEAR(scan.next().bearing.inDegrees(), 9.0, 1e-9) << "its nearer edge";
    double least = 100, most = -100;
    for (int i = 0; i < 40; ++i) {
        const double bearing = scan.next().bearing.inDegrees();
        least = std::min(least, bearing);
        most = std::max(most, bearing);
    }
    EXPECT_NEAR(least, 9.0, 1e-9);
    EXPECT_NEAR(most, 27.0, 1e-9);
}

TEST(CommandedScan, GoesOnOverTheSameBearingsWhereTheSectorsAreWholeStepsApart) {
    CommandedScan scan(Scenario{});
    double last = scan.next().bearing.inDegrees();
    for (int i = 0; i < 300; ++i) {
        scan.command({0.0, i % 40 < 20 ? 36.0 : 90.0});
        const double bearing = scan.next().bearing.inDegrees();
        const double steps = (bearing + 45.0) / 1.8;
        EXPECT_NEAR(steps, std::round(steps), 1e-6);
        const double turn = std::abs(last) < 16 && std::abs(bearing) < 16 ? std::abs(bearing - last) : 0.0;
        EXPECT_LE(turn, 1.8 + 1e-9);
        last = bearing;
    }
}

TEST(CommandedScan, AFarTurnOfTheMotorTakesTime) {
    CommandedScan scan(Scenario{});
    EXPECT_EQ(scan.next().number, 0u);  // at -45 degrees
    scan.command({40.0, 7.2});
    EXPECT_EQ(scan.next().number, 1u);
    const CommandedScan::Look there = scan.next();
    EXPECT_NEAR(there.bearing.inDegrees(), 36.4, 0.1);
    EXPECT_EQ(there.number, 6u) << "80 degrees at 0.25 ms for each sixteenth of a gradian take 0.35 s more than a step";
}

TEST(CommandedScan, RoundAndRound) {
    CommandedScan scan(Scenario{});
    scan.command({0.0, 360.0});
    scan.next();
    double turned = 0.0;
    Bearing last = scan.next().bearing;
    for (int i = 0; i < 200; ++i) {
        const Bearing bearing = scan.next().bearing;
        turned += bearing - last;
        last = bearing;
    }
    EXPECT_NEAR(degreesFromRadians(turned), 360.0, 1e-6);
}

}  // namespace
}  // namespace echotrail
