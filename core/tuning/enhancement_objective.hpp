#pragma once

#include "core/data/fan_image.hpp"

namespace echotrail {

/// What a local enhancement is worth, as published (method card, section c):
///     F = ln(ln(E + e)) · n / N · H
/// with E the sum of the gradient magnitudes of edge pixels (3×3 Sobel, not normalised, levels 0…255), n their number
/// (magnitude above 0.2 for levels in [0, 1]), N that of all pixels and H the entropy of their levels in bits. Pixels
/// beside unscanned ones are no edges, and unscanned ones do not count. 0 where there is no edge. It rewards speckle.
double publishedObjective(const FanImage& enhanced);

/// The card's guarded form, which does not: edges are those of a picture smoothed by a Gaussian of 2 pixels, where its
/// gradient exceeds its median by 5 times the median deviation from that; the outer term is ln(ln(E + e) + 1); and
/// what makes the speckle S greater than that of `plain` costs a factor exp(−3 (S / S_plain − 1)).
double guardedObjective(const FanImage& plain, const FanImage& enhanced);

/// How restless a picture is for its contrast: the median over its pixels of the deviation in a window of 9×9, over
/// the distance of the 99.5th percentile of the levels from their median, at least one level. 0 of an empty picture.
double speckleOf(const FanImage& fan);

}  // namespace echotrail
