#include "core/base/time.hpp"

#include <gtest/gtest.h>

namespace echotrail {
namespace {

TEST(Timestamp, PrintsIsoWithMicroseconds) {
    EXPECT_EQ(toIso8601(Timestamp{}), "1970-01-01T00:00:00.000000Z");
    EXPECT_EQ(toIso8601(Timestamp(Microseconds(1'116'773'599'890'000))), "2005-05-22T14:53:19.890000Z");
}

TEST(Timestamp, BeforeTheEpochPrintsToo) {
    EXPECT_EQ(toIso8601(Timestamp(Microseconds(-1))), "1969-12-31T23:59:59.999999Z");
}

TEST(Timestamp, SecondsRoundToTheNearestMicrosecond) {
    EXPECT_EQ(microsecondsFromSeconds(0.0784001).count(), 78'400);
    EXPECT_DOUBLE_EQ(secondsBetween(Timestamp(Microseconds(500'000)), Timestamp(Microseconds(2'000'000))), 1.5);
}

}  // namespace
}  // namespace echotrail
