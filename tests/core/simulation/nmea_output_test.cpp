#include "core/simulation/nmea_output.hpp"

#include "core/navigation/local_plane.hpp"
#include "core/navigation/navigation_stream.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace echotrail {
namespace {

using namespace std::chrono_literals;

constexpr Timestamp start = std::chrono::sys_days{std::chrono::year{2026} / 3 / 4} + 23h + 59min + 58s;

/// One whose instruments err.
const Scenario& movingScenario() {
    static const Scenario found = [] {
        const auto& all = scenarios();
        const auto erring =
            std::ranges::find_if(all, [](const Scenario& s) { return s.navigation.heading_noise_deg > 0.0; });
        return erring != all.end() ? *erring : Scenario{};
    }();
    return found;
}

NmeaSentence parsed(std::string_view line) {
    const auto read = parseNmeaLine(line);
    EXPECT_TRUE(read) << line;
    return read ? *read : NmeaSentence{};
}

NavigationSample sampleAt(double north_m, double east_m, double heading_deg) {
    NavigationSample sample;
    sample.pose = {north_m, east_m, Bearing::degrees(heading_deg)};
    return sample;
}

TEST(NmeaOutput, SaysHeadingsInThePositiveTurnThatRoundsToLessThanAWholeOne) {
    EXPECT_EQ(headingSentence(sampleAt(0, 0, 12.5)), "$HEHDT,12.50,T*29\r\n");
    EXPECT_EQ(parsed(headingSentence(sampleAt(0, 0, -90))).fields[0], "270.00");
    EXPECT_EQ(parsed(headingSentence(sampleAt(0, 0, -0.001))).fields[0], "0.00");
}

TEST(NmeaOutput, ItsPositionsAreReadBackToTheSamePlace) {
    for (const SimulatedPlace place :
         {SimulatedPlace{60.4, 5.3}, SimulatedPlace{-33.9, -179.999}, SimulatedPlace{0, 0}}) {
        const auto origin = readPosition(parsed(positionSentence(sampleAt(0, 0, 0), start, place)));
        ASSERT_TRUE(origin);
        EXPECT_NEAR(degreesFromRadians(origin->latitude_rad), place.latitude_deg, 1e-8);
        for (const auto& [north, east] : {std::pair{120.0, -45.0}, {-3000.0, 4000.0}, {7000.0, -7000.0}}) {
            const auto there = readPosition(parsed(positionSentence(sampleAt(north, east, 0), start, place)));
            ASSERT_TRUE(there);
            const LocalPosition local = LocalPlane(*origin).toLocal(*there);
            EXPECT_NEAR(local.north_m, north, 0.01);
            EXPECT_NEAR(local.east_m, east, 0.01);
        }
    }
}

TEST(NmeaOutput, MinutesNeverReachSixtyAndTheTimeIsTheDays) {
    const double nearly_minute = 59.99999999 / 60.0;
    const auto sentence =
        parsed(positionSentence(sampleAt(0, 0, 0), start + 250ms, {nearly_minute, 1 + nearly_minute}));
    EXPECT_EQ(sentence.fields[0], "235958.250");
    EXPECT_EQ(sentence.fields[1], "0100.000000");
    EXPECT_EQ(sentence.fields[3], "00200.000000");
}

TEST(NmeaOutput, SpeedsAreAlongAndAcrossTheVehicle) {
    NavigationSample sample = sampleAt(0, 0, 90);
    sample.over_ground_mps = {1.0, 2.0};
    sample.through_water_mps = {-0.5, 0.0};
    const auto sentence = parsed(speedSentence(sample));
    const auto ground = readVelocity(sentence);
    ASSERT_TRUE(ground);
    EXPECT_NEAR(ground->north_or_ahead_mps, 2.0, 1e-3);
    EXPECT_NEAR(ground->east_or_starboard_mps, -1.0, 1e-3);
    EXPECT_EQ(sentence.fields[0], "0.000");
    EXPECT_EQ(sentence.fields[1], "0.972");
}

TEST(NmeaOutput, SaysHeadingAndSpeedTenTimesASecondPositionAndDepthOnce) {
    NmeaOutput output(movingScenario(), 5, start);
    NavigationStream stream;
    for (Microseconds now{}; now <= 10s; now += 37ms)
        for (const auto& said : output.take(now)) {
            EXPECT_LE(said.at, now);
            stream.take(start + said.at, {reinterpret_cast<const std::uint8_t*>(said.text.data()), said.text.size()});
        }
    EXPECT_GT(output.deadline(), Microseconds(9990ms));
    const NavigationStatus& status = stream.status();
    EXPECT_TRUE(status.rejected.empty());
    EXPECT_EQ(status.used.at("HDT"), 100u);
    EXPECT_EQ(status.used.at("GGA"), 10u);
    EXPECT_EQ(status.used.at("DPT"), 10u);
    EXPECT_NEAR(status.depth_m.value(), altitudeAt(movingScenario(), 9.0), 0.5);
}

TEST(NmeaOutput, WhoListensKnowsThePoseThatNavigationTells) {
    const Scenario& scenario = movingScenario();
    NmeaOutput output(scenario, 5, start);
    SimulatedNavigation navigation(scenario, 5);
    PoseHistory told;
    NavigationStream stream;
    for (const auto& said : output.take(30s))
        stream.take(start + said.at, {reinterpret_cast<const std::uint8_t*>(said.text.data()), said.text.size()});
    for (int i = 0; i <= 600; ++i) {
        const NavigationSample sample = navigation.next();
        told.add({start + microsecondsFromSeconds(sample.time_s), sample.pose});
    }
    const auto first = told.at(start, 1.0);
    for (const auto second : {5, 15, 25}) {
        const auto heard = stream.poses().at(start + second * 1s, 1.0), truth = told.at(start + second * 1s, 1.0);
        ASSERT_TRUE(heard && truth && first);
        EXPECT_NEAR(heard->north_m, truth->north_m - first->north_m, 0.02);
        EXPECT_NEAR(heard->east_m, truth->east_m - first->east_m, 0.02);
        EXPECT_NEAR(heard->heading - truth->heading, 0.0, 1e-4);
    }
}

TEST(NmeaOutput, TheSameSeedSaysTheSameHoweverOftenItIsAsked) {
    NmeaOutput once(movingScenario(), 9, start), often(movingScenario(), 9, start);
    std::string all, pieces;
    for (const auto& said : once.take(7s)) all += said.text;
    for (Microseconds now{}; now <= 7s; now += 1ms)
        for (const auto& said : often.take(now)) pieces += said.text;
    EXPECT_EQ(all, pieces);
}

}  // namespace
}  // namespace echotrail
