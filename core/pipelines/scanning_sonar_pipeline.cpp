#include "core/pipelines/scanning_sonar_pipeline.hpp"

#include <algorithm>
#include <cmath>

namespace echotrail {
namespace {

constexpr double high_frequency_hz = 500e3;  // between the two channels of a SeaKing, 325 and 675 kHz
constexpr double pick_radius_m = 3.0, pick_radius_share = 0.1;
constexpr Microseconds next_look{1'000'000};  // about what a narrow sector takes to be scanned

double pickRadius(double range_m) { return std::max(pick_radius_m, pick_radius_share * range_m); }

}  // namespace

ScanningSonarPipeline::ScanningSonarPipeline(const Params& params, std::uint64_t seed)
    : params_(params),
      fan_(params.fan),
      regions_(params.regions, params.enhancement),
      tracker_(params.tracker, seed),
      follower_(params.follow) {}

const Update& ScanningSonarPipeline::process(const Ping& ping, const PoseHistory& navigation) {
    update_ = Update{.ping = ping.sequence, .time = ping.time, .sweep = sweeps_};
    if (ping.motor_lost_sync) {  // nobody knows where the beam looked
        ++unsynchronised_;
        return update_;
    }
    if (!first_ping_) first_ping_ = ping.time;

    // Where was the beam? The pose at transmission, and at half way back from the far end.
    const double flight_s = ping.bin_interval_s * static_cast<double>(ping.levels.size());
    const double gap_s = params_.navigation.longest_navigation_gap_s;
    const auto at_transmit = navigation.at(ping.time, gap_s);
    const auto at_far_end = navigation.at(ping.time + microsecondsFromSeconds(flight_s / 2.0), gap_s);
    update_.navigation_gap = !at_transmit || !at_far_end;
    if (at_transmit) vehicle_ = fromStart(*at_transmit);
    update_.later_pose = at_far_end ? fromStart(*at_far_end) : vehicle_;
    SweepFollower::Step step = sweep_.follow(ping.bearing, ping.step_rad, ping.time);
    if (params_.tracker.method.motion_correction)
        held_.reset();
    else
        holdPose(step);
    const Ray ray = makeRay(ping, vehicle_, update_.later_pose, params_.head, *first_ping_);
    step.turned_round |= update_.navigation_gap;
    beam_ = beamOf(ping, ray, step, !navigation.empty());

    // What has it just left? Regions grow there, and nowhere else.
    if (step.turned_round || (step.sweep_ended && regions_.waitsForSweep())) regions_.breakOff(update_.regions);
    tracker_.interestsAt(beam_, interests_);
    regions_.add(ping, ray, beam_.head, *first_ping_, interests_, update_.regions);
    if (paint_fan_) fan_.add(ray, ping.range_scale_m, step.turned_round);

    // Which tracks did it pass, and do the regions there belong to them?
    tracker_.update(
        beam_, update_.regions, [this](double near_m, double far_m) { return regions_.isOpenWithin(near_m, far_m); },
        update_.looks);
    applyPick();

    // Where will it be next? There the head may look next.
    follower_.choose(tracker_.targetAt(ping.time + next_look), beam_, params_.head);

    sweeps_ += step.sweep_ended;
    update_.sweep = sweeps_;
    update_.sweep_ended = step.sweep_ended;
    update_.broke_off = step.turned_round;
    update_.pose = vehicle_;
    update_.beam = beam_.azimuth + -vehicle_.heading.inRadians();
    return update_;
}

/// The local frame begins where the vehicle was at the first ping, wherever navigation counts from.
Pose ScanningSonarPipeline::fromStart(const Pose& pose) {
    if (!origin_) origin_ = pose;
    return {pose.north_m - origin_->north_m, pose.east_m - origin_->east_m, pose.heading};
}

/// As if the vehicle stood still during a sweep.
void ScanningSonarPipeline::holdPose(const SweepFollower::Step& step) {
    if (!held_ || step.turned_round || step.sweep_ended) held_ = vehicle_;
    vehicle_ = update_.later_pose = *held_;
}

const Update& ScanningSonarPipeline::finish() {
    update_.sweep_ended = false;
    update_.regions.clear();
    update_.looks.clear();
    regions_.breakOff(update_.regions);
    tracker_.finish(update_.regions, update_.looks);
    return update_;
}

BeamMoment ScanningSonarPipeline::beamOf(const Ping& ping, const Ray& ray, const SweepFollower::Step& step,
                                         bool navigation_known) const {
    const LikenessParams& likeness = params_.tracker.likeness;
    const bool high = ping.frequency_hz >= high_frequency_hz;
    const Eigen::Vector2d origin = ray.at(0.0);
    std::optional<WatchedSector> watched;
    if (const auto& sector = follower_.chosen())
        watched = WatchedSector{Bearing::degrees(sector->centre_deg) + vehicle_.heading.inRadians(),
                                radiansFromDegrees(sector->width_deg / 2.0),
                                radiansFromDegrees(params_.head.sector_width_deg)};
    return {.time = ping.time,
            .head = {origin.x(), origin.y(), vehicle_.heading},
            .azimuth = Bearing::radians(ray.azimuth_rad),
            .step_rad = ping.step_rad,
            .beam_width_rad = radiansFromDegrees(high ? likeness.high_beam_width_deg : likeness.low_beam_width_deg),
            .far_m = ping.binSize() * static_cast<double>(ping.levels.size()),
            .range_scale_m = ping.range_scale_m,
            .point_length_m = ping.range_scale_m * likeness.point_echo_length_percent / 100.0,
            .faintest_db = params_.regions.screen.seed_excess_db - params_.regions.screen.interest_lowering_db,
            .turned_round = step.turned_round,
            .sweep_ended = step.sweep_ended,
            .navigation_known = navigation_known,
            .navigation_gap = update_.navigation_gap,
            .pings_missing = step.pings_missing,
            .watched = watched};
}

void ScanningSonarPipeline::setParams(const Params& params) {
    params_ = params;
    fan_.setParams(params.fan);
    regions_.setParams(params.regions, params.enhancement);
    tracker_.setParams(params.tracker);
    follower_.setParams(params.follow);
}

void ScanningSonarPipeline::designate(double range_m, Bearing from_bow) {
    pick_ = Pick{range_m, from_bow};
    if (first_ping_) applyPick();
}

/// The pick is relative to the head as it is now; from here on it is a place in the local frame.
void ScanningSonarPipeline::applyPick() {
    if (!pick_) return;
    tracker_.designate(placeOf(pick_->range_m, pick_->from_bow), pickRadius(pick_->range_m));
    pick_.reset();
}

Eigen::Vector2d ScanningSonarPipeline::placeOf(double range_m, Bearing from_bow) const {
    const double azimuth = from_bow.inRadians() + vehicle_.heading.inRadians();
    return {beam_.head.north_m + range_m * std::cos(azimuth), beam_.head.east_m + range_m * std::sin(azimuth)};
}

void ScanningSonarPipeline::drop(int track, double range_m, Bearing from_bow) {
    tracker_.drop(track, placeOf(range_m, from_bow), pickRadius(range_m));
}

void ScanningSonarPipeline::command(const RunControl& control) {
    switch (control.kind) {
        case RunControl::Kind::Parameters:
            break;
        case RunControl::Kind::Designation:
            return designate(control.range_m, control.from_bow);
        case RunControl::Kind::ClearDesignation:
            return clearDesignation();
        case RunControl::Kind::Drop:
            return drop(control.track, control.range_m, control.from_bow);
        case RunControl::Kind::Restore:
            return restore(control.track);
    }
}

BeamLine ScanningSonarPipeline::lastLine() const {
    BeamLine line = regions_.lastLine();
    line.from_bow = update_.beam;
    line.from_north = beam_.azimuth;
    return line;
}

Timestamp ScanningSonarPipeline::settledUntil() const {
    return tracker_.settledUntil(regions_.settledUntil().value_or(beam_.time));
}

void ScanningSonarPipeline::clearDesignation() {
    pick_.reset();
    tracker_.clearDesignation();
}

}  // namespace echotrail
