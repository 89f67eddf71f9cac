#include "core/evaluation/trial.hpp"

#include "core/evaluation/trial_judge.hpp"
#include "core/simulation/scenario.hpp"

#include <cmath>

namespace echotrail {
namespace {

constexpr double no_track_s = 30.0;         // without a track of the target the operator waits this long
constexpr double wrong_track_s = 60.0;      // … and this long while the track is far from the target
constexpr double wrong_track_share = 0.15;  // of the range scale: "far", the published limit of acceptance
constexpr int followed_target = 0;

/// The operator of a trial: points at the target where it truly is, and again when the tracker has lost it for good.
class Operator {
public:
    Operator(const Truth& truth, double range_scale_m) : truth_(truth), far_m_(wrong_track_share * range_scale_m) {}

    void watch(const Update& update, ScanningSonarPipeline& pipeline, TrialResult& result) {
        const auto target = truth_.at(followed_target, update.time);
        if (!target || !target->visible) {
            near_ = update.time;  // nobody blames the tracker for what was not to be seen
            return;
        }
        if (!near_) return point(*target, update, pipeline);
        bool any = false, close = false;
        for (const Track& track : pipeline.tracks()) {
            if (!track.target || track.state == TrackState::Lost) continue;
            any = true;
            const double dt = secondsBetween(track.estimate.time, update.time);
            const Eigen::Vector2d place = track.estimate.mean.head<2>() + dt * track.estimate.mean.tail<2>();
            close |= (place - placeOf(*target, update.pose)).norm() <= far_m_;
        }
        if (any) with_track_ = update.time;
        if (close) near_ = update.time;
        const bool none = secondsBetween(with_track_, update.time) > no_track_s;
        const bool astray = secondsBetween(*near_, update.time) > wrong_track_s;
        if (!none && !astray) return;
        ++result.renewed_picks;
        if (any) ++result.target_switches;
        point(*target, update, pipeline);
    }

private:
    void point(const Truth::Sample& target, const Update& update, ScanningSonarPipeline& pipeline) {
        const auto [range, bearing] = sightOf(target, update.pose);
        pipeline.designate(range, bearing);
        near_ = with_track_ = update.time;
    }

    const Truth& truth_;
    double far_m_;
    std::optional<Timestamp> near_;  ///< when the track was last where it should be
    Timestamp with_track_{};
};

/// What a report would say now of where the designated track is, beside where it truly is.
void takeReport(const ScanningSonarPipeline& pipeline, const Truth& truth, const Update& update, TrialResult& result) {
    const auto told = pipeline.targetAt(update.time);
    if (!told || (told->state != TrackState::Confirmed && told->state != TrackState::Coasting)) return;
    if (const auto target = truth.at(followed_target, update.time))
        result.report_errors_m.push_back((told->expected.mean.head<2>() - placeOf(*target, update.pose)).norm());
}

using Command = std::function<void(const ScanSector&)>;

/// `command` tells the head what to scan; empty where nobody can.
TrialResult run(PingSource& source, const Truth& truth, const Scenario* scenario,
                const ScanningSonarPipeline::Params& params, std::uint64_t seed, const Command& command,
                const std::function<bool()>& cancelled) {
    TrialResult result{.scenario = source.info().name,
                       .seed = seed,
                       .range_scale_m = source.info().range_scale_m,
                       .velocity_known = truth.hasVelocities()};
    ScanningSonarPipeline pipeline(params, seed);
    pipeline.setFanPainting(false);
    TrialJudge judge(truth, scenario, seed, source.info());
    Operator person(truth, result.range_scale_m);
    const Timestamp start = source.info().start;
    source.rewind();
    while (const auto ping = source.next()) {
        const Update& update = pipeline.process(*ping, source.navigation());
        const bool first = result.pings++ == 0;
        judge.take(*ping, update);
        takeReport(pipeline, truth, update, result);
        if (command) command(pipeline.sector().value_or(scanSector(params.head)));
        if (first || update.sweep_ended) person.watch(update, pipeline, result);
        if (update.sweep_ended) {
            judge.endSweep(update, pipeline.tracks());
            if (cancelled && cancelled()) break;
        }
        result.data_s = secondsBetween(start, ping->time);
    }
    judge.takeLast(pipeline.finish());
    judge.conclude(result);
    result.confirmed_tracks = static_cast<int>(pipeline.confirmedTracks());
    return result;
}

}  // namespace

std::string_view toText(LookOutcome outcome) {
    switch (outcome) {
        case LookOutcome::Correct:
            return "correct";
        case LookOutcome::Coasted:
            return "coasted";
        case LookOutcome::Wrong:
            return "wrong";
        case LookOutcome::Absent:
            return "absent";
    }
    return "";
}

std::string_view toText(LossCause cause) {
    switch (cause) {
        case LossCause::None:
            return "none";
        case LossCause::NotYetConfirmed:
            return "not yet confirmed";
        case LossCause::UnderThreshold:
            return "under the threshold";
        case LossCause::Merged:
            return "merged with clutter";
        case LossCause::OutscoredByClutter:
            return "out-scored by clutter";
        case LossCause::NavigationGap:
            return "navigation gap";
        case LossCause::HeadRestarted:
            return "pings missing";
    }
    return "";
}

TrialResult runTrial(SimulatedSource& source, const ScanningSonarPipeline::Params& params, std::uint64_t seed,
                     const std::function<bool()>& cancelled) {
    const Truth truth(source.truth());
    ScanningSonarPipeline::Params limited = params;
    limited.head = withSector(params.head, scanSector(source.scenario()));
    const Command command = [&source](const ScanSector& sector) { source.command(sector); };
    return run(source, truth, &source.scenario(), limited, seed,
               params.follow.follow_target ? command : Command(), cancelled);
}

TrialResult runTrial(PingSource& source, const Truth& truth, const ScanningSonarPipeline::Params& params,
                     std::uint64_t seed, const std::function<bool()>& cancelled) {
    return run(source, truth, nullptr, params, seed, {}, cancelled);
}

}  // namespace echotrail
