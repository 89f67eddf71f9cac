#include "program.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <map>
#include <set>

namespace echotrail {

namespace {

using Json = nlohmann::json;

const std::set<std::string> numbers{
    "t", "range_m", "bearing_deg", "north_m", "east_m", "velocity_north_mps", "velocity_east_mps"};

/// The tracks of the demonstration, written once: every test here reads the same lines.
const std::vector<Json>& demonstrationLines() {
    static const std::vector<Json> lines = [] {
        std::vector<Json> parsed;
        const Outcome outcome = run({"replay", "simulation://demonstration", "--tracks", "-", "--target", "39.8,-25"});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
        for (const std::string& line : linesOf(outcome.output)) parsed.push_back(Json::parse(line));
        return parsed;
    }();
    return lines;
}

/// The same without the summary.
std::vector<Json> trackLines() {
    const auto& all = demonstrationLines();
    return all.empty() ? all : std::vector<Json>(all.begin(), all.end() - 1);
}

TEST(TracksFile, EveryLineHasExactlyTheFixedFieldsAndFiniteNumbers) {
    ASSERT_GT(trackLines().size(), 20U);
    for (const Json& line : trackLines()) {
        EXPECT_EQ(line.size(), 14U) << line;
        EXPECT_EQ(line.at("time").get<std::string>().size(), std::string("2026-01-01T00:00:00.000000Z").size());
        for (const std::string& name : numbers) {
            ASSERT_TRUE(line.at(name).is_number()) << name << " in " << line;
            EXPECT_TRUE(std::isfinite(line.at(name).get<double>())) << name;
        }
        EXPECT_GE(line.at("bearing_deg").get<double>(), -180.0);
        EXPECT_LE(line.at("bearing_deg").get<double>(), 180.0);
        EXPECT_TRUE(line.at("track").is_number_integer());
        EXPECT_TRUE(line.at("target").is_boolean());
        EXPECT_TRUE(line.at("seen").is_boolean());
        EXPECT_EQ(line.at("cause").get<std::string>().empty(), line.at("seen").get<bool>()) << line;
        EXPECT_TRUE(std::set<std::string>({"tentative", "confirmed", "coasting", "lost"}).contains(line.at("state")));
    }
}

TEST(TracksFile, CovariancesArePositiveDefinite) {
    for (const Json& line : trackLines()) {
        const double nn = line["covariance_m2"][0], ne = line["covariance_m2"][1], ee = line["covariance_m2"][2];
        EXPECT_GT(nn, 0.0);
        EXPECT_GT(nn * ee - ne * ne, 0.0) << line;
    }
}

TEST(TracksFile, TimesNeverGoBackOverTheWholeFile) {
    double last = 0.0;
    for (const Json& line : trackLines()) {
        EXPECT_GE(line["t"].get<double>(), last);
        last = line["t"];
    }
    EXPECT_EQ(demonstrationLines().back()["summary"]["late_looks"], 0);
}

TEST(TracksFile, AFoundAgainTrackKeepsItsNumberAndIsConfirmed) {
    std::set<int> lost;
    for (const Json& line : trackLines()) {
        if (lost.erase(line["track"].get<int>()) > 0) {
            EXPECT_EQ(line["state"], "confirmed") << line;
        }
        if (line["state"] == "lost") lost.insert(line["track"].get<int>());
    }
}

TEST(TracksFile, TheDesignatedTargetIsOneTrackAndIsFollowedIn) {
    std::set<int> targets;
    double last_range = 0.0;
    for (const Json& line : trackLines()) {
        if (!line["target"].get<bool>()) continue;
        targets.insert(line["track"].get<int>());
        last_range = line["range_m"];
    }
    EXPECT_EQ(targets.size(), 1U);
    EXPECT_NEAR(last_range, 12.0, 2.5);  // where the demonstration ends
}

TEST(TracksFile, WithoutADesignationNothingIsTheTarget) {
    const Outcome outcome = run({"replay", "simulation://deep", "--tracks", "-"});
    const auto lines = linesOf(outcome.output);
    ASSERT_GT(lines.size(), 5U);
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) EXPECT_EQ(Json::parse(lines[i])["target"], false);
}

TEST(TracksFile, TheLastLineIsTheSummary) {
    const Json& last = demonstrationLines().back();
    ASSERT_EQ(last.size(), 1U);
    const Json& summary = last.at("summary");
    for (const char* name :
         {"pings", "skipped_bytes", "lost_records", "sweeps", "tracks", "data_seconds", "processing_seconds"})
        EXPECT_TRUE(summary.at(name).is_number()) << name;
    EXPECT_TRUE(summary.at("rejected").is_object());
    EXPECT_EQ(summary.at("exit_reason"), "end of recording");
    EXPECT_NEAR(summary.at("data_seconds").get<double>(), 150.0, 0.2);
    EXPECT_GE(summary.at("tracks").get<int>(), 1);
}

TEST(TracksFile, TwoRunsGiveTheSameFileButTheSummary) {
    const ScratchFolder folder;
    std::vector<std::string> files;
    for (const char* name : {"one", "two"}) {
        ASSERT_EQ(run({"replay", "simulation://demonstration?seed=4", "--seed", "9", "--tracks", folder.path(name)})
                      .exit_code,
                  0);
        const std::string content = contentOf(folder.path(name));
        files.push_back(content.substr(0, content.find("{\"summary\"")));
    }
    EXPECT_FALSE(files[0].empty());
    EXPECT_EQ(files[0], files[1]);
}

TEST(TracksFile, TheSameTracksComeOutWithTheFanPaintedOrNot) {
    const auto tracks = [](const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"replay", "simulation://deep", "--tracks", "-"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const std::string output = run(arguments).output;
        return output.substr(0, output.find("{\"summary\""));
    };
    EXPECT_EQ(tracks({}), tracks({"--no-fan"}));
}

TEST(TracksFile, DurationCountsTheSourcesOwnTime) {
    const Outcome outcome = run({"replay", "simulation://deep", "--duration", "20", "--tracks", "-"});
    const Json summary = Json::parse(linesOf(outcome.output).back())["summary"];
    EXPECT_EQ(summary["exit_reason"], "duration reached");
    EXPECT_NEAR(summary["data_seconds"].get<double>(), 20.0, 0.15);
}

}  // namespace

}  // namespace echotrail
