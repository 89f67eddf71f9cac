#include "core/evaluation/metric_table.hpp"

#include <gtest/gtest.h>

#include <set>

namespace echotrail {
namespace {

/// `correct` of `opportunities`, with deviations of correct looks.
TrialMetrics trial(std::uint64_t seed, std::size_t opportunities, std::size_t correct,
                   const std::vector<double>& deviations) {
    TrialMetrics metrics{.seed = seed, .range_scale_m = 50, .data_s = 1800};
    metrics.opportunities = opportunities;
    metrics.correct = correct;
    for (const double deviation : deviations) metrics.of_correct.add(deviation);
    return metrics;
}

ScenarioSummary summary() {
    return summarise("S1", "default", {trial(1, 100, 90, {1, 3}), trial(2, 300, 270, {2, 2}), trial(3, 100, 100, {9})});
}

double valueOf(std::string_view name) { return findMetric(name)->of(summary())->value; }

TEST(MetricTable, NamesAreUniqueAndEveryMetricExplainsItself) {
    std::set<std::string_view> names;
    for (const Metric& metric : metricTable()) {
        EXPECT_TRUE(names.insert(metric.name).second) << metric.name;
        EXPECT_FALSE(metric.title.empty() || metric.unit.empty() || metric.meaning.empty()) << metric.name;
        ASSERT_NE(metric.of, nullptr) << metric.name;
    }
}

TEST(MetricTable, AnEmptySummaryHasNoNumbersAndBreaksNothing) {
    const ScenarioSummary empty = summarise("S1", "default", {});
    for (const Metric& metric : metricTable()) EXPECT_FALSE(metric.of(empty)) << metric.name;
}

TEST(MetricTable, LossIsPooledOverLooksAndAveragedOverTrials) {
    EXPECT_NEAR(valueOf("loss_percent"), 8.0, 1e-12);            // 40 of 500
    EXPECT_NEAR(valueOf("loss_mean_percent"), 20.0 / 3, 1e-12);  // 10, 10, 0
    const MetricValue pooled = *findMetric("loss_percent")->of(summary());
    EXPECT_NEAR(pooled.interval->low, 100 * wilsonInterval(40, 500).low, 1e-12);
}

TEST(MetricTable, TheGreatestDeviationIsTheMedianOverTrialsWithTheWorstBesideIt) {
    const MetricValue greatest = *findMetric("deviation_max_m")->of(summary());
    EXPECT_NEAR(greatest.value, 3.0, 1e-12);  // 3, 2, 9
    EXPECT_NEAR(*greatest.worst, 9.0, 1e-12);
    EXPECT_NEAR(valueOf("deviation_max_percent"), 6.0, 1e-12);
    EXPECT_NEAR(valueOf("deviation_mean_m"), (2.0 + 2 + 9) / 3, 1e-12);
}

TEST(Published, TrialsAddUpToThePooledLossOfThePaper) {
    std::size_t looks = 0, wrong = 0;
    for (const PublishedTrial& published : publishedTrials()) {
        looks += published.looks;
        wrong += published.looks - published.correct;
        const double loss =
            100.0 * static_cast<double>(published.looks - published.correct) / static_cast<double>(published.looks);
        EXPECT_NEAR(loss, published.loss_percent, 0.06) << published.scenario;
    }
    EXPECT_EQ(looks, 2033U);
    EXPECT_EQ(wrong, 177U);
    EXPECT_EQ(publishedTrial("demonstration"), nullptr);
}

TEST(Requirement, IsReadWithColumnAndScene) {
    const auto plain = parseRequirement("loss_percent=20");
    ASSERT_TRUE(plain) << plain.error();
    EXPECT_EQ(plain->metric->name, "loss_percent");
    EXPECT_EQ(plain->limit, 20.0);
    EXPECT_EQ(plain->scene + plain->column, "");
    const auto whole = parseRequirement("my=paper.toml:S2/deviation_max_m=7.5");
    ASSERT_TRUE(whole) << whole.error();
    EXPECT_EQ(whole->column, "my=paper.toml");
    EXPECT_EQ(whole->scene, "S2");
    EXPECT_EQ(parseRequirement("kalman:nees=3")->column, "kalman");
}

TEST(Requirement, TellsWhatItDoesNotUnderstand) {
    EXPECT_FALSE(parseRequirement("loss_percent"));
    EXPECT_FALSE(parseRequirement("loss_percent="));
    EXPECT_FALSE(parseRequirement("loss_percent=few"));
    EXPECT_FALSE(parseRequirement("loss_percent=nan"));
    EXPECT_NE(parseRequirement("loss=2").error().find("loss_percent"), std::string::npos);
}

TEST(Requirement, LowerIsBetterForLossesAndHigherForCoverage) {
    ScenarioSummary judged = summary();
    for (int i = 0; i < 10; ++i) judged.pooled.consistency_of_correct.add(i < 9 ? 1.0 : 8.0);
    EXPECT_TRUE(meets(*parseRequirement("loss_percent=8"), judged));
    EXPECT_FALSE(meets(*parseRequirement("loss_percent=7.9"), judged));
    EXPECT_TRUE(meets(*parseRequirement("coverage_percent=90"), judged));
    EXPECT_FALSE(meets(*parseRequirement("coverage_percent=91"), judged));
    EXPECT_FALSE(meets(*parseRequirement("confirm_s=1000"), judged)) << "what was not measured meets nothing";
}

}  // namespace
}  // namespace echotrail
