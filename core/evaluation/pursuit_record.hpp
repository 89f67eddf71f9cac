#pragma once

#include "core/data/pose.hpp"
#include "core/simulation/scenario.hpp"

#include <Eigen/Core>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace echotrail {

/// What became of a simulated vehicle that follows a target: where both truly were, ten times a second.
/// Order: take() in order of time.
class PursuitRecord {
public:
    struct Sample {
        double time_s = 0.0;  ///< since the scenario's start
        Pose vehicle;
        Eigen::Vector2d target_m{0, 0};  ///< north, east
        bool steered = false;            ///< the vehicle has heard of the target by then
        double range_m() const;
    };
    explicit PursuitRecord(double keep_range_m) : keep_range_m_(keep_range_m) {}

    /// The moments until `time_s` that were not taken yet, of the scenario's first target and its vehicle.
    void take(const Scenario& scenario, double time_s, bool steered);
    const std::vector<Sample>& samples() const { return samples_; }

    /// How well the range was kept.
    struct Figures {
        double seconds = 0.0;
        double mean_m = 0.0;          ///< of |range − the range to keep|
        double percentile_95_m = 0.0;
        double greatest_m = 0.0;
    };
    /// Over all of the time since the vehicle first heard of the target; nothing where it never did.
    std::optional<Figures> figures() const { return figuresFrom(HUGE_VAL); }
    /// Over the time since it was first within a metre of the range to keep: without the way there.
    std::optional<Figures> figuresSinceReached() const { return figuresFrom(1.0); }

    /// Both paths, a line per sample with a header.
    std::string csv() const;
    /// A drawing of both paths seen from above, north up, and of the range over time.
    std::string svg(const std::string& title) const;

private:
    std::optional<Figures> figuresFrom(double first_within_m) const;

    double keep_range_m_;
    std::vector<Sample> samples_;
};

}  // namespace echotrail
