#pragma once

#include "core/base/parameters.hpp"
#include "core/data/fan_image.hpp"
#include "core/data/pose.hpp"
#include "core/data/region.hpp"
#include "core/data/region_pixels.hpp"

#include <array>
#include <span>

namespace echotrail {

enum class CentroidWeight { Amplitude, Excess };

struct RegionShapeParams {
    CentroidWeight centroid = CentroidWeight::Amplitude;
};

template <>
struct Described<RegionShapeParams> {
    using P = RegionShapeParams;
    static constexpr std::string_view group = "Region's place";
    static constexpr auto fields = std::tuple{ChoiceField<P, CentroidWeight, 2>{
        &P::centroid,
        "centroid",
        {"amplitude", "excess"},
        "What a pixel of a region counts with for its place: the echo's amplitude, which favours the bright core, or "
        "the decibels it stands out by"}};
};

/// Hu's seven invariants of a binary mask: shift, scale and rotation do not change them. As corrected in the method
/// card, section e; [1] is M2, the one the tracker uses.
std::array<double, 7> huInvariants(std::span<const RegionPixel> mask);

/// The feature that likeness is judged by: log10(M2 + 1e-3). The added constant keeps round blobs, whose M2 is
/// almost 0, from scattering over decades.
double momentFeature(double m2);

/// Measures a region of a picture: place, time, area, moment, levels and outline. `epoch` is the source's first
/// ping, which the picture's beam times count from. Range, bearing and the widths along and across the line of
/// sight need the head's place: see seenFromHead. Region.beam_hits is left to whoever knows the pings.
Region measureRegion(const RegionPixels& pixels, const FanImage& picture, Timestamp epoch,
                     const RegionShapeParams& params = {});

/// Fills in what depends on where the head was at `region.time`.
void seenFromHead(Region& region, const RegionPixels& pixels, const FanImage& picture, const Pose& head);

}  // namespace echotrail
