#pragma once

#include "core/runtime/scene.hpp"

#include <map>
#include <vector>

namespace echotrail {

/// What one look of a track came to.
struct TrackSample {
    Timestamp time{};
    double likeness = 0.0;   ///< of the echo to the reference
    double nis = 0.0;        ///< normalised innovation squared
    double effective = 0.0;  ///< share of the particles, 0…1; 0 where there are none
};

/// Gathers over the scenes what a track says of its last echo only. Looks that no scene showed are missing; after a
/// jump back in time it begins anew.
class TrackSamples {
public:
    static constexpr std::size_t most_samples = 200;  ///< of a track; older ones are forgotten

    void add(const Scene& scene);
    /// Oldest first.
    const std::vector<TrackSample>& of(int track) const;
    void clear() { samples_.clear(); }

private:
    std::map<int, std::vector<TrackSample>> samples_;
    Timestamp latest_{};
};

/// Of a track's covered looks up to each one remembered: the share without an echo. One for each look of the history.
std::vector<double> missedShares(const std::vector<TrackLook>& history);

}  // namespace echotrail
