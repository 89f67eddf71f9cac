#include "core/simulation/scenario_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace echotrail {
namespace {

const std::string head = "name = 'a'\ndescription = 'b'\n";

std::string errorOf(const std::string& toml) {
    const auto read = readScenario(toml, "trial.toml");
    EXPECT_FALSE(read.has_value()) << toml;
    return read ? "" : read.error();
}

TEST(ScenarioFile, SetsWhatItNamesAndLeavesTheRest) {
    const auto read =
        readScenario(head +
                     "gain_db = 3\nshadows = true\n[vehicle]\nspeed_mps = 0.5\n[[targets]]\nsize_m = 2.0\n"
                     "path = [[0, 1, 2], [5, 6, 7.5]]\nfades = [[1, 2, 30]]\n[[debris]]\nnorth_m = 9\n"
                     "[[debris_fields]]\ncount = 4\nnorth_m = 10\n");
    ASSERT_TRUE(read.has_value()) << read.error();
    EXPECT_EQ(read->gain_db, 3.0);
    EXPECT_TRUE(read->shadows);
    EXPECT_EQ(read->vehicle.speed_mps, 0.5);
    EXPECT_EQ(read->range_m, Scenario{}.range_m);
    ASSERT_EQ(read->targets.size(), 1U);
    ASSERT_EQ(read->targets[0].path.size(), 2U);
    EXPECT_EQ(read->targets[0].path[1].east_m, 7.5);
    EXPECT_EQ(read->targets[0].fades.at(0).depth_db, 30.0);
    EXPECT_EQ(read->debris.at(0).north_m, 9.0);
    EXPECT_EQ(allDebris(*read, 1).size(), 5U);
}

TEST(ScenarioFile, ErrorsNameTheFileTheLineAndTheFault) {
    EXPECT_EQ(errorOf(head + "gain_db = \n").substr(0, 11), "trial.toml:");
    EXPECT_EQ(errorOf(head + "gain = 3\n").substr(0, 13), "trial.toml:3:");
    EXPECT_NE(errorOf(head + "gain_db = 1000\n").find("gain_db"), std::string::npos);
    EXPECT_NE(errorOf(head + "gain_db = nan\n").find("gain_db must be a number"), std::string::npos);
    EXPECT_NE(errorOf(head + "gain_db = [1]\n").find("gain_db must be a number"), std::string::npos);
    EXPECT_NE(errorOf(head + "vehicle = 3\n").find("vehicle must be a table"), std::string::npos);
    EXPECT_NE(errorOf(head + "targets = 3\n").find("[[targets]]"), std::string::npos);
    EXPECT_NE(errorOf("name = 'a'\n").find("description is missing"), std::string::npos);
    EXPECT_NE(errorOf("name = 7\ndescription = 'b'\n").find("name is missing"), std::string::npos);
}

TEST(ScenarioFile, PathsThatCannotBeGoneAreErrors) {
    const std::string target = head + "[[targets]]\n";
    EXPECT_NE(errorOf(target).find("a target needs a path"), std::string::npos);
    EXPECT_NE(errorOf(target + "path = []\n").find("a target needs a path"), std::string::npos);
    EXPECT_NE(errorOf(target + "path = [[0, 1]]\n").find("rows of three numbers"), std::string::npos);
    EXPECT_NE(errorOf(target + "path = [[0, 1, 'x']]\n").find("rows of three numbers"), std::string::npos);
    EXPECT_NE(errorOf(target + "path = [[0, 1, inf]]\n").find("rows of three numbers"), std::string::npos);
    EXPECT_NE(errorOf(target + "path = [[0, 1, 2], [0, 2, 3]]\n").find("times of a path must rise"), std::string::npos);
    EXPECT_NE(errorOf(target + "loop = true\npath = [[0, 1, 2], [1, 2, 3]]\n").find("a loop needs"), std::string::npos);
}

TEST(ScenarioFile, ScenesThatCannotBeAreErrors) {
    EXPECT_NE(errorOf(head + "step_deg = 1.7\n").find("whole number of steps"), std::string::npos);
    EXPECT_NE(errorOf(head + "altitude_swing_m = 20\n").find("bottom rises"), std::string::npos);
    EXPECT_NE(errorOf(head + "water_depth_m = 3\n").find("above the water"), std::string::npos);
    EXPECT_NE(errorOf(head + "[vehicle]\nfollow_lag_s = 9\n").find("no target to follow"), std::string::npos);
    EXPECT_NE(errorOf(head + "[vehicle]\nfollow_lag_s = 9\n[[targets]]\npath = [[0, 3, 4]]\n").find("origin"),
              std::string::npos);
}

TEST(ScenarioFile, CutAnywhereItIsReadOrRefusedWithAWord) {
    const std::string_view whole = scenarioTexts().front().toml;
    for (std::size_t length = 0; length < whole.size(); ++length) {
        const auto read = readScenario(whole.substr(0, length), "cut");
        EXPECT_TRUE(read || read.error().substr(0, 4) == "cut:") << length;
    }
}

TEST(BuiltInScenarios, AreThoseOfTheFilesEachNamedAsItsFile) {
    std::set<std::string> names;
    for (const ScenarioText& text : scenarioTexts()) {
        const auto read = readScenario(text.toml, std::string(text.file));
        ASSERT_TRUE(read.has_value()) << read.error();
        EXPECT_EQ(read->name + ".toml", text.file);
        names.insert(read->name);
    }
    EXPECT_EQ(names.size(), scenarios().size());
    for (const char* name : {"S1", "S2", "S3", "S4", "S5", "demonstration", "deep", "empty"})
        EXPECT_TRUE(names.contains(name)) << name;
}

}  // namespace
}  // namespace echotrail
