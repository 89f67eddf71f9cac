#include "core/pipelines/sweep_follower.hpp"

#include <cmath>
#include <numbers>

namespace echotrail {
namespace {

constexpr double widest_steps = 2.5;       // more than this between two pings, and some are missing
constexpr double longest_pause_s = 10.0;   // what was seen before is another picture
constexpr double missing_intervals = 3.0;  // later than this many, and pings are missing

}  // namespace

SweepFollower::Step SweepFollower::follow(Bearing head_bearing, double step_rad, Timestamp time) {
    Step step;
    const double interval_s = last_ ? secondsBetween(last_time_, time) : 0.0;
    const bool paused = interval_s > longest_pause_s;
    step.pings_missing = interval_s_ > 0.0 && interval_s > missing_intervals * interval_s_;
    interval_s_ = interval_s_ > 0.0 ? 0.9 * interval_s_ + 0.1 * interval_s : interval_s;
    const double turn = last_ && !paused ? head_bearing - *last_ : 0.0;
    last_ = head_bearing;
    last_time_ = time;
    if (paused) {
        direction_ = 0;
        turned_rad_ = 0.0;
        step.turned_round = step.sweep_ended = true;
        return step;
    }
    if (std::abs(turn) < 1e-9) return step;  // ends of a sector are often logged twice
    const int direction = turn > 0 ? 1 : -1;
    const bool jumped = std::abs(turn) > widest_steps * step_rad;
    const bool reversed = direction_ != 0 && direction != direction_;
    step.turned_round = jumped || reversed;
    step.sweep_ended = reversed;
    if (reversed) turned_rad_ = 0.0;
    // A jump against the direction is a flyback: the next step tells the new direction.
    direction_ = jumped && reversed ? 0 : direction;
    turned_rad_ += std::abs(turn);
    if (turned_rad_ >= 2.0 * std::numbers::pi - 1e-9) {
        step.sweep_ended = true;
        turned_rad_ -= 2.0 * std::numbers::pi;
    }
    return step;
}

}  // namespace echotrail
