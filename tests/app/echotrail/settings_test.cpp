#include "core/pipelines/scanning_sonar_pipeline.hpp"
#include "program.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace echotrail {

namespace {

const std::string log = std::string(ECHOTRAIL_SHARED_DATA) + "/seanet/seaking_dfs_v4log/seaking_dfs_first312.V4LOG";

TEST(ReplayHelp, ListsEveryParameterWithUnitLimitsDefaultAndMeaning) {
    const std::string help = run({"replay", "--help"}).output;
    for (const ParameterInfo& info : describeParameters<ScanningSonarPipeline::Params>()) {
        const std::string unit = info.unit.empty() ? "" : " " + info.unit;
        const std::string name = info.name + " = " + ParameterInfo::toText(info.default_value) + unit + "  (";
        EXPECT_NE(help.find(name), std::string::npos) << name;
        EXPECT_NE(help.find(info.help), std::string::npos) << info.help;
        EXPECT_NE(help.find("\n" + info.group + "\n"), std::string::npos) << info.group;
    }
}

TEST(Usage, WrongCommandLinesAreExitCodeTwoWithOneLine) {
    const ScratchFolder folder;
    const std::string source = "simulation://deep";
    const std::vector<std::vector<std::string>> wrong{
        {},
        {"nonsense"},
        {"replay"},
        {"info"},
        {"replay", source, "--unknown"},
        {"replay", source, "--set", "sound_speeed=1500"},
        {"replay", source, "--set", "sound_speed"},
        {"replay", source, "--set", "sound_speed=9"},
        {"replay", source, "--set", "sound_speed=fast"},
        {"replay", source, "--parameters", folder.path("none.toml")},
        {"replay", source, "--parameters", folder.write("bad.toml", "sound_speed = [1")},
        {"replay", source, "--parameters", folder.write("limit.toml", "sound_speed = 9000")},
        {"replay", source, "--speed", "0"},
        {"replay", source, "--speed", "fast"},
        {"replay", source, "--target", "20"},
        {"replay", source, "--target", "-4,10"},
        {"replay", source, "--seed", "-1"},
        {"replay", source, "--duration", "-1"},
        {"replay", "serial:///dev/ttyUSB0?baud=115200"},
        {"replay", "tcp://localhost:4001"},
        {"replay", "simulation://nowhere"},
        {"replay", "simulation://deep?speed=3"},
        {"info", "simulation://deep?seed=three"},
        {"simulate", "demo", "--truth", folder.path("t.csv"), "--set", "follow_target=true"},
        {"simulate", "demo", "--truth", folder.path("t.csv"), "--vehicle", "keep_range_m=15"},
        {"simulate", "demo", "--truth", folder.path("t.csv"), "--picture", folder.path("p.svg")},
        {"simulate", "demo", "--truth", folder.path("t.csv"), "--paths", folder.path("p.csv")},
        {"simulate", "demo", "--pursue", "--serve-sonar", "tcp://127.0.0.1:0"}};
    for (const auto& arguments : wrong) {
        const Outcome outcome = run(arguments);
        std::string line;
        for (const std::string& argument : arguments) line += argument + " ";
        EXPECT_EQ(outcome.exit_code, 2) << line << outcome.errors;
        EXPECT_TRUE(isOneLine(outcome.errors)) << line << outcome.errors;
        EXPECT_EQ(outcome.output, "") << line;
    }
}

TEST(Usage, AMistypedParameterIsAnsweredWithTheNearestOne) {
    const std::string errors = run({"replay", "simulation://deep", "--set", "sound_speeed=1500"}).errors;
    EXPECT_NE(errors.find("did you mean sound_speed?"), std::string::npos) << errors;
}

TEST(Info, TellsWhatIsInAScenario) {
    const auto info = nlohmann::json::parse(run({"info", "simulation://demonstration", "--json"}).output);
    EXPECT_EQ(info["format"], "simulation");
    EXPECT_EQ(info["range_scale_m"], nlohmann::json({50.0, 50.0}));
    EXPECT_EQ(info["bearing_deg"], nlohmann::json({-45.0, 45.0}));
    EXPECT_EQ(info["navigation"], true);
    EXPECT_GT(info["pings"].get<int>(), 1000);
}

TEST(Info, TellsWhatIsInARealLog) {
    if (!std::filesystem::exists(log)) GTEST_SKIP() << "needs the shared recordings";
    const auto info = nlohmann::json::parse(run({"info", log, "--json"}).output);
    EXPECT_EQ(info["pings"], 312);
    EXPECT_EQ(info["sound_speed_mps"], 1475.0);
    EXPECT_EQ(info["start"], "2005-05-22T14:53:19.890000Z");
    EXPECT_NE(run({"info", log}).output.find("1475.0 m/s"), std::string::npos);
}

TEST(SoundSpeed, OfALogHoldsUnlessItIsSet) {
    if (!std::filesystem::exists(log)) GTEST_SKIP() << "needs the shared recordings";
    const ScratchFolder folder;
    const std::string same = folder.write("same.toml", "sound_speed = 1475.0\n");
    const std::string other = folder.write("other.toml", "sound_speed = 1490.0\n");  // the default, but said
    const auto tracks = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"replay", log, "--tracks", "-"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const std::string output = run(arguments).output;
        return output.substr(0, output.find("{\"summary\""));
    };
    const std::string stored = tracks({});
    EXPECT_FALSE(stored.empty());
    EXPECT_EQ(tracks({"--parameters", same}), stored);
    EXPECT_NE(tracks({"--parameters", other}), stored);
    EXPECT_NE(tracks({"--set", "sound_speed=1490"}), stored);
    EXPECT_EQ(tracks({"--parameters", other, "--set", "sound_speed=1475"}), stored);
}

TEST(Navigation, OfAFilePlacesTracksFromWhereTheVehicleWasAtTheFirstPing) {
    if (!std::filesystem::exists(log)) GTEST_SKIP() << "needs the shared recordings";
    // The vehicle stands still and faces east; the log begins at 14:53:19.89.
    std::string lines;
    for (int i = 0; i < 400; ++i) {
        const std::string time = "c:" + std::to_string(1116773595000LL + i * 100LL);
        const std::string heading = "HEHDT,90.0,T";
        const auto sum = [](const std::string& text) {
            int all = 0;
            for (const char c : text) all ^= c;
            char digits[3];
            std::snprintf(digits, sizeof digits, "%02X", static_cast<unsigned>(all));
            return std::string(digits);
        };
        lines += "\\" + time + "*" + sum(time) + "\\$" + heading + "*" + sum(heading) + "\r\n";
    }
    const ScratchFolder folder;
    const Outcome outcome = run({"replay", log, "--tracks", "-", "--navigation", folder.write("heading.nmea", lines)});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    const auto all = linesOf(outcome.output);
    ASSERT_GT(all.size(), 3U);
    for (std::size_t i = 0; i + 1 < all.size(); ++i) {
        const auto line = nlohmann::json::parse(all[i]);
        EXPECT_GT(line["east_m"].get<double>(), 0.0);  // what lies ahead lies to the east
        EXPECT_GT(line["east_m"].get<double>(), std::abs(line["north_m"].get<double>()));
    }
    const auto summary = nlohmann::json::parse(all.back())["summary"];
    EXPECT_EQ(summary["pings_without_pose"], 0);
    EXPECT_EQ(run({"replay", log, "--navigation", folder.path("none.nmea")}).exit_code, 1);
    // A line that is damaged is rejected, and that is said.
    const auto damaged =
        run({"replay", log, "--navigation", folder.write("damaged.nmea", lines + "$HEHDT,90.0,T*00\r\n")});
    EXPECT_EQ(damaged.exit_code, 3);
    EXPECT_NE(damaged.errors.find("navigation lines rejected"), std::string::npos) << damaged.errors;
}

}  // namespace

}  // namespace echotrail
