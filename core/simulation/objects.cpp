#include "core/simulation/objects.hpp"

#include "core/base/random.hpp"
#include "core/simulation/acoustics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace echotrail {

namespace {

using acoustics::powerOf;

constexpr double range_smear = 0.15;         // deviation of an object's echo in range, times its size
constexpr double scintillation_s = 3.0;      // between independent strengths of an object
constexpr double yaw_s = 4.0;                // between independent directions of a reflector
constexpr double ghost_s = 8.0;              // between independent ways of a ghost
constexpr double reflector_lobe_deg = 20.0;  // off its axis, a reflector is 3 dB weaker
constexpr double bubble_size_m = 2.0;

/// What random numbers are for; an object's number is added.
enum Purpose : std::uint64_t { scintillation_numbers = 1000, yaw_numbers = 2000, ghost_numbers = 3000 };

/// Gaussian numbers that change smoothly: each turns from one knot's value to the next with its variance kept.
class SmoothNumbers {
public:
    SmoothNumbers(std::uint64_t seed, std::uint64_t purpose, double time_s, double knot_s)
        : turn_(std::fmod(time_s / knot_s, 1.0) * std::numbers::pi / 2.0),
          from_(seed, purpose, static_cast<std::uint64_t>(time_s / knot_s)),
          to_(seed, purpose, static_cast<std::uint64_t>(time_s / knot_s) + 1) {}
    double gaussian() { return std::cos(turn_) * from_.gaussian() + std::sin(turn_) * to_.gaussian(); }
    /// In 0 … 1, evenly.
    double uniform() { return 0.5 * std::erfc(-gaussian() / std::numbers::sqrt2); }

private:
    double turn_;
    RandomStream from_, to_;
};

/// Strength of an object relative to its mean: gamma of shape 2, from four Gaussian numbers.
double scintillation(std::uint64_t seed, std::uint64_t object, double time_s) {
    SmoothNumbers numbers(seed, scintillation_numbers + object, time_s, scintillation_s);
    double sum = 0.0;
    for (int i = 0; i < 4; ++i) {
        const double value = numbers.gaussian();
        sum += value * value;
    }
    return sum / 4.0;
}

/// How a ping meets a point.
struct Meeting {
    double range_m = 0.0;
    double power = 0.0;     ///< of the lobe, both ways
    double across = 0.0;    ///< of that what the lobe's width leaves, without side lobes
    double from_rad = 0.0;  ///< the direction in which the point sees the head
};

/// Meets a point at a place `positionAt(seconds since transmission)`.
template <class PositionAt>
Meeting meet(const Scenario& scenario, double ping_s, const HeadSetup& head, double below_m,
             const PositionAt& positionAt) {
    const acoustics::Lobe lobe = acoustics::lobeAt(head.frequency_hz);
    struct View {
        double range_m, across, above, direction_rad;
    };
    const auto seenFrom = [&](double reached_s, double at_s) {
        const Pose vehicle = vehiclePose(scenario, ping_s + at_s);
        const Eigen::Vector2d way = positionAt(reached_s) - Eigen::Vector2d(vehicle.north_m, vehicle.east_m);
        const double direction = std::atan2(way.y(), way.x());
        const double off_axis = wrapRadians(direction - vehicle.heading.inRadians() - head.bearing.inRadians());
        const double elevation = std::atan2(below_m, way.norm());
        return View{std::hypot(way.norm(), below_m), lobe.across(off_axis), lobe.above(elevation), direction};
    };
    const double flight_s = seenFrom(0.0, 0.0).range_m / head.sound_speed;
    const View transmit = seenFrom(flight_s, 0.0), receive = seenFrom(flight_s, 2.0 * flight_s);
    return {.range_m = seenFrom(flight_s, flight_s).range_m,
            .power = acoustics::twoWay(transmit.across * transmit.above, receive.across * receive.above),
            .across = transmit.across * receive.across,
            .from_rad = wrapRadians(transmit.direction_rad + std::numbers::pi)};
}

double fadeDb(const SimulatedTarget& target, double time_s) {
    double sum = 0.0;
    for (const Fade& fade : target.fades)
        if (time_s >= fade.from_s && time_s < fade.until_s) sum += fade.depth_db;
    return sum;
}

/// Target strength in dB without its scintillation.
double strengthOf(const SimulatedTarget& target, std::uint64_t seed, std::uint64_t object, const HeadSetup& head,
                  double time_s, const Meeting& met) {
    if (target.reflector_m == 0.0) return target.strength_db - fadeDb(target, time_s);
    const Eigen::Vector2d course = targetMotion(target, time_s).velocity_mps;
    SmoothNumbers yaw(seed, yaw_numbers + object, time_s, yaw_s);
    const double looks_rad =
        std::atan2(course.y(), course.x()) + radiansFromDegrees(target.faces_deg + target.wander_deg * yaw.gaussian());
    const double aspect = degreesFromRadians(wrapRadians(met.from_rad - looks_rad)) / reflector_lobe_deg;
    const double axis_db =
        acoustics::reflectorStrength(target.reflector_m, met.range_m, head.frequency_hz, head.sound_speed);
    return std::max(axis_db - 3.0 * aspect * aspect, target.body_db) - fadeDb(target, time_s);
}

/// Copies of an echo by way of bottom and surface: later by 0.2–3 m, weaker by 6–20 dB.
void addGhosts(std::vector<PointEcho>& echoes, const PointEcho& of, int copies, std::uint64_t seed,
               std::uint64_t object, double time_s) {
    for (int copy = 0; copy < copies; ++copy) {
        SmoothNumbers numbers(seed, ghost_numbers + 100 * object + static_cast<std::uint64_t>(copy), time_s, ghost_s);
        PointEcho ghost = of;
        ghost.range_m += 0.2 + 2.8 * numbers.uniform();
        ghost.power *= powerOf(-6.0 - 14.0 * numbers.uniform());
        echoes.push_back(ghost);
    }
}

/// Bubbles stay where the target shed them, once a second.
void addWake(std::vector<PointEcho>& echoes, const Scenario& scenario, const SimulatedTarget& target,
             const HeadSetup& head, double time_s) {
    for (double shed_s = std::floor(time_s); shed_s > time_s - target.wake_s; shed_s -= 1.0) {
        const Eigen::Vector2d place = targetMotion(target, shed_s).position_m;
        const Meeting met = meet(scenario, time_s, head, target.below_head_m, [&](double) { return place; });
        const double left = 1.0 - (time_s - shed_s) / target.wake_s;
        echoes.push_back({met.range_m, range_smear * bubble_size_m, met.power * left * powerOf(target.wake_db)});
    }
}

/// An object from `low_m` to `high_m` above the bottom hides what lies behind it as seen from the head's height.
Shadow shadowOf(const Meeting& met, double size_m, double low_m, double high_m, double head_height_m,
                const HeadSetup& head) {
    const auto reaches = [&](double height_m) {
        return height_m < head_height_m ? met.range_m * head_height_m / (head_height_m - height_m)
                                        : std::numeric_limits<double>::infinity();
    };
    const double lobe_m = acoustics::lobeAt(head.frequency_hz).integralWidth() * met.range_m;
    return {reaches(std::max(low_m, 0.0)), reaches(high_m), std::min(size_m / lobe_m, 1.0) * met.across};
}

}  // namespace

ObjectEchoes objectEchoes(const Scenario& scenario, std::uint64_t seed, const HeadSetup& head, double time_s) {
    return objectEchoes(scenario, allDebris(scenario, seed), seed, head, time_s);
}

ObjectEchoes objectEchoes(const Scenario& scenario, const std::vector<Debris>& all_debris, std::uint64_t seed,
                          const HeadSetup& head, double time_s) {
    ObjectEchoes all;
    const double height_m = altitudeAt(scenario, time_s);
    for (std::uint64_t object = 0; object < scenario.targets.size(); ++object) {
        const SimulatedTarget& target = scenario.targets[object];
        const Meeting met = meet(scenario, time_s, head, target.below_head_m,
                                 [&](double t) { return targetMotion(target, time_s + t).position_m; });
        const double strength = powerOf(strengthOf(target, seed, object, head, time_s, met));
        const PointEcho echo{met.range_m, range_smear * target.size_m,
                             met.power * strength * scintillation(seed, object, time_s)};
        all.echoes.push_back(echo);
        addGhosts(all.echoes, echo, scenario.multipath_copies, seed, object, time_s);
        if (target.wake_s > 0.0) addWake(all.echoes, scenario, target, head, time_s);
        const double middle_m = height_m - target.below_head_m, half_m = target.size_m / 2.0;
        if (scenario.shadows)
            all.shadows.push_back(shadowOf(met, target.size_m, middle_m - half_m, middle_m + half_m, height_m, head));
    }
    for (const Debris& debris : all_debris) {
        const Eigen::Vector2d place(debris.north_m, debris.east_m);
        const Meeting met = meet(scenario, time_s, head, height_m - debris.size_m / 2.0, [&](double) { return place; });
        all.echoes.push_back({met.range_m, range_smear * debris.size_m, met.power * powerOf(debris.strength_db)});
        if (scenario.shadows) all.shadows.push_back(shadowOf(met, debris.size_m, 0.0, debris.size_m, height_m, head));
    }
    return all;
}

bool beamIsOn(const Scenario& scenario, const SimulatedTarget& target, const HeadSetup& head, double time_s) {
    const Meeting met = meet(scenario, time_s, head, target.below_head_m,
                             [&](double t) { return targetMotion(target, time_s + t).position_m; });
    return met.range_m <= head.range_m && met.across >= 0.25;
}

}  // namespace echotrail
