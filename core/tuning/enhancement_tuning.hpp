#pragma once

#include "core/data/fan_image.hpp"
#include "core/data/source.hpp"
#include "core/imaging/local_enhancement.hpp"
#include "core/tuning/particle_swarm.hpp"

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

namespace echotrail {

enum class EnhancementObjective { Published, Guarded };
std::string_view toText(EnhancementObjective objective);

/// `count` sweeps of a source, evenly through its time: each as the whole picture that regions are grown in where
/// parameter detect_on says so, smoothed, and cut to what was scanned. Fewer where the source ends before.
std::vector<FanImage> sweepPictures(PingSource& source, int count);

struct TunedEnhancement {
    LocalEnhancementParams params;
    double value = 0.0;        ///< of the objective, the mean over the pictures
    double plain_value = 0.0;  ///< the same of the pictures as they are
    int evaluations = 0;
};

/// The parameters a, b, c and k of the local enhancement that make the objective greatest over the pictures, found by
/// particle swarm from the card's bounds and start. The guarded objective keeps b at 0.05 or above. `tell`, called now
/// and then, says how much of the search is done (0…1); `cancelled` ends it early with what was found.
TunedEnhancement tuneEnhancement(const std::vector<FanImage>& pictures, EnhancementObjective objective,
                                 std::uint64_t seed, const std::function<void(double)>& tell = {},
                                 const std::function<bool()>& cancelled = {});

}  // namespace echotrail
