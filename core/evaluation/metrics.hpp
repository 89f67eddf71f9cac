#pragma once

#include "core/evaluation/set_metrics.hpp"
#include "core/evaluation/statistics.hpp"
#include "core/evaluation/trial.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace echotrail {

inline constexpr std::size_t loss_causes = static_cast<std::size_t>(LossCause::HeadRestarted) + 1;

/// Distances between estimate and truth, at the time of the region where there was one.
struct DeviationStatistics {
    std::size_t count = 0;
    double greatest_m = 0.0;
    double sum_m = 0.0;
    double squares_m2 = 0.0;

    void add(double deviation_m);
    void add(const DeviationStatistics& other);
    double mean_m() const;
    double rms_m() const;
};

/// How honest the covariances are.
struct ConsistencyStatistics {
    std::size_t count = 0;
    double nees_sum = 0.0;
    std::size_t inside = 0;  ///< the truth lay within the 95 % ellipse

    void add(double nees);
    void add(const ConsistencyStatistics& other);
    double nees() const;
    double coverage() const;  ///< share inside
};

/// The numbers of one trial: what is left of a TrialResult once its pictures are no longer needed.
struct TrialMetrics {
    std::uint64_t seed = 0;
    double range_scale_m = 0.0;
    double data_s = 0.0;
    std::uint64_t pings = 0;

    std::size_t opportunities = 0;
    std::size_t correct = 0, coasted = 0, wrong = 0, absent = 0;  ///< outcomes of the opportunities
    std::array<std::size_t, loss_causes> causes{};                ///< of those not used correctly, by LossCause
    std::vector<EvaluatedLook> lost;                              ///< those, one by one; not pooled

    DeviationStatistics of_correct, of_coasted, of_wrong, of_all;
    DeviationStatistics velocity_of_correct;  ///< in m/s
    bool velocity_known = true;               ///< a truth as seen from the head holds no velocities
    DeviationStatistics of_reports;           ///< at every ping, of the place as predicted for it
    ConsistencyStatistics consistency_of_correct, consistency_of_all;

    int sweeps = 0;  ///< with a snapshot
    double ospa_sum_m = 0.0;
    Gospa gospa_sum;  ///< squares, summed over sweeps
    ClearMot::Counts mot;

    int confirmed_tracks = 0, false_tracks = 0, debris_tracks = 0;
    int target_switches = 0, renewed_picks = 0;
    std::optional<double> confirmed_after_s;
    std::vector<double> reacquired_after_s;  ///< between correct looks that were not one after the other
    double contrast_db = 0.0;                ///< of the target's own regions; 0: there were none
    int sweeps_outside_sector = 0, sweeps_unfinished = 0;

    double loss() const;  ///< 1 − correct / opportunities; 0 without opportunities
};

TrialMetrics measure(const TrialResult& trial);

/// All trials of one scenario and one set of parameters.
struct ScenarioSummary {
    std::string scenario;
    std::string preset;
    std::vector<TrialMetrics> trials;     ///< in order of their seeds
    TrialMetrics pooled;                  ///< counts and sums over the trials; `seed` means nothing
    double processing_ms_per_ping = 0.0;  ///< of the pipeline alone; 0: not measured

    /// One number of each trial that has it.
    template <class Of>
    std::vector<double> each(const Of& of) const {
        std::vector<double> values;
        for (const TrialMetrics& trial : trials)
            if (const std::optional<double> value = of(trial)) values.push_back(*value);
        return values;
    }
};

ScenarioSummary summarise(std::string scenario, std::string preset, std::vector<TrialMetrics> trials);

}  // namespace echotrail
