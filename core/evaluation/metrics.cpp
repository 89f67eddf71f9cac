#include "core/evaluation/metrics.hpp"

#include <algorithm>
#include <cmath>

namespace echotrail {
namespace {

void addLooks(const std::vector<EvaluatedLook>& looks, TrialMetrics& metrics) {
    std::optional<Timestamp> last_correct;
    bool lost_since = false;
    for (const EvaluatedLook& look : looks) {
        ++metrics.opportunities;
        if (look.outcome != LookOutcome::Correct) {
            metrics.coasted += look.outcome == LookOutcome::Coasted;
            metrics.wrong += look.outcome == LookOutcome::Wrong;
            metrics.absent += look.outcome == LookOutcome::Absent;
            ++metrics.causes[static_cast<std::size_t>(look.cause)];
            metrics.lost.push_back(look);
            lost_since = true;
            continue;
        }
        ++metrics.correct;
        if (last_correct && lost_since) metrics.reacquired_after_s.push_back(secondsBetween(*last_correct, look.time));
        last_correct = look.time;
        lost_since = false;
    }
}

void addOutputs(const std::vector<EvaluatedOutput>& outputs, TrialMetrics& metrics) {
    for (const EvaluatedOutput& output : outputs) {
        const double deviation = output.error_m.norm();
        metrics.of_all.add(deviation);
        metrics.consistency_of_all.add(output.nees);
        if (!output.seen) {
            metrics.of_coasted.add(deviation);
        } else if (!output.correct) {
            metrics.of_wrong.add(deviation);
        } else {
            metrics.of_correct.add(deviation);
            metrics.velocity_of_correct.add(output.velocity_error_mps.norm());
            metrics.consistency_of_correct.add(output.nees);
        }
    }
}

void addSnapshots(const std::vector<SweepSnapshot>& snapshots, TrialMetrics& metrics) {
    ClearMot mot;
    for (const SweepSnapshot& snapshot : snapshots) {
        const ComparedSets sets = comparedSets(snapshot);
        const auto estimates = positionsOf(sets.tracks), truths = positionsOf(sets.targets);
        const Gospa parts = gospa(estimates, truths);
        metrics.ospa_sum_m += ospa(estimates, truths);
        metrics.gospa_sum.localisation_m2 += parts.localisation_m2;
        metrics.gospa_sum.missed_m2 += parts.missed_m2;
        metrics.gospa_sum.false_m2 += parts.false_m2;
        mot.addFrame(sets.tracks, sets.targets);
        ++metrics.sweeps;
    }
    metrics.mot = mot.counts();
}

/// What a trial adds to the pool, apart from what only an average makes sense of.
void pool(const TrialMetrics& trial, TrialMetrics& sum) {
    sum.range_scale_m = trial.range_scale_m;
    sum.data_s += trial.data_s;
    sum.pings += trial.pings;
    sum.opportunities += trial.opportunities;
    sum.correct += trial.correct;
    sum.coasted += trial.coasted;
    sum.wrong += trial.wrong;
    sum.absent += trial.absent;
    for (std::size_t i = 0; i < loss_causes; ++i) sum.causes[i] += trial.causes[i];
    sum.of_correct.add(trial.of_correct);
    sum.of_coasted.add(trial.of_coasted);
    sum.of_wrong.add(trial.of_wrong);
    sum.of_all.add(trial.of_all);
    sum.of_reports.add(trial.of_reports);
    sum.velocity_of_correct.add(trial.velocity_of_correct);
    sum.velocity_known = sum.velocity_known && trial.velocity_known;
    sum.consistency_of_correct.add(trial.consistency_of_correct);
    sum.consistency_of_all.add(trial.consistency_of_all);
    sum.sweeps += trial.sweeps;
    sum.ospa_sum_m += trial.ospa_sum_m;
    sum.gospa_sum.localisation_m2 += trial.gospa_sum.localisation_m2;
    sum.gospa_sum.missed_m2 += trial.gospa_sum.missed_m2;
    sum.gospa_sum.false_m2 += trial.gospa_sum.false_m2;
    sum.mot.add(trial.mot);
    sum.confirmed_tracks += trial.confirmed_tracks;
    sum.false_tracks += trial.false_tracks;
    sum.debris_tracks += trial.debris_tracks;
    sum.target_switches += trial.target_switches;
    sum.renewed_picks += trial.renewed_picks;
    sum.reacquired_after_s.insert(sum.reacquired_after_s.end(), trial.reacquired_after_s.begin(),
                                  trial.reacquired_after_s.end());
    sum.sweeps_outside_sector += trial.sweeps_outside_sector;
    sum.sweeps_unfinished += trial.sweeps_unfinished;
}

}  // namespace

void DeviationStatistics::add(double deviation_m) {
    ++count;
    greatest_m = std::max(greatest_m, deviation_m);
    sum_m += deviation_m;
    squares_m2 += deviation_m * deviation_m;
}

void DeviationStatistics::add(const DeviationStatistics& other) {
    count += other.count;
    greatest_m = std::max(greatest_m, other.greatest_m);
    sum_m += other.sum_m;
    squares_m2 += other.squares_m2;
}

double DeviationStatistics::mean_m() const { return count ? sum_m / static_cast<double>(count) : 0.0; }
double DeviationStatistics::rms_m() const { return count ? std::sqrt(squares_m2 / static_cast<double>(count)) : 0.0; }

void ConsistencyStatistics::add(double nees) {
    ++count;
    nees_sum += nees;
    inside += nees <= nees_of_ellipse;
}

void ConsistencyStatistics::add(const ConsistencyStatistics& other) {
    count += other.count;
    nees_sum += other.nees_sum;
    inside += other.inside;
}

double ConsistencyStatistics::nees() const { return count ? nees_sum / static_cast<double>(count) : 0.0; }
double ConsistencyStatistics::coverage() const {
    return count ? static_cast<double>(inside) / static_cast<double>(count) : 0.0;
}

double TrialMetrics::loss() const {
    return opportunities ? 1.0 - static_cast<double>(correct) / static_cast<double>(opportunities) : 0.0;
}

TrialMetrics measure(const TrialResult& trial) {
    TrialMetrics metrics{.seed = trial.seed,
                         .range_scale_m = trial.range_scale_m,
                         .data_s = trial.data_s,
                         .pings = trial.pings,
                         .velocity_known = trial.velocity_known};
    addLooks(trial.looks, metrics);
    addOutputs(trial.outputs, metrics);
    for (const double error_m : trial.report_errors_m) metrics.of_reports.add(error_m);
    addSnapshots(trial.snapshots, metrics);
    metrics.confirmed_tracks = trial.confirmed_tracks;
    metrics.false_tracks = trial.false_tracks;
    metrics.debris_tracks = trial.debris_tracks;
    metrics.target_switches = trial.target_switches;
    metrics.renewed_picks = trial.renewed_picks;
    metrics.confirmed_after_s = trial.confirmed_after_s;
    metrics.contrast_db = trial.mean_contrast_db;
    metrics.sweeps_outside_sector = trial.sweeps_outside_sector;
    metrics.sweeps_unfinished = trial.sweeps_unfinished;
    return metrics;
}

ScenarioSummary summarise(std::string scenario, std::string preset, std::vector<TrialMetrics> trials) {
    ScenarioSummary summary{.scenario = std::move(scenario), .preset = std::move(preset), .trials = std::move(trials)};
    std::stable_sort(summary.trials.begin(), summary.trials.end(),
                     [](const TrialMetrics& a, const TrialMetrics& b) { return a.seed < b.seed; });
    for (const TrialMetrics& trial : summary.trials) pool(trial, summary.pooled);
    const auto contrasts = summary.each([](const TrialMetrics& trial) {
        return trial.contrast_db > 0 ? std::optional(trial.contrast_db) : std::nullopt;
    });
    summary.pooled.contrast_db = meanEstimate(contrasts).mean;
    return summary;
}

}  // namespace echotrail
