#pragma once

#include "core/data/source.hpp"
#include "core/data/track.hpp"
#include "core/evaluation/truth.hpp"
#include "core/pipelines/scanning_sonar_pipeline.hpp"
#include "core/simulation/simulated_source.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace echotrail {

/// What came of one opportunity: one sweep whose scanned area held the true target (method card, section h).
enum class LookOutcome {
    Correct,  ///< a confirmed estimate from an echo of this sweep that truly is the target's
    Coasted,  ///< the target's track went on by prediction: there was no echo, or none was taken
    Wrong,    ///< the target's track took an echo that is not the target's
    Absent    ///< there was no confirmed track of the target: not yet, or lost
};
std::string_view toText(LookOutcome outcome);

/// Why an opportunity was not used correctly.
enum class LossCause {
    None,
    NotYetConfirmed,     ///< the track was taken up, but was not confirmed by then
    UnderThreshold,      ///< no region grew where the target was
    Merged,              ///< the target's echo was part of a clutter mass or of a region about something else
    OutscoredByClutter,  ///< the target's region was there, and another was taken, or none
    NavigationGap,       ///< poses were missing when the beam was there
    HeadRestarted        ///< pings were missing in the sweep
};
std::string_view toText(LossCause cause);

/// One opportunity and what the tracker made of it.
struct EvaluatedLook {
    Timestamp time{};  ///< when the beam was on the true target
    LookOutcome outcome = LookOutcome::Absent;
    LossCause cause = LossCause::None;
    double true_range_m = 0.0;   ///< from the head
    Bearing true_bearing;        ///< from the bow
    int track = 0;               ///< of the target at that time; 0: none
    double target_db = 0.0;      ///< contrast of the target's own region; 0: there was none
    NoEcho told = NoEcho::None;  ///< why the tracker itself says that it used no echo
};

/// One confirmed or coasting output of the designated track beside the truth at its time.
struct EvaluatedOutput {
    Timestamp time{};
    bool seen = false;
    bool correct = false;           ///< seen, and the echo was the target's
    Eigen::Vector2d error_m{0, 0};  ///< estimate − truth, north and east
    Eigen::Vector2d velocity_error_mps{0, 0};
    Eigen::Matrix2d covariance_m2 = Eigen::Matrix2d::Identity();
    double nees = 0.0;                 ///< error over covariance; 2 in the mean where it is honest
    Eigen::Vector2d estimate_m{0, 0};  ///< places in the local frame, for pictures
    Eigen::Vector2d truth_m{0, 0};
};

/// All confirmed tracks and all true targets at the end of a sweep: for OSPA, GOSPA and CLEAR MOT.
struct SweepSnapshot {
    struct Estimate {
        int track = 0;
        Eigen::Vector2d position_m{0, 0};
        bool on_debris = false;  ///< on a real object that is no target
    };
    struct Object {
        int target = 0;
        Eigen::Vector2d position_m{0, 0};
        bool visible = false;
    };
    Timestamp time{};
    std::vector<Estimate> estimates;  ///< confirmed and coasting
    std::vector<Object> objects;
};

struct TrialResult {
    std::string scenario;
    std::uint64_t seed = 0;
    double range_scale_m = 0.0;
    bool velocity_known = true;            ///< a truth as seen from the head holds no velocities
    std::vector<EvaluatedLook> looks;      ///< in time order
    std::vector<EvaluatedOutput> outputs;  ///< in time order
    /// Distances from the target's true place to where a report would have said that it is by then: at every ping while
    /// the designated track was confirmed or coasting.
    std::vector<double> report_errors_m;
    std::vector<SweepSnapshot> snapshots;
    int confirmed_tracks = 0;  ///< ever
    int false_tracks = 0;      ///< confirmed ones that never followed anything real
    int debris_tracks = 0;     ///< confirmed ones on a real object that is no target
    int target_switches = 0;   ///< the designated track went over to something else, and the operator pointed again
    int renewed_picks = 0;     ///< the operator had to point again
    std::optional<double> confirmed_after_s;  ///< from the first opportunity to the first correct confirmed look
    double data_s = 0.0;                      ///< span of the source's own time
    std::uint64_t pings = 0;
    double mean_contrast_db = 0.0;  ///< of the target's own regions: signal to clutter
    int sweeps_outside_sector = 0;  ///< no opportunities: the target was outside what was scanned
    int sweeps_unfinished = 0;      ///< no opportunities: the data ended before the beam came by
};

/// Runs the pipeline over a simulation whose head scans what the pipeline wants it to (`follow_target`), within the
/// scenario's own sector, with an operator who points at the target's true place at the start, and again
/// when there has been no track of it for 30 s, or the designated one has been further than 15 % of the range scale
/// away for 60 s. Stops early, with what there is, when `cancelled` says so (asked once per sweep).
TrialResult runTrial(SimulatedSource& source, const ScanningSonarPipeline::Params& params, std::uint64_t seed,
                     const std::function<bool()>& cancelled = {});

/// The same over a recording whose truth is known.
TrialResult runTrial(PingSource& source, const Truth& truth, const ScanningSonarPipeline::Params& params,
                     std::uint64_t seed, const std::function<bool()>& cancelled = {});

}  // namespace echotrail
