#include "core/evaluation/report.hpp"

#include "core/evaluation/svg.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace echotrail {
namespace {

Timestamp at(double seconds) { return Timestamp(microsecondsFromSeconds(seconds)); }

TrialResult trial(std::uint64_t seed, int correct) {
    TrialResult result{.scenario = "S1", .seed = seed, .range_scale_m = 50, .data_s = 100, .pings = 1000};
    for (int i = 0; i < 20; ++i) {
        const bool good = i < correct;
        result.looks.push_back({.time = at(5 * i),
                                .outcome = good ? LookOutcome::Correct : LookOutcome::Absent,
                                .cause = good ? LossCause::None : LossCause::UnderThreshold});
        if (!good) continue;
        result.outputs.push_back({.time = at(5 * i), .seen = true, .correct = true, .error_m = {0.6, 0.8}, .nees = 2});
        result.snapshots.push_back(
            {.time = at(5 * i), .estimates = {{1, {20, 1.0 * i}}}, .objects = {{0, {20, 1.0 * i}, true}}});
    }
    return result;
}

/// Two scenes, two columns; the second column was not run on the second scene.
EvaluationReport smallReport() {
    EvaluationReport report{.program = "echotrail 0",
                            .scenes = {{"S1", "shallow"}, {"own", "a <scene> & \"more\""}},
                            .columns = {{"default", {}}, {"a<b>.toml", {"seed_excess_db = 14 dB"}}},
                            .first_seed = 7,
                            .trials = 2};
    for (std::size_t s = 0; s < 2; ++s) {
        auto& row = report.summaries.emplace_back();
        auto& examples = report.examples.emplace_back();
        for (std::size_t c = 0; c < 2; ++c) {
            const bool none = s == 1 && c == 1;
            std::vector<TrialMetrics> trials;
            if (!none) trials = {measure(trial(7, c == 0 ? 19 : 18)), measure(trial(8, c == 0 ? 20 : 15))};
            row.push_back(summarise(report.scenes[s].name, report.columns[c].title, std::move(trials)));
            examples.push_back(none ? TrialResult{} : trial(7, 19));
        }
    }
    report.interrupted = true;
    report.verdicts = {{"loss_percent=5", "S1", "default", 2.5, true},
                       {"loss_percent=5", "own", "a<b>.toml", {}, false}};
    return report;
}

bool holds(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

TEST(TextReport, SetsEveryColumnBesideThePublishedFigure) {
    const std::string text = textReport(smallReport());
    EXPECT_TRUE(holds(text, "Loss rate, %\n"));
    // 1 of 40 lost: Wilson's interval is 0.4 to 12.9 %; 2.5 is at most half of 15.6.
    EXPECT_TRUE(holds(text, "15.6       2.5 (0.4 to 12.9) *")) << text;
    EXPECT_TRUE(holds(text, "17.5 (8.7 to 31.9)")) << text;
    EXPECT_TRUE(holds(text, "6 of 8 trials"));
    EXPECT_TRUE(holds(text, "NOT MET  loss_percent=5  own, a<b>.toml: not measured"));
    EXPECT_TRUE(holds(text, "Lost looks: under the threshold"));
}

TEST(JsonReport, HoldsEveryFigureAndTrialAndNullWhereNothingWasRun) {
    const auto json = nlohmann::json::parse(jsonReport(smallReport()));
    EXPECT_EQ(json["trials_done"], 6);
    EXPECT_EQ(json["interrupted"], true);
    const auto& first = json["scenes"][0];
    EXPECT_EQ(first["scene"], "S1");
    EXPECT_NEAR(first["published"]["loss_percent"].get<double>(), 15.6, 1e-9);
    EXPECT_TRUE(json["scenes"][1]["published"].is_null());
    EXPECT_NEAR(first["results"][0]["figures"]["loss_percent"]["value"].get<double>(), 2.5, 1e-9);
    EXPECT_NEAR(first["results"][0]["figures"]["deviation_mean_m"]["value"].get<double>(), 1.0, 1e-9);
    EXPECT_EQ(first["results"][0]["trials"].size(), 2U);
    EXPECT_EQ(first["results"][0]["trials"][0]["causes"]["under the threshold"], 1);
    EXPECT_EQ(first["results"][0]["trials"][0]["lost"][0]["time"], "1970-01-01T00:01:35.000000Z");
    EXPECT_TRUE(json["scenes"][1]["results"][1]["figures"]["loss_percent"].is_null());
    for (const Metric& metric : metricTable())
        EXPECT_TRUE(first["results"][0]["figures"].contains(std::string(metric.name))) << metric.name;
    EXPECT_NEAR(json["all_scenes"][0]["figures"]["loss_percent"]["value"].get<double>(), 2.5, 1e-9);
    EXPECT_EQ(json["requirements"][1]["met"], false);
}

TEST(JsonReport, TakesAnyBytesInATitle) {
    EvaluationReport report = smallReport();
    report.columns[1].title = "\xff\xfe.toml";
    EXPECT_FALSE(nlohmann::json::parse(jsonReport(report)).is_null());
}

TEST(HtmlReport, NeedsNothingBesideItAndTrustsNoName) {
    const std::string page = htmlReport(smallReport());
    EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
    for (const char* outside : {"<script", "src=", "@import", "<link", "url("})
        EXPECT_FALSE(holds(page, outside)) << outside;
    EXPECT_FALSE(holds(page, "a<b>.toml"));
    EXPECT_TRUE(holds(page, "a&lt;b&gt;.toml"));
    EXPECT_FALSE(holds(page, "<scene>"));
    EXPECT_FALSE(holds(page, "nan"));
    EXPECT_FALSE(holds(page, "inf\""));
}

TEST(HtmlReport, ClosesWhatItOpens) {
    const std::string page = htmlReport(smallReport());
    for (const std::string name :
         {"svg", "table", "tr", "td", "th", "figure", "div", "dl", "h2", "h3", "text", "span"}) {
        const auto count = [&](const std::string& part) {
            std::size_t found = 0;
            for (auto i = page.find(part); i != std::string::npos; i = page.find(part, i + 1)) ++found;
            return found;
        };
        EXPECT_EQ(count("<" + name + ">") + count("<" + name + " "), count("</" + name + ">")) << name;
    }
}

TEST(Reports, OfNothingAtAllAreStillReports) {
    EvaluationReport report{
        .program = "echotrail 0", .scenes = {{"S1", ""}}, .columns = {{"default", {}}}, .trials = 1};
    report.summaries = {{summarise("S1", "default", {})}};
    report.examples = {{TrialResult{}}};
    EXPECT_TRUE(holds(textReport(report), "0 of 1 trials"));
    EXPECT_TRUE(holds(htmlReport(report), "1 trial of each with every set of parameters, seeds from 0; 0 of 1 done"));
    EXPECT_EQ(nlohmann::json::parse(jsonReport(report))["trials_done"], 0);
}

TEST(Numbers, HaveFixedDecimalsAndNoNegativeZero) {
    EXPECT_EQ(fixedText(-0.001, 2), "0.00");
    EXPECT_EQ(fixedText(-0.5, 1), "-0.5");
    EXPECT_EQ(fixedText(12.345, 1), "12.3");
    EXPECT_EQ(fixedText(7, 0), "7");
}

TEST(SvgAxis, HasRoundMarks) {
    const SvgAxis axis(0, 18, 200, 0);
    const std::vector<double> expected{0, 5, 10, 15};
    EXPECT_EQ(axis.marks(), expected);
    EXPECT_EQ(axis.decimals(), 0);
    EXPECT_EQ(axis.at(9), 100.0);
    EXPECT_EQ(SvgAxis(0, 1, 0, 1).decimals(), 1);
    EXPECT_EQ(SvgAxis(3, 3, 0, 1).at(3), 0.0);
}

}  // namespace
}  // namespace echotrail
