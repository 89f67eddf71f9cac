#pragma once

#include "core/features/target_reference.hpp"

namespace echotrail {

/// How far a region is from what is expected of it, in the deviations that still count as alike: the terms that
/// likeness(), levelLikeness() and strengthRatio() are made of. What is left out of the comparison is 0.
/// A term's logarithm of the likelihood is −d²/2.
struct LikenessDeviations {
    double area = 0.0;
    double moment = 0.0;
    double level = 0.0;
    double strength = 0.0;
};

LikenessDeviations likenessDeviations(const RegionFeatures& seen, const RegionFeatures& expected,
                                      const LikenessParams& params);

}  // namespace echotrail
