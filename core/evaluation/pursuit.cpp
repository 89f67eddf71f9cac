#include "core/evaluation/pursuit.hpp"

#include "core/pipelines/target_watch.hpp"
#include "core/simulation/commanded_scan.hpp"
#include "core/simulation/echo_model.hpp"
#include "core/simulation/ping_model.hpp"
#include "core/simulation/simulated_navigation.hpp"
#include "core/tracking/track_text.hpp"

#include <cmath>

namespace echotrail {
namespace {

constexpr double point_again_s = 30.0;

Timestamp at(double time_s) { return simulation_start + microsecondsFromSeconds(time_s); }

/// The vehicle with its navigation, moved on together.
class Vessel {
public:
    Vessel(const PursuitParams& params, const Scenario& given, std::uint64_t seed)
        : vehicle(params, given), scenario(withVehicle(given, vehicle)), told_(scenario, seed) {}

    /// Poses are told until a little later than `time_s`.
    void moveTo(double time_s) {
        constexpr double beyond_s = 0.05;
        vehicle.moveTo(time_s + beyond_s);
        while (told_s_ <= time_s + beyond_s) {
            const NavigationSample sample = told_.next();
            told_s_ = sample.time_s;
            navigation.add({at(sample.time_s), sample.pose});
        }
    }

    PursuingVehicle vehicle;
    const Scenario scenario;  ///< with this vehicle in it
    PoseHistory navigation;

private:
    static Scenario withVehicle(Scenario given, const PursuingVehicle& pursuer) {
        given.vehicle.steered = pursuer.path();
        return given;
    }
    SimulatedNavigation told_;
    double told_s_ = -1.0;
};

/// Points at the first target where it truly is, when nobody has followed it for a while.
class Pointing {
public:
    void watch(const Scenario& scenario, double time_s, ScanningSonarPipeline& pipeline, PursuitResult& result) {
        const auto target = pipeline.targetAt(at(time_s));
        if (target && target->state != TrackState::Lost) followed_s_ = time_s;
        if (result.picks > 0 && time_s - followed_s_ < point_again_s) return;
        const Pose vehicle = vehiclePose(scenario, time_s);
        const Eigen::Vector2d way = targetMotion(scenario.targets.front(), time_s).position_m -
                                    Eigen::Vector2d(vehicle.north_m, vehicle.east_m);
        pipeline.designate(way.norm(), Bearing::radians(std::atan2(way.y(), way.x()) - vehicle.heading.inRadians()));
        ++result.picks;
        followed_s_ = time_s;
    }

private:
    double followed_s_ = 0.0;
};

/// What the tracker says now goes to the vehicle as text, as it would on a wire.
void report(TargetWatch& watch, double time_s, PursuingVehicle& vehicle, PursuitResult& result) {
    for (const TargetReport& report : watch.reports(at(time_s))) {
        const auto read = readSteeringReport(reportLine(report, simulation_start).dump());
        ++result.reports;
        if (read) vehicle.hear(*read, time_s);
        result.looks += report.look.seen;
    }
}

}  // namespace

PursuitResult runPursuit(const Scenario& scenario, const ScanningSonarPipeline::Params& params,
                         const PursuitParams& pursuit, std::uint64_t seed, const std::function<bool()>& cancelled) {
    PursuitResult result{.record = PursuitRecord(pursuit.keep_range_m)};
    ScanningSonarPipeline::Params limited = params;
    limited.head = withSector(params.head, scanSector(scenario));
    ScanningSonarPipeline pipeline(limited, seed);
    pipeline.setFanPainting(false);
    Vessel vessel(pursuit, scenario, seed);
    EchoModel echoes(vessel.scenario, seed);
    CommandedScan scan(scenario);
    TargetWatch watch;
    Pointing person;
    for (double time_s = 0.0; time_s <= scenario.duration_s;) {
        const CommandedScan::Look look = scan.next();
        HeadSetup head = headSetup(vessel.scenario, look.number);
        head.bearing = look.bearing;
        vessel.moveTo(time_s);
        Ping ping = simulatePing(vessel.scenario, echoes, look.number, head, look.clockwise);
        ping.sequence = result.pings++;

        // Its last echo is back when the next one goes out; until then the vehicle knows nothing of it.
        const double next_s = pingTime(scenario, scan.upcoming());
        vessel.moveTo(next_s);
        const Update& update = pipeline.process(ping, vessel.navigation);
        if (result.pings == 1 || update.sweep_ended) {
            person.watch(vessel.scenario, time_s, pipeline, result);
            if (cancelled && cancelled()) break;
        }
        watch.take(update, pipeline);
        report(watch, next_s, vessel.vehicle, result);
        scan.command(pipeline.sector().value_or(scanSector(scenario)));
        result.record.take(vessel.scenario, time_s, vessel.vehicle.validReports() > 0);
        time_s = next_s;
    }
    result.valid = vessel.vehicle.validReports();
    return result;
}

}  // namespace echotrail
