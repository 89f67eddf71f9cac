#include "core/simulation/truth_file.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <vector>

namespace echotrail {
namespace {

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

SimulatedSource still() {
    Scenario scene;
    scene.duration_s = 1.0;
    scene.targets = {{.path = {{0, 30, 0}}}, {.path = {{0, 0, 30}}}};
    return {scene, 1};
}

TEST(TruthFile, HasItsFixedHeaderAndALineForEveryPingAndTarget) {
    const SimulatedSource source = still();
    const auto lines = linesOf(truthCsv(source));
    ASSERT_EQ(lines.size(), 1 + 2 * source.info().pings);
    EXPECT_EQ(lines[0], "t,target,north_m,east_m,velocity_north_mps,velocity_east_mps,visible");
    EXPECT_EQ(lines[1], "0.000000,0,30.0000,0.0000,0.0000,0.0000,1");
    EXPECT_EQ(lines[2], "0.000000,1,0.0000,30.0000,0.0000,0.0000,0");
    EXPECT_EQ(lines[3].substr(0, 9), "0.102114,");
}

TEST(TruthFile, FromTheHeadGivesRangeAndBearing) {
    const auto lines = linesOf(truthFromHeadCsv(still()));
    EXPECT_EQ(lines[0], "t,target,range_m,bearing_deg,visible");
    EXPECT_EQ(lines[1], "0.000000,0,30.0000,0.0000,1");
    EXPECT_EQ(lines[2], "0.000000,1,30.0000,90.0000,0");
}

TEST(TruthFile, IsItsHeaderAloneWithoutTargets) {
    EXPECT_EQ(linesOf(truthCsv(SimulatedSource(Scenario{}, 1))).size(), 1U);
}

}  // namespace
}  // namespace echotrail
