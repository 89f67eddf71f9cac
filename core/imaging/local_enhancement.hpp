#pragma once

#include "core/base/parameters.hpp"
#include "core/data/fan_image.hpp"

#include <opencv2/core.hpp>

namespace echotrail {

struct LocalEnhancementParams {
    double enhance_a = 1.0;
    double enhance_b = 0.3;
    double enhance_c = 0.5;
    double enhance_k = 1.0;
    int enhance_window_pixels = 5;
};

template <>
struct Described<LocalEnhancementParams> {
    using P = LocalEnhancementParams;
    static constexpr std::string_view group = "Local enhancement";
    static constexpr auto fields = std::tuple{
        Field{&P::enhance_a, "enhance_a", "", 0, 1.5, "Exponent of the local mean that is added: small brightens"},
        Field{&P::enhance_b, "enhance_b", "", 0.01, 0.5, "Added to the local deviation: large keeps noise down"},
        Field{&P::enhance_c, "enhance_c", "", 0, 1, "How much of the local mean is taken off before amplifying"},
        Field{&P::enhance_k, "enhance_k", "", 0.5, 1.5, "Gain of the amplified detail"},
        Field{&P::enhance_window_pixels, "enhance_window_pixels", "pixels", 3, 31,
              "Width of the window of the local mean and deviation; an even number counts as the next odd one"}};
};

/// Stretches local contrast for the eye (method card, section c, after Munteanu and Rosa):
///     g = [k D / (σ + b)] (f - c m) + m^a, cut off at 0 and 1,
/// with f the level in [0, 1], m and σ its mean and deviation in the window, D the mean over the fan. Only scanned
/// pixels count, in the window and in D; unscanned ones stay 0. Detection uses it only where
/// parameter detect_on says so: it makes noise stand out.
/// The result has its own levels and shares the beam times with `fan`; of an empty picture it is empty.
FanImage enhanceLocally(const FanImage& fan, const LocalEnhancementParams& params);

}  // namespace echotrail
