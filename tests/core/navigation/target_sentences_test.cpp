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

}  // namespace
}  // namespace echotrail
