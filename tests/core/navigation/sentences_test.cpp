#include "core/navigation/sentences.hpp"

#include "tests/core/navigation/nmea_lines.hpp"

#include <gtest/gtest.h>

namespace echotrail {
namespace {

NmeaSentence sentence(const std::string& body) {
    const auto parsed = parseNmeaLine("$" + withChecksum(body));
    EXPECT_TRUE(parsed);
    return *parsed;
}

TEST(HeadingSentence, TrueHeadingIsReadAsItStands) {
    const auto reading = readHeading(sentence("HEHDT,274.07,T"));
    ASSERT_TRUE(reading);
    EXPECT_NEAR(reading->heading.inDegrees(), -85.93, 1e-9);
    EXPECT_FALSE(reading->magnetic);
}

TEST(HeadingSentence, MagneticHeadingTakesDeviationAndVariationEastPositive) {
    const auto corrected = readHeading(sentence("HCHDG,98.3,1.0,W,12.6,E"));
    ASSERT_TRUE(corrected);
    EXPECT_NEAR(corrected->heading.inDegrees(), 109.9, 1e-9);
    EXPECT_FALSE(corrected->magnetic);
    const auto bare = readHeading(sentence("HCHDG,98.3,,,,"));
    ASSERT_TRUE(bare);
    EXPECT_NEAR(bare->heading.inDegrees(), 98.3, 1e-9);
    EXPECT_TRUE(bare->magnetic);
}

TEST(HeadingSentence, NumbersThatAreNoHeadingAreBadFields) {
    for (const char* body : {"HEHDT,,T", "HEHDT,360.1,T", "HEHDT,-1,T", "HEHDT,nan,T", "HEHDT,inf,T", "HEHDT,1e2,T",
                             "HEHDT,12x,T", "HEHDT", "HCHDG,98.3,,,12.6,", "HCHDG,98.3,,,12.6,N"}) {
        const auto reading = readHeading(sentence(body));
        ASSERT_FALSE(reading) << body;
        EXPECT_EQ(reading.error(), "bad_field") << body;
    }
}

TEST(PositionSentence, DegreesAndMinutesAreReadFromBothKinds) {
    for (const char* body : {"GPRMC,123519,A,4807.038,N,01131.000,W,022.4,084.4,230394,003.1,W",
                             "GPGGA,123519,4807.038,N,01131.000,W,1,08,0.9,545.4,M,46.9,M,,"}) {
        const auto position = readPosition(sentence(body));
        ASSERT_TRUE(position) << body;
        EXPECT_NEAR(degreesFromRadians(position->latitude_rad), 48.1173, 1e-9);
        EXPECT_NEAR(degreesFromRadians(position->longitude_rad), -11.0 - 31.0 / 60.0, 1e-9);
    }
}

TEST(PositionSentence, NoFixAndDamagedFieldsHaveTheirCauses) {
    EXPECT_EQ(readPosition(sentence("GPRMC,123519,V,,,,,,,230394,,")).error(), "not_valid");
    EXPECT_EQ(readPosition(sentence("GPGGA,123519,,,,,0,00,,,M,,M,,")).error(), "not_valid");
    EXPECT_EQ(readPosition(sentence("GPRMC,123519,A,4867.038,N,01131.000,E,,,,,")).error(), "bad_field");
    EXPECT_EQ(readPosition(sentence("GPRMC,123519,A,9107.038,N,01131.000,E,,,,,")).error(), "bad_field");
    EXPECT_EQ(readPosition(sentence("GPRMC,123519,A,4807.038,E,01131.000,N,,,,,")).error(), "bad_field");
    EXPECT_EQ(readPosition(sentence("GPGGA,123519,4807.038,N,01131.000,E,x,,,,,,,,")).error(), "bad_field");
    EXPECT_EQ(readPosition(sentence("GPRMC")).error(), "bad_field");
}

TEST(VelocitySentence, CourseAndSpeedBecomeNorthAndEast) {
    const auto velocity = readVelocity(sentence("GPVTG,90.0,T,,M,3.6,N,6.7,K,A"));
    ASSERT_TRUE(velocity);
    EXPECT_NEAR(velocity->north_or_ahead_mps, 0.0, 1e-9);
    EXPECT_NEAR(velocity->east_or_starboard_mps, 1.852, 1e-9);
    EXPECT_FALSE(velocity->along_vehicle);
}

TEST(VelocitySentence, StandingStillNeedsNoCourse) {
    const auto velocity = readVelocity(sentence("GPVTG,,T,,M,0.00,N,0.00,K,A"));
    ASSERT_TRUE(velocity);
    EXPECT_EQ(velocity->north_or_ahead_mps, 0.0);
    EXPECT_EQ(readVelocity(sentence("GPVTG,,T,,M,1.00,N,1.85,K,A")).error(), "bad_field");
    EXPECT_EQ(readVelocity(sentence("GPVTG,,T,,M,,N,,K,N")).error(), "not_valid");
}

TEST(VelocitySentence, LogGivesSpeedOverGroundAlongTheVehicle) {
    const auto velocity = readVelocity(sentence("VDVBW,9.0,9.0,A,3.6,-1.8,A"));
    ASSERT_TRUE(velocity);
    EXPECT_NEAR(velocity->north_or_ahead_mps, 1.852, 1e-9);
    EXPECT_NEAR(velocity->east_or_starboard_mps, -0.926, 1e-9);
    EXPECT_TRUE(velocity->along_vehicle);
    EXPECT_EQ(readVelocity(sentence("VDVBW,9.0,9.0,A,,,V")).error(), "not_valid");
}

}  // namespace
}  // namespace echotrail
