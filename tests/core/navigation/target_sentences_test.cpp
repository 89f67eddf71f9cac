#include "core/navigation/target_sentences.hpp"

#include "core/navigation/nmea.hpp"

#include <gtest/gtest.h>

namespace echotrail {
namespace {

TEST(TargetSentences, ATtmTellsTheTargetAndReadsBack) {
    TrackLook look;
    look.track = 107;
    look.state = TrackState::Confirmed;
    look.range_m = 25.0;
    look.bearing = Bearing::degrees(-10.0);
    look.velocity_mps = {0.0, 1.0};
    const auto sentence = parseNmeaLine(ttmSentence(look, 4.0, 30.0));
    ASSERT_TRUE(sentence) << sentence.error();
    EXPECT_EQ(sentence->id, "TTM");
    EXPECT_EQ(sentence->field(0), "07");
    EXPECT_EQ(sentence->field(1), "0.0250");
    EXPECT_EQ(sentence->field(2), "350.0");
    EXPECT_EQ(sentence->field(4), "3.60");
    EXPECT_EQ(sentence->field(5), "90.0");
    EXPECT_EQ(sentence->field(7), "0.0040");
    EXPECT_EQ(sentence->field(8), "0.500");
    EXPECT_EQ(sentence->field(11), "T");
}

TEST(TargetSentences, ATllTellsWhereOnEarthAndWhen) {
    TrackLook look;
    look.track = 107;
    look.state = TrackState::Coasting;
    look.time = Timestamp(std::chrono::sys_days{std::chrono::year{2026} / 1 / 1}) + std::chrono::hours(13) +
                std::chrono::milliseconds(65'432);
    const auto at = [](double latitude_deg, double longitude_deg) {
        return GeographicPosition{radiansFromDegrees(latitude_deg), radiansFromDegrees(longitude_deg)};
    };
    EXPECT_TRUE(
        tllSentence(look, at(60.5, 5.25)).starts_with("$RATLL,07,6030.000000,N,00515.000000,E,,130105.432,Q,*"));
    look.state = TrackState::Confirmed;
    const auto sentence = parseNmeaLine(tllSentence(look, at(-0.125, -170.0)));
    ASSERT_TRUE(sentence) << sentence.error();
    EXPECT_EQ(sentence->id, "TLL");
    EXPECT_EQ(sentence->field(1), "0007.500000");
    EXPECT_EQ(sentence->field(2), "S");
    EXPECT_EQ(sentence->field(3), "17000.000000");
    EXPECT_EQ(sentence->field(4), "W");
    EXPECT_EQ(sentence->field(7), "T");
}

}  // namespace
}  // namespace echotrail
