#include "ui/style/formatter.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace echotrail {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

TEST(Formatter, UsesATrueMinusAndThinGroups) {
    EXPECT_EQ(Formatter::number(-1184.25, 2), QString::fromUtf8("\u22121\u2009184.25"));
    EXPECT_EQ(Formatter::count(1234567), QString::fromUtf8("1\u2009234\u2009567"));
    EXPECT_EQ(Formatter::count(999), "999");
    EXPECT_EQ(Formatter::bytes(64'000'000), "64.0 MB");
    EXPECT_EQ(Formatter::bytes(1'940'000'000), "1.9 GB");
    EXPECT_EQ(Formatter::number(-0.04, 1), "0.0") << "no side where there is none";
}

TEST(Formatter, ShowsUnknownAsADashNeverAsZero) {
    for (const QString& text : {Formatter::number(not_known, 1), Formatter::range(not_known), Formatter::age(not_known),
                                Formatter::speed(not_known), Formatter::probability(not_known),
                                Formatter::withUnit(std::numeric_limits<double>::infinity(), 1, "dB")})
        EXPECT_EQ(text, QString::fromUtf8("\u2014"));
}

TEST(Formatter, GivesRangesTwoDecimalsBelowTenMetres) {
    EXPECT_EQ(Formatter::range(5.204), "5.20 m");
    EXPECT_EQ(Formatter::range(21.13), "21.1 m");
    EXPECT_EQ(Formatter::range(9.999), "10.0 m") << "not 10.00";
}

TEST(Formatter, WritesBearingsWithThreeDigitsAndWhatTheyAreMeasuredFrom) {
    EXPECT_EQ(Formatter::relativeBearing(Bearing::degrees(-17.04)), QString::fromUtf8("343.0°R"));
    EXPECT_EQ(Formatter::trueBearing(Bearing::degrees(45.3)), QString::fromUtf8("045.3°T"));
    EXPECT_EQ(Formatter::relativeBearing(Bearing::degrees(-0.01)), QString::fromUtf8("000.0°R"));
    EXPECT_EQ(Formatter::bearingMark(-15), QString::fromUtf8("\u221215°"));
    EXPECT_EQ(Formatter::bearingMark(0), QString::fromUtf8("00°"));
}

TEST(Formatter, WritesTimesAsIsoWithMilliseconds) {
    const Timestamp time{std::chrono::microseconds(1'274'601'612'950'999)};
    EXPECT_EQ(Formatter::utc(time), "2010-05-23T08:00:12.950Z");
}

TEST(Formatter, PlacesOnEarthAreDegreesAndMinutes) {
    EXPECT_EQ(Formatter::latitude(radiansFromDegrees(54.0 + 21.4183 / 60.0)), QString::fromUtf8("54°21.4183′ N"));
    EXPECT_EQ(Formatter::longitude(radiansFromDegrees(-(10.0 + 9.7712 / 60.0))), QString::fromUtf8("010°09.7712′ W"));
    EXPECT_EQ(Formatter::latitude(radiansFromDegrees(9.99999999)), QString::fromUtf8("10°00.0000′ N"));
    EXPECT_EQ(Formatter::latitude(std::nan("")), Formatter::unknown());
}

TEST(Formatter, OffsetsHaveASignUnlessTheyAreUnknown) {
    EXPECT_EQ(Formatter::signedNumber(14.5, 1), "+14.5");
    EXPECT_EQ(Formatter::signedNumber(-27.6, 1), QString::fromUtf8("−27.6"));
    EXPECT_EQ(Formatter::signedNumber(std::nan(""), 1), Formatter::unknown());
}

}  // namespace
}  // namespace echotrail
