#include "core/simulation/simulated_source.hpp"

#include "core/simulation/objects.hpp"
#include "core/simulation/ping_model.hpp"
#include "core/simulation/simulated_navigation.hpp"

#include <cmath>
#include <string>

namespace echotrail {

namespace {

SourceInfo describe(const Scenario& scenario) {
    const auto pings = static_cast<std::uint64_t>(scenario.duration_s / pingInterval(scenario)) + 1;
    const Ping last = simulatePing(scenario, 0, pings - 1);
    return {.name = scenario.name,
            .format = "simulation",
            .head = "simulated SeaKing DFS, " + std::to_string(std::lround(scenario.frequency_khz)) + " kHz",
            .start = simulation_start,
            .end = last.time,
            .pings = pings,
            .range_scale_m = scenario.range_m,
            .sound_speed_mps = last.sound_speed_mps,
            .notes = {scenario.description}};
}

TruthSample sampleTruth(const Scenario& scenario, std::uint64_t ping, std::size_t target) {
    const double time_s = pingTime(scenario, ping);
    const Pose vehicle = vehiclePose(scenario, time_s);
    const SimulatedTarget& seen = scenario.targets[target];
    const TargetMotion motion = targetMotion(seen, time_s);
    const Eigen::Vector2d way = motion.position_m - Eigen::Vector2d(vehicle.north_m, vehicle.east_m);
    const double from_bow = wrapRadians(std::atan2(way.y(), way.x()) - vehicle.heading.inRadians());
    const double range_m = std::hypot(way.norm(), seen.below_head_m);
    return {.time = simulation_start + microsecondsFromSeconds(time_s),
            .target = static_cast<int>(target),
            .north_m = motion.position_m.x(),
            .east_m = motion.position_m.y(),
            .velocity_north_mps = motion.velocity_mps.x(),
            .velocity_east_mps = motion.velocity_mps.y(),
            .range_m = range_m,
            .from_bow = Bearing::radians(from_bow),
            .in_beam = beamIsOn(scenario, seen, headSetup(scenario, ping), time_s),
            .visible = std::abs(from_bow) <= radiansFromDegrees(scenario.sector_half_width_deg) &&
                       range_m <= scenario.range_m};
}

}  // namespace

SimulatedSource::SimulatedSource(Scenario scenario, std::uint64_t seed)
    : scenario_(std::move(scenario)), seed_(seed), info_(describe(scenario_)), model_(scenario_, seed) {
    const double last_echo_s = secondsBetween(info_.start, info_.end) + pingInterval(scenario_);
    const double interval_s = std::chrono::duration<double>(SimulatedNavigation::interval).count();
    SimulatedNavigation told(scenario_, seed_);
    for (NavigationSample sample = told.next(); sample.time_s < last_echo_s + interval_s; sample = told.next())
        navigation_.add({info_.start + microsecondsFromSeconds(sample.time_s), sample.pose});
}

void SimulatedSource::rewind() {
    next_ = 0;
    scan_.reset();
}

void SimulatedSource::command(const ScanSector& sector) {
    if (!scan_) {  // it has scanned on by itself so far
        scan_.emplace(scenario_);
        for (std::uint64_t ping = 0; ping < next_; ++ping) scan_->next();
        given_ = next_;
    }
    scan_->command(sector);
}

std::optional<Ping> SimulatedSource::nextCommanded() {
    const CommandedScan::Look look = scan_->next();
    if (look.number >= info_.pings) return std::nullopt;
    HeadSetup head = headSetup(scenario_, look.number);
    head.bearing = look.bearing;
    Ping ping = simulatePing(scenario_, model_, look.number, head, look.clockwise);
    ping.sequence = given_++;
    return ping;
}

std::optional<Ping> SimulatedSource::next() {
    if (scan_) return nextCommanded();
    if (next_ == info_.pings) return std::nullopt;
    if (!keep_) return simulatePing(scenario_, model_, next_++);
    while (kept_.size() <= next_) kept_.push_back(simulatePing(scenario_, model_, kept_.size()));
    return kept_[next_++];
}

std::vector<TruthSample> SimulatedSource::truth() const {
    std::vector<TruthSample> samples;
    samples.reserve(info_.pings * scenario_.targets.size());
    for (std::uint64_t ping = 0; ping < info_.pings; ++ping)
        for (std::size_t target = 0; target < scenario_.targets.size(); ++target)
            samples.push_back(sampleTruth(scenario_, ping, target));
    return samples;
}

Result<Scenario> findScenario(std::string_view name) {
    if (name == "demo") name = "demonstration";
    std::string known;
    for (const Scenario& scenario : scenarios()) {
        if (scenario.name == name) return scenario;
        known += (known.empty() ? "" : ", ") + scenario.name;
    }
    return Error{"there is no simulation named '" + std::string(name) + "'; there are: " + known};
}

Result<std::unique_ptr<SimulatedSource>> openSimulation(std::string_view name, std::uint64_t seed) {
    auto scenario = findScenario(name);
    if (!scenario) return Error{scenario.error()};
    return std::make_unique<SimulatedSource>(*std::move(scenario), seed);
}

}  // namespace echotrail
