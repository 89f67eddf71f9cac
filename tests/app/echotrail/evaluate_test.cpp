#include "program.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace echotrail {

namespace {

// A strong target before a quiet bottom, for half a minute: six sweeps.
constexpr const char* scene = R"(name = "easy"
description = "A strong target in deep water"
duration_s = 32.0
water_depth_m = 60.0
altitude_m = 40.0
[[targets]]
strength_db = 15.0
path = [[0, 20, 2], [32, 20, -2]]
)";

class Evaluate : public testing::Test {
protected:
    ScratchFolder folder_;
    std::string scene_ = folder_.write("easy.toml", scene);
};

/// Without what depends on the machine.
nlohmann::json figuresOf(const std::string& text) {
    auto json = nlohmann::json::parse(text);
    json.erase("memory_mb");
    for (auto& one : json["scenes"])
        for (auto& result : one["results"]) result["figures"].erase("processing_ms");
    for (auto& all : json["all_scenes"]) all["figures"].erase("processing_ms");
    return json;
}

TEST_F(Evaluate, FiguresDoNotDependOnTheNumberOfThreads) {
    const auto with = [&](const char* threads) {
        const Outcome outcome = run({"evaluate", scene_, "--trials", "3", "--threads", threads, "--json", "-"});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
        return figuresOf(outcome.output);
    };
    const auto one = with("1");
    EXPECT_EQ(one, with("3"));
    EXPECT_EQ(one["trials_done"], 3);
    EXPECT_EQ(one["scenes"][0]["results"][0]["trials"][2]["seed"], 3);
    EXPECT_GE(one["scenes"][0]["results"][0]["trials"][0]["opportunities"].get<int>(), 4);
}

TEST_F(Evaluate, EverySetOfParametersIsAColumnBesideTheDefault) {
    const std::string deaf = folder_.write("deaf.toml", "seed_excess_db = 40\n");
    const Outcome outcome =
        run({"evaluate", scene_, "--trials", "1", "--parameters", deaf, "--html", folder_.path("report.html")});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    EXPECT_NE(outcome.output.find("default"), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find("deaf.toml"), std::string::npos) << outcome.output;
    const std::string page = contentOf(folder_.path("report.html"));
    EXPECT_NE(page.find("seed_excess_db = 40 dB"), std::string::npos);
    EXPECT_NE(page.find("<svg"), std::string::npos);
}

TEST_F(Evaluate, NamesJoinedByPlusLieOverOneAnotherAndMayNameTheScene) {
    folder_.write("for-easy.toml", "seed_excess_db = 33\n");
    const Outcome outcome = run({"evaluate", scene_, "--trials", "1", "--parameters",
                                 "paper+ablations/area_only+" + folder_.path("for-{scene}.toml"), "--json", "-"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
    const auto column = nlohmann::json::parse(outcome.output)["columns"][1];
    EXPECT_EQ(column["title"], "paper+area_only+for-{scene}.toml");
    const std::string settings = column["settings"].dump();
    for (const char* setting : {"likelihood = lookup", "area_share = 1", "seed_excess_db = 33 dB"})
        EXPECT_NE(settings.find(setting), std::string::npos) << setting << " in " << settings;
    EXPECT_EQ(run({"evaluate", scene_, "--parameters", "paper+nothing"}).exit_code, 2);
}

TEST_F(Evaluate, ARequirementThatIsNotMetIsExitCodeThree) {
    const Outcome met = run({"evaluate", scene_, "--trials", "1", "--require", "loss_percent=100"});
    EXPECT_EQ(met.exit_code, 0) << met.output << met.errors;
    const Outcome missed =
        run({"evaluate", scene_, "--trials", "1", "--require", "loss_percent=100", "--require", "deviation_mean_m=0"});
    EXPECT_EQ(missed.exit_code, 3) << missed.output;
    EXPECT_NE(missed.errors.find("1 of 2 requirements are not met"), std::string::npos) << missed.errors;
    EXPECT_NE(missed.output.find("NOT MET  deviation_mean_m=0"), std::string::npos) << missed.output;
}

TEST_F(Evaluate, ARecordingIsHeldAgainstItsTruth) {
    const std::string log = folder_.path("demo.echotrail"), truth = folder_.path("truth.csv");
    ASSERT_EQ(run({"simulate", "demonstration", "--duration", "40", "--log", log, "--truth", truth}).exit_code, 0);
    const Outcome outcome = run({"evaluate", log, "--truth", truth, "--trials", "1", "--json", "-"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
    const auto trial = nlohmann::json::parse(outcome.output)["scenes"][0]["results"][0]["trials"][0];
    EXPECT_GE(trial["opportunities"].get<int>(), 5);
    EXPECT_GE(trial["correct"].get<int>(), 2);
    EXPECT_EQ(run({"evaluate", log}).exit_code, 2) << "no truth";
    EXPECT_EQ(run({"evaluate", log, "--truth", folder_.write("bad.csv", "t\n")}).exit_code, 1);
}

TEST_F(Evaluate, WrongCommandLinesAreExitCodeTwoWithOneLine) {
    const std::vector<std::vector<std::string>> wrong{{"nowhere"},
                                                      {scene_, "--trials", "0"},
                                                      {scene_, "--parameters", folder_.path("none.toml")},
                                                      {scene_, "--require", "loss=3"},
                                                      {scene_, "--require", "S9/loss_percent=3"},
                                                      {scene_, "--require", "other:loss_percent=3"},
                                                      {scene_, "--truth", folder_.path("none.csv")}};
    for (std::vector<std::string> arguments : wrong) {
        arguments.insert(arguments.begin(), "evaluate");
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.exit_code, 2) << arguments.back() << outcome.errors;
        EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
        EXPECT_EQ(outcome.output, "");
    }
    EXPECT_EQ(run({"evaluate", scene_, "--json", folder_.path("no folder/x.json")}).exit_code, 1);
}

}  // namespace

}  // namespace echotrail
