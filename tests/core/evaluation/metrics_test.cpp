#include "core/evaluation/metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace echotrail {
namespace {

Timestamp at(double seconds) { return Timestamp(microsecondsFromSeconds(1000 + seconds)); }

EvaluatedLook look(double seconds, LookOutcome outcome, LossCause cause = LossCause::None) {
    return {.time = at(seconds), .outcome = outcome, .cause = cause};
}

EvaluatedOutput output(bool seen, bool correct, Eigen::Vector2d error, double nees = 2) {
    return {.seen = seen, .correct = correct, .error_m = error, .velocity_error_mps = {0.3, 0.4}, .nees = nees};
}

/// Ten opportunities, six of them used; outputs of every kind.
TrialResult smallTrial() {
    TrialResult trial{.scenario = "hand-made", .seed = 4, .range_scale_m = 50, .data_s = 1800, .pings = 900};
    using enum LookOutcome;
    trial.looks = {look(0, Absent, LossCause::NotYetConfirmed),
                   look(5, Correct),
                   look(10, Correct),
                   look(15, Coasted, LossCause::UnderThreshold),
                   look(20, Wrong, LossCause::OutscoredByClutter),
                   look(25, Correct),
                   look(30, Coasted, LossCause::UnderThreshold),
                   look(35, Correct),
                   look(40, Correct),
                   look(45, Correct)};
    trial.outputs = {output(true, true, {3, 4}, 1), output(true, true, {0, 1}, 5), output(false, false, {0, 2}, 9),
                     output(true, false, {8, 6}, 40), output(true, true, {0, -3}, 6)};
    trial.false_tracks = 1;
    trial.confirmed_after_s = 5.0;
    trial.mean_contrast_db = 14;
    return trial;
}

TEST(Measure, LossIsWhatWasNotCorrectOfTheOpportunities) {
    const TrialMetrics metrics = measure(smallTrial());
    EXPECT_EQ(metrics.opportunities, 10U);
    EXPECT_EQ(metrics.correct, 6U);
    EXPECT_EQ(metrics.coasted, 2U);
    EXPECT_EQ(metrics.wrong, 1U);
    EXPECT_EQ(metrics.absent, 1U);
    EXPECT_NEAR(metrics.loss(), 0.4, 1e-12);
    EXPECT_EQ(TrialMetrics{}.loss(), 0.0);
}

TEST(Measure, EachLossHasItsCause) {
    const TrialMetrics metrics = measure(smallTrial());
    EXPECT_EQ(metrics.causes[static_cast<std::size_t>(LossCause::UnderThreshold)], 2U);
    EXPECT_EQ(metrics.causes[static_cast<std::size_t>(LossCause::OutscoredByClutter)], 1U);
    EXPECT_EQ(metrics.causes[static_cast<std::size_t>(LossCause::NotYetConfirmed)], 1U);
    EXPECT_EQ(metrics.causes[static_cast<std::size_t>(LossCause::None)], 0U);
    ASSERT_EQ(metrics.lost.size(), 4U);
    EXPECT_EQ(metrics.lost[2].time, at(20));
    EXPECT_EQ(metrics.lost[2].cause, LossCause::OutscoredByClutter);
}

TEST(Measure, DeviationsOfCorrectCoastedAndWrongOutputsAreKeptApart) {
    const TrialMetrics metrics = measure(smallTrial());
    EXPECT_EQ(metrics.of_correct.count, 3U);
    EXPECT_NEAR(metrics.of_correct.mean_m(), 3.0, 1e-12);  // 5, 1, 3
    EXPECT_NEAR(metrics.of_correct.greatest_m, 5.0, 1e-12);
    EXPECT_NEAR(metrics.of_correct.rms_m(), std::sqrt(35.0 / 3), 1e-12);
    EXPECT_NEAR(metrics.of_coasted.mean_m(), 2.0, 1e-12);
    EXPECT_NEAR(metrics.of_wrong.greatest_m, 10.0, 1e-12);
    EXPECT_EQ(metrics.of_all.count, 5U);
    EXPECT_NEAR(metrics.of_all.mean_m(), 4.2, 1e-12);
    EXPECT_NEAR(metrics.velocity_of_correct.rms_m(), 0.5, 1e-12);
}

TEST(Measure, NeesAndCoverageByHand) {
    const TrialMetrics metrics = measure(smallTrial());
    EXPECT_NEAR(metrics.consistency_of_correct.nees(), 4.0, 1e-12);          // 1, 5, 6
    EXPECT_NEAR(metrics.consistency_of_correct.coverage(), 2.0 / 3, 1e-12);  // 6 is outside of 5.99
    EXPECT_NEAR(metrics.consistency_of_all.coverage(), 2.0 / 5, 1e-12);
}

TEST(Measure, ReacquisitionIsTimedFromTheLastCorrectLookToTheNext) {
    const std::vector<double> expected{15.0, 10.0};  // from 10 to 25 s, from 25 to 35 s
    EXPECT_EQ(measure(smallTrial()).reacquired_after_s, expected);
}

TEST(Measure, SnapshotsGiveDistancesBetweenSets) {
    TrialResult trial;
    SweepSnapshot snapshot;
    snapshot.objects = {{.target = 0, .position_m = {0, 0}, .visible = true}};
    trial.snapshots.push_back(snapshot);  // missed
    snapshot.estimates = {{.track = 1, .position_m = {3, 0}}};
    trial.snapshots.push_back(snapshot);  // 3 m off
    const TrialMetrics metrics = measure(trial);
    EXPECT_EQ(metrics.sweeps, 2);
    EXPECT_NEAR(metrics.ospa_sum_m, 7.5 + 3, 1e-12);
    EXPECT_NEAR(metrics.gospa_sum.missed_m2, 28.125, 1e-12);
    EXPECT_NEAR(metrics.gospa_sum.localisation_m2, 9, 1e-12);
    EXPECT_NEAR(metrics.mot.mota(), 0.5, 1e-12);
}

TEST(Summarise, PoolsTrialsInTheOrderOfTheirSeeds) {
    TrialResult first = smallTrial(), second = smallTrial();
    first.seed = 2;
    second.seed = 1;
    second.looks.resize(5);       // two of five
    second.mean_contrast_db = 0;  // never seen: says nothing about contrast
    const ScenarioSummary summary = summarise("S1", "default", {measure(first), measure(second)});
    ASSERT_EQ(summary.trials.size(), 2U);
    EXPECT_EQ(summary.trials[0].seed, 1U);
    EXPECT_EQ(summary.pooled.opportunities, 15U);
    EXPECT_EQ(summary.pooled.correct, 8U);
    EXPECT_EQ(summary.pooled.of_correct.count, 6U);
    EXPECT_EQ(summary.pooled.pings, 1800U);
    EXPECT_NEAR(summary.pooled.contrast_db, 14, 1e-12);
    const std::vector<double> losses =
        summary.each([](const TrialMetrics& trial) { return std::optional(trial.loss()); });
    ASSERT_EQ(losses.size(), 2U);
    EXPECT_NEAR(losses[0], 0.6, 1e-12);
    EXPECT_NEAR(losses[1], 0.4, 1e-12);
}

}  // namespace
}  // namespace echotrail
