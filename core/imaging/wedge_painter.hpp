#pragma once

#include "core/data/fan_image.hpp"
#include "core/imaging/ray.hpp"

namespace echotrail {

/// A stretch of range in metres from the head.
struct RangeInterval {
    double near_m = 0.0;
    double far_m = 0.0;
};

/// Paints what lies between two echo lines heard one after the other (method card, section b, step 2):
///     L(X) = (1 - u) L_previous(r1) + u L_current(r2),   u = a1 / (a1 + a2),
/// linear in range and bearing, in level units, rounded to the nearest level. r1, r2 are the pixel's ranges from the
/// head and a1, a2 its angles from the beam, each at the moment the echo of that line came from there.
/// beam_time_ms becomes the nearer beam's. Only pixels between the lines, within `metres` of both heads and within the
/// tile are visited; what was there is overwritten, so the newest wins. Where the head has outrun its beam, so that
/// the lines cross, the pixels on the near side of the crossing lie between them, too.
///
/// Nothing is painted between equal head bearings, nor across a gap of more than 2.5 steps, nor where a line has fewer
/// than two bins. A pixel's bytes depend on the two lines and its place only, not on the tile it is part of, if tiles
/// lie on one grid: north_m and east_m whole multiples of pixel_m.
void paintWedge(const Ray& previous, const Ray& current, RangeInterval metres, FanImage& tile);

}  // namespace echotrail
