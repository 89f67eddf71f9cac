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

}  // namespace
}  // namespace echotrail
