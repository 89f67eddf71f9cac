#include "core/simulation/commanded_scan.hpp"

#include "core/simulation/ping_model.hpp"

#include <algorithm>
#include <cmath>

namespace echotrail {
namespace {

constexpr double unit_deg = 360.0 / ScanMotion::turn_units;
constexpr double motor_s_per_unit = 250e-6;  // the motor time that heads are usually told: 25 · 10 µs

int unitsOf(double degrees) {
    const int units = static_cast<int>(std::lround(degrees / unit_deg)) % ScanMotion::turn_units;
    return units < 0 ? units + ScanMotion::turn_units : units;
}

}  // namespace

ScanSector scanSector(const Scenario& scenario) { return {0.0, 2.0 * scenario.sector_half_width_deg}; }

CommandedScan::CommandedScan(const Scenario& scenario)
    : interval_s_(pingInterval(scenario)),
      step_(static_cast<int>(std::clamp(std::lround(scenario.step_deg / unit_deg), 1L, 255L))),
      sector_(scanSector(scenario)),
      commanded_(sector_) {
    // The scenario's scan begins at the left limit.
    const ScanMotion::Limits limits = limitsOf(sector_, step_);
    motion_.setLimits({.left = limits.left, .right = limits.left, .step = step_});
    motion_.enter();
    motion_.setLimits(limits);
    motion_.enter();
}

CommandedScan::Look CommandedScan::next() {
    // This one was under way when the last command came: what it looks at had been settled by then.
    const Look look{number_, Bearing::degrees((motion_.position() - ScanMotion::ahead_units) * unit_deg),
                    motion_.clockwise()};
    int way = 0;
    if (!(commanded_ == sector_)) {
        sector_ = commanded_;
        motion_.setLimits(limitsOf(sector_, step_));
        way = motion_.enter();
    } else {
        way = motion_.step();
    }
    const double longer_s = std::max(way - step_, 0) * motor_s_per_unit;
    number_ += 1 + static_cast<std::uint64_t>(std::ceil(longer_s / interval_s_));
    return look;
}

ScanMotion::Limits CommandedScan::limitsOf(const ScanSector& sector, int step) {
    const double ahead_deg = ScanMotion::ahead_units * unit_deg;
    return {.left = unitsOf(ahead_deg + sector.centre_deg - sector.width_deg / 2.0),
            .right = unitsOf(ahead_deg + sector.centre_deg + sector.width_deg / 2.0),
            .step = step,
            .continuous = sector.fullCircle()};
}

}  // namespace echotrail
