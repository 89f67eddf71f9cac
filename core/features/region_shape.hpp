#pragma once

#include "core/data/fan_image.hpp"
#include "core/data/pose.hpp"
#include "core/data/region.hpp"
#include "core/data/region_pixels.hpp"

#include <array>
#include <span>

namespace echotrail {

/// Hu's seven invariants of a binary mask: shift, scale and rotation do not change them. As corrected in the method
/// card, section e; [1] is M2, the one the tracker uses.
std::array<double, 7> huInvariants(std::span<const RegionPixel> mask);

/// The feature that likeness is judged by: log10(M2 + 1e-3). The added constant keeps round blobs, whose M2 is
/// almost 0, from scattering over decades.
double momentFeature(double m2);

/// Measures a region of a picture: place, time, area, moment, levels and outline. `epoch` is the source's first
/// ping, which the picture's beam times count from. Range, bearing and the widths along and across the line of
/// sight need the head's place: see seenFromHead. Region.beam_hits is left to whoever knows the pings.
Region measureRegion(const RegionPixels& pixels, const FanImage& picture, Timestamp epoch);

/// Fills in what depends on where the head was at `region.time`.
void seenFromHead(Region& region, const RegionPixels& pixels, const FanImage& picture, const Pose& head);

}  // namespace echotrail
