#include "core/tuning/particle_swarm.hpp"

#include "core/base/random.hpp"

#include <algorithm>
#include <cassert>

namespace echotrail {
namespace {

constexpr double worst = -std::numeric_limits<double>::infinity();
constexpr std::uint64_t swarm_numbers = 1;

class Swarm {
public:
    Swarm(const std::vector<Bounds>& bounds, const SwarmPoint& start, std::uint64_t seed, const SwarmParams& params)
        : bounds_(bounds), params_(params), random_(seed, swarm_numbers, 0) {
        assert(start.size() == bounds.size() && params.particles > 0);
        for (int i = 0; i < params.particles; ++i) {
            SwarmPoint place, velocity;
            for (std::size_t d = 0; d < bounds.size(); ++d) {
                const auto [low, high] = bounds[d];
                place.push_back(i == 0 ? std::clamp(start[d], low, high) : between(low, high));
                velocity.push_back(between(-fastest(d), fastest(d)));
            }
            places_.push_back(std::move(place));
            velocities_.push_back(std::move(velocity));
        }
        own_best_ = places_;
        own_value_.assign(places_.size(), worst);
    }

    const std::vector<SwarmPoint>& places() const { return places_; }

    void take(std::span<const double> values, SwarmResult& result) {
        for (std::size_t i = 0; i < places_.size(); ++i) {
            if (!(values[i] > own_value_[i])) continue;  // nor is what is no number
            own_value_[i] = values[i];
            own_best_[i] = places_[i];
            if (!(values[i] > result.value)) continue;
            result.value = values[i];
            result.best = places_[i];
        }
        result.evaluations += static_cast<int>(places_.size());
    }

    void move(double inertia, const SwarmPoint& best) {
        for (std::size_t i = 0; i < places_.size(); ++i)
            for (std::size_t d = 0; d < bounds_.size(); ++d) {
                double &x = places_[i][d], &v = velocities_[i][d];
                const double own = params_.own_pull * random_.uniform() * (own_best_[i][d] - x);
                const double common = params_.common_pull * random_.uniform() * (best[d] - x);
                v = std::clamp(inertia * v + own + common, -fastest(d), fastest(d));
                x += v;
                const double inside = std::clamp(x, bounds_[d].low, bounds_[d].high);
                if (inside != x) v *= -params_.rebound;
                x = inside;
            }
    }

private:
    double fastest(std::size_t d) const { return params_.fastest_share * (bounds_[d].high - bounds_[d].low); }
    double between(double low, double high) { return low + (high - low) * random_.uniform(); }

    const std::vector<Bounds>& bounds_;
    SwarmParams params_;
    RandomStream random_;
    std::vector<SwarmPoint> places_, velocities_, own_best_;
    std::vector<double> own_value_;
};

}  // namespace

SwarmResult maximise(const std::function<void(std::span<const SwarmPoint>, std::span<double>)>& evaluate,
                     const std::vector<Bounds>& bounds, const SwarmPoint& start, std::uint64_t seed,
                     const SwarmParams& params, const std::function<bool()>& cancelled) {
    Swarm swarm(bounds, start, seed, params);
    SwarmResult result{.best = swarm.places().front()};
    std::vector<double> values(swarm.places().size());
    for (int i = 0; i < params.iterations; ++i) {
        if (cancelled && cancelled()) break;
        const double passed = params.iterations > 1 ? static_cast<double>(i) / (params.iterations - 1) : 0.0;
        if (i > 0)
            swarm.move(params.first_inertia + passed * (params.last_inertia - params.first_inertia), result.best);
        evaluate(swarm.places(), values);
        swarm.take(values, result);
    }
    return result;
}

}  // namespace echotrail
