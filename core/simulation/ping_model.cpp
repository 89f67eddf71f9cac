#include "core/simulation/ping_model.hpp"

#include "core/simulation/echo_model.hpp"

#include <cmath>

namespace echotrail {

namespace {

constexpr HeadSetup usual_head;
constexpr double rest_between_pings_s = 0.035;
constexpr double gain_db_per_percent = 0.8;

/// Steps from one end of the sector to the other, and where a ping lies in the way to and fro.
struct Sweep {
    std::uint64_t steps = 0;
    std::uint64_t phase = 0;  ///< 0 … 2·steps − 1
    bool clockwise() const { return phase < steps; }
};

Sweep sweepOf(const Scenario& scenario, std::uint64_t number) {
    const auto steps =
        static_cast<std::uint64_t>(std::llround(2.0 * scenario.sector_half_width_deg / scenario.step_deg));
    return {steps, number % (2 * steps)};
}

}  // namespace

double pingInterval(const Scenario& scenario) {
    return 2.0 * scenario.range_m / usual_head.sound_speed + rest_between_pings_s;
}

double pingTime(const Scenario& scenario, std::uint64_t number) {
    const Microseconds since_start = microsecondsFromSeconds(static_cast<double>(number) * pingInterval(scenario));
    return std::chrono::duration<double>(since_start).count();
}

Bearing pingBearing(const Scenario& scenario, std::uint64_t number) {
    const Sweep sweep = sweepOf(scenario, number);
    const std::uint64_t step = sweep.clockwise() ? sweep.phase : 2 * sweep.steps - sweep.phase;
    return Bearing::degrees(static_cast<double>(step) * scenario.step_deg - scenario.sector_half_width_deg);
}

std::vector<std::uint8_t> simulateEcho(const Scenario& scenario, std::uint64_t seed, const HeadSetup& head,
                                       double time_s, std::uint64_t number) {
    return EchoModel(scenario, seed).echo(head, time_s, number);
}

HeadSetup headSetup(const Scenario& scenario, std::uint64_t number) {
    HeadSetup head;
    head.range_m = scenario.range_m;
    head.bin_interval_s = 2.0 * scenario.range_m / head.sound_speed / head.bins;
    head.bearing = pingBearing(scenario, number);
    head.step_rad = radiansFromDegrees(scenario.step_deg);
    head.frequency_hz = 1000.0 * scenario.frequency_khz;
    return head;
}

Ping simulatePing(const Scenario& scenario, std::uint64_t seed, std::uint64_t number) {
    EchoModel model(scenario, seed);
    return simulatePing(scenario, model, number);
}

Ping simulatePing(const Scenario& scenario, EchoModel& model, std::uint64_t number) {
    return simulatePing(scenario, model, number, headSetup(scenario, number), sweepOf(scenario, number).clockwise());
}

Ping simulatePing(const Scenario& scenario, EchoModel& model, std::uint64_t number, const HeadSetup& head,
                  bool clockwise) {
    const double ping_s = pingTime(scenario, number);
    return {.sequence = number,
            .time = simulation_start + microsecondsFromSeconds(ping_s),
            .bearing = head.bearing,
            .step_rad = head.step_rad,
            .range_scale_m = head.range_m,
            .bin_interval_s = head.bin_interval_s,
            .sound_speed_mps = head.sound_speed,
            .frequency_hz = head.frequency_hz,
            .gain_percent = head.gain_db / gain_db_per_percent,
            .clockwise = clockwise,
            .levels = model.echo(head, ping_s, number)};
}

}  // namespace echotrail
