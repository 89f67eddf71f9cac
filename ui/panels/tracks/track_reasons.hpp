#pragma once

#include "core/runtime/scene.hpp"
#include "core/tracking/tracker.hpp"

#include <QCoreApplication>
#include <vector>

namespace echotrail {

/// Why a track is what it is, in words.
class TrackReasons {
    Q_DECLARE_TR_FUNCTIONS(TrackReasons)

public:
    /// What holds it in its state, and what would end that; why the last look used no echo, where that is known.
    static QString ofState(const Track& track, Timestamp now, const LifeParams& params);
    /// How many of the last looks used no echo, and why: "3 of 10 without an echo: 2 under the threshold, 1 merged…".
    static QString ofLastLooks(const Track& track);
    /// When and from what it was born.
    static QString ofBirth(const Track& track, Timestamp now);
    /// The regions of the last sweep about its place, the likest first: "R14 0.86 at 0.3 m".
    static QString competing(const Track& track, const Scene& scene, const Tracker::Params& params);

    static constexpr std::size_t last_looks = 10;

private:
    static QString ofSilence(const Track& track, Timestamp now, const LifeParams& params);
    static QString ofLastMiss(const Track& track);
    static QString word(NoEcho cause);
};

/// A region that might be a track's echo.
struct RivalRegion {
    std::uint32_t id = 0;
    double likeness = 0.0;    ///< to the track's reference, level included
    double distance_m = 0.0;  ///< from the track's place
};
/// The likest first. `reach_m`: none farther away.
std::vector<RivalRegion> rivalsOf(const Track& track, const std::vector<Region>& regions, double reach_m,
                                  const LikenessParams& params);

}  // namespace echotrail
