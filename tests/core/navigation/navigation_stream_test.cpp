#include "core/navigation/navigation_stream.hpp"

#include "nmea_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace echotrail {
namespace {

constexpr Timestamp start{Microseconds(1'274'601'600'000'000)};

/// Lines without TAG blocks, as a live instrument sends them: their time is that of their arrival.
class Stream : public testing::Test {
protected:
    void say(double after_s, const std::string& body) { bytes(after_s, "$" + withChecksum(body) + "\r\n"); }
    void bytes(double after_s, const std::string& text) {
        stream_.take(start + microsecondsFromSeconds(after_s),
                     {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    }
    Pose at(double after_s) const {
        const auto pose = stream_.poses().at(start + microsecondsFromSeconds(after_s), 0.5);
        EXPECT_TRUE(pose) << "no pose at " << after_s << " s";
        return pose.value_or(Pose{});
    }
    std::uint64_t rejected(std::string_view cause) const {
        const auto found = stream_.status().rejected.find(std::string(cause));
        return found == stream_.status().rejected.end() ? 0 : found->second;
    }
    NavigationStream stream_;
};

TEST_F(Stream, HeadingsAloneTurnTheVehicleWhereItStands) {
    say(0.0, "HEHDT,350.0,T");
    say(0.2, "HEHDT,010.0,T");
    EXPECT_NEAR(at(0.1).heading.inDegrees(), 0.0, 1e-9);  // the short way round
    EXPECT_EQ(at(0.1).north_m, 0.0);
    EXPECT_EQ(stream_.status().heading_kind, "HDT");
    EXPECT_EQ(stream_.status().position_kind, "");
}

TEST_F(Stream, OfALongRunOnlyTheLastPosesAreKept) {
    for (int i = 0; i < 3000; ++i) say(1.0 * i, "HEHDT,010.0,T");
    EXPECT_FALSE(stream_.poses().at(start, 0.5));
    EXPECT_NEAR(at(2400.0).heading.inDegrees(), 10.0, 1e-9);
}

TEST_F(Stream, ATrueHeadingTakesOverFromAMagneticOne) {
    say(0.0, "HCHDG,100.0,,,,");
    EXPECT_EQ(stream_.status().heading_kind, "HDG, magnetic");
    say(0.1, "HEHDT,090.0,T");
    say(0.2, "HCHDG,100.0,,,,");
    EXPECT_NEAR(at(0.1).heading.inDegrees(), 90.0, 1e-9);
    EXPECT_EQ(stream_.status().unused.at("HDG"), 1u);
}

TEST_F(Stream, ASpeedAlongTheBowCarriesThePlaceOn) {
    for (int i = 0; i <= 20; ++i) {
        say(0.1 * i, "HEHDT,090.0,T");
        say(0.1 * i, "VDVBW,,,V,1.9438445,0.0,A");  // 1 m/s
    }
    EXPECT_NEAR(at(2.0).east_m, 2.0, 1e-5);
    EXPECT_NEAR(at(1.0).north_m, 0.0, 1e-9);
    EXPECT_EQ(stream_.status().position_kind, "VBW");
}

TEST_F(Stream, TheFirstFixIsLaidWhereReckoningHasCome) {
    for (int i = 0; i <= 10; ++i) {
        say(0.1 * i, "HEHDT,000.0,T");
        say(0.1 * i, "VDVBW,,,V,1.9438445,0.0,A");
    }
    say(1.1, "HEHDT,000.0,T");
    say(1.1, "GPGGA,120000,4500.0000,N,00700.0000,E,1,08,1.0,0,M,0,M,,");
    EXPECT_NEAR(at(1.1).north_m, at(1.0).north_m, 0.11);
    say(1.2, "HEHDT,000.0,T");
    say(1.2, "GPGGA,120000,4500.0010,N,00700.0000,E,1,08,1.0,0,M,0,M,,");
    EXPECT_NEAR(at(1.2).north_m - at(1.1).north_m, 1.852, 0.01);  // a thousandth of a minute of latitude
    EXPECT_EQ(stream_.status().position_kind, "GGA");
}

TEST_F(Stream, AFixAndASpeedAtOneMomentBothCount) {
    say(0.0, "HEHDT,000.0,T");
    say(0.0, "VDVBW,,,V,1.9438445,0.0,A");
    say(0.0, "GPGGA,120000,4500.0000,N,00700.0000,E,1,08,1.0,0,M,0,M,,");
    EXPECT_TRUE(stream_.status().rejected.empty());
    EXPECT_EQ(stream_.status().position_kind, "GGA");
}

TEST_F(Stream, HeadingsWaitForASlowerPositionAndAreThenInterpolated) {
    say(0.0, "HEHDT,000.0,T");
    say(0.0, "GPGGA,120000,4500.0000,N,00700.0000,E,1,08,1.0,0,M,0,M,,");
    for (int i = 1; i < 10; ++i) say(0.1 * i, "HEHDT,000.0,T");
    EXPECT_EQ(stream_.reachedUntil(), start);
    say(1.0, "GPGGA,120001,4500.0010,N,00700.0000,E,1,08,1.0,0,M,0,M,,");
    EXPECT_NEAR(at(0.5).north_m, 0.926, 0.01);
}

TEST_F(Stream, AcrossAGapNothingIsInvented) {
    say(0.0, "HEHDT,000.0,T");
    say(5.0, "HEHDT,090.0,T");
    EXPECT_FALSE(stream_.poses().at(start + microsecondsFromSeconds(2.5), 1.0));
    EXPECT_NEAR(at(5.0).heading.inDegrees(), 90.0, 1e-9);
}

TEST_F(Stream, AnySplitOfTheBytesGivesTheSamePoses) {
    std::string text;
    for (int i = 0; i < 8; ++i) text += nmeaLine(100 * i, "HEHDT,0" + std::to_string(10 + i) + ".0,T");
    bytes(10.0, text);
    NavigationStream byte_by_byte;
    for (const char c : text) {
        const auto byte = static_cast<std::uint8_t>(c);
        byte_by_byte.take(start + microsecondsFromSeconds(10.0), {&byte, 1});
    }
    for (double t = 0.0; t < 0.7; t += 0.05)
        EXPECT_EQ(byte_by_byte.poses().at(start + microsecondsFromSeconds(t), 0.5), at(t));
}

TEST_F(Stream, BadLinesAreCountedByCauseAndCostNothingElse) {
    say(0.0, "HEHDT,010.0,T");
    bytes(0.1, "$HEHDT,020.0,T*00\r\n");
    bytes(0.1, std::string(5000, 'x') + "\n");
    say(0.1, "HEHDT,nan,T");
    bytes(0.1, "$HEHDT,03");  // the link breaks here
    stream_.linkChanged();
    say(0.2, "HEHDT,020.0,T");
    say(0.1, "HEHDT,030.0,T");
    EXPECT_EQ(rejected(nmea_cause::bad_checksum), 1u);
    EXPECT_EQ(rejected(nmea_cause::malformed), 2u);
    EXPECT_EQ(rejected(nmea_cause::bad_field), 1u);
    EXPECT_EQ(rejected(nmea_cause::out_of_order), 1u);
    EXPECT_NEAR(at(0.2).heading.inDegrees(), 20.0, 1e-9);
    EXPECT_EQ(stream_.status().used.at("HDT"), 2u);
}

TEST_F(Stream, DepthIsTold) {
    say(0.0, "SDDPT,12.5,0.3");
    EXPECT_EQ(stream_.status().depth_m, 12.5);
    say(0.1, "SDDBT,30.0,f,9.1,M,5.0,F");
    EXPECT_EQ(stream_.status().depth_m, 9.1);
}

}  // namespace
}  // namespace echotrail
