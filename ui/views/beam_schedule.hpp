#pragma once

#include "core/runtime/scene.hpp"
#include "ui/views/fan_geometry.hpp"

#include <optional>
#include <vector>

namespace echotrail {

/// What a scene says about its sector: its edges, its range. Until the first sweep is whole the edges still grow.
Sector sectorOf(const Scene& scene);
/// The sector the picture is fitted to: while the edges still grow, a symmetric one that holds them, lest the picture
/// jumps with every ping.
Sector sectorToFit(const Scene& scene);

/// Whether the scene knows which way north is.
bool headingKnown(const Scene& scene);

/// Seconds until the beam meets a bearing again, from the pace of the last sweep; none before there was one, or where
/// the bearing lies outside the sector.
std::optional<double> secondsToNextLook(const Scene& scene, Bearing from_bow);

/// Ages of the beams over the sector, from the left to the right, in seconds before the newest one.
struct BeamAges {
    std::int32_t newest_ms = 0;  ///< now, on the clock of FanImage::beam_time_ms: of the last ping
    double oldest_s = 0.0;
    std::vector<float> age_s;  ///< one per degree from the left edge; negative: never scanned
};
BeamAges beamAges(const Scene& scene, const Sector& sector);

}  // namespace echotrail
