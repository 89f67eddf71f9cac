#include "core/detection/echo_screen.hpp"

#include <gtest/gtest.h>

namespace echotrail {
namespace {

constexpr double cell_m = 0.125;

/// A row of 400 cells at level 10 with echoes of the given level at the given cells.
EchoRow rowWith(std::initializer_list<std::pair<int, int>> echoes, int width = 4) {
    EchoRow row;
    row.cell_m = cell_m;
    row.level.assign(400, 10);
    row.background.assign(400, 10);
    for (const auto& [cell, level] : echoes)
        for (int i = cell; i < cell + width; ++i) row.level[i] = static_cast<std::uint8_t>(level);
    row.smooth = row.level;
    return row;
}

struct Scan {
    EchoScreen screen{EchoScreenParams{}};
    std::vector<Candidate> closed;
    std::vector<RangeOfInterest> interests;
    void add(const EchoRow& row) { screen.add(row, interests, closed); }
    void quiet(int pings) {
        for (int i = 0; i < pings; ++i) add(rowWith({}));
    }
};

TEST(EchoScreen, ObjectIsReportedOnceTheBeamHasLeftIt) {
    Scan scan;
    scan.quiet(3);
    scan.add(rowWith({{100, 100}}));
    scan.add(rowWith({{101, 100}}));
    EXPECT_TRUE(scan.screen.isOpenWithin(12, 13));
    EXPECT_FALSE(scan.screen.isOpenWithin(20, 30));
    scan.quiet(1);
    EXPECT_TRUE(scan.closed.empty());
    scan.quiet(1);
    ASSERT_EQ(scan.closed.size(), 1u);
    EXPECT_EQ(scan.closed[0].first_ping, 3u);
    EXPECT_EQ(scan.closed[0].last_ping, 4u);
    EXPECT_EQ(scan.closed[0].first_cell, 100);
    EXPECT_EQ(scan.closed[0].last_cell, 104);
    EXPECT_FALSE(scan.screen.isOpenWithin(0, 50));
}

TEST(EchoScreen, ObjectsApartInRangeAreApart) {
    Scan scan;
    scan.add(rowWith({{100, 100}, {200, 100}}));
    scan.add(rowWith({{100, 100}, {200, 100}}));
    scan.quiet(2);
    EXPECT_EQ(scan.closed.size(), 2u);
}

TEST(EchoScreen, BranchesThatMeetLaterAreOne) {
    Scan scan;
    scan.add(rowWith({{100, 100}, {110, 100}}));
    scan.add(rowWith({{100, 100}}, 14));
    scan.quiet(2);
    ASSERT_EQ(scan.closed.size(), 1u);
    EXPECT_EQ(scan.closed[0].first_cell, 100);
    EXPECT_EQ(scan.closed[0].last_cell, 113);
}

TEST(EchoScreen, ThresholdIsLoweredAndBlankingLiftedWhereAnObjectIsExpected) {
    const int faint = 10 + static_cast<int>(9 * levels_per_db);  // 9 dB: between 8 and 12
    Scan scan;
    scan.add(rowWith({{100, faint}, {4, 200}}));
    scan.quiet(2);
    EXPECT_TRUE(scan.closed.empty());
    scan.interests = {{12, 13}, {0.4, 1.2}};
    scan.add(rowWith({{100, faint}, {4, 200}}));
    scan.quiet(2);
    ASSERT_EQ(scan.closed.size(), 2u);
    EXPECT_TRUE(scan.closed[0].of_interest);
}

TEST(EchoScreen, EndOfSweepCompletesWhatIsOpen) {
    Scan scan;
    scan.add(rowWith({{100, 100}}));
    scan.screen.endSweep(scan.closed);
    EXPECT_EQ(scan.closed.size(), 1u);
    scan.quiet(3);
    EXPECT_EQ(scan.closed.size(), 1u);
}

TEST(EchoScreen, BankWithoutEndIsCut) {
    Scan scan;
    for (int i = 0; i < 3 * EchoScreen::max_pings; ++i) scan.add(rowWith({{100, 100}}));
    EXPECT_GE(scan.closed.size(), 2u);
    for (const Candidate& part : scan.closed) EXPECT_LE(part.last_ping - part.first_ping, EchoScreen::max_pings);
}

}  // namespace
}  // namespace echotrail
