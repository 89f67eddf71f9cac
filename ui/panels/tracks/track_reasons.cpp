#include "ui/panels/tracks/track_reasons.hpp"

#include "ui/style/formatter.hpp"
#include "ui/views/track_painter.hpp"

#include <algorithm>
#include <cmath>

namespace echotrail {
namespace {

constexpr std::size_t most_rivals = 3;

}  // namespace

QString TrackReasons::ofState(const Track& track, Timestamp now, const LifeParams& params) {
    const double silent_s = secondsBetween(track.last_seen, now);
    switch (track.state) {
        case TrackState::Tentative:
            return tr("%1 of %2 echoes, existence %3 of %4")
                .arg(track.looks)
                .arg(params.confirm_looks)
                .arg(Formatter::probability(track.existence), Formatter::probability(params.confirm_existence));
        case TrackState::Confirmed:
            return tr("%1 echoes; lost after %2 looks without").arg(track.looks).arg(params.lost_misses);
        case TrackState::Coasting:
            return tr("%1 of %2 looks without an echo").arg(track.misses).arg(params.lost_misses);
        case TrackState::Lost:
            break;
    }
    if (track.misses >= params.lost_misses)
        return tr("lost: %1 looks without an echo, limit %2").arg(track.misses).arg(params.lost_misses);
    if (track.existence < params.lost_existence)
        return tr("lost: existence %1 below %2")
            .arg(Formatter::probability(track.existence), Formatter::probability(params.lost_existence));
    return tr("lost: no echo for %1, limit %2").arg(Formatter::age(silent_s), Formatter::age(params.lost_after_s));
}

QString TrackReasons::ofBirth(const Track& track, Timestamp now) {
    return tr("%1, %2 ago, from an unclaimed echo")
        .arg(Formatter::utc(track.born).mid(11, 8), Formatter::age(secondsBetween(track.born, now)));
}

std::vector<RivalRegion> rivalsOf(const Track& track, const std::vector<Region>& regions, double reach_m,
                                  const LikenessParams& params) {
    std::vector<RivalRegion> rivals;
    for (const Region& region : regions) {
        if (isDropped(region)) continue;
        const double distance = (region.position_m - track.estimate.mean.head<2>()).norm();
        if (distance > reach_m) continue;
        const double alike = likeness(region.features, track.expected_features, params) *
                             levelLikeness(region.features.level_db, track.expected_features.level_db, params);
        rivals.push_back({region.id, std::isfinite(alike) ? alike : 0.0, distance});
    }
    std::sort(rivals.begin(), rivals.end(),
              [](const RivalRegion& a, const RivalRegion& b) { return a.likeness > b.likeness; });
    return rivals;
}

QString TrackReasons::competing(const Track& track, const Scene& scene, const Tracker::Params& params) {
    // The gate's long half-axis: no region beyond it can be taken for the track.
    const double spread = std::sqrt(track.estimate.covariance.topLeftCorner<2, 2>().trace());
    const double reach = std::sqrt(params.tracking.gate) * spread;
    auto rivals = rivalsOf(track, scene.regions, reach, params.likeness);
    if (rivals.empty()) return tr("no region within %1").arg(Formatter::range(reach));
    rivals.resize(std::min(rivals.size(), most_rivals));
    QStringList words;
    for (const RivalRegion& rival : rivals)
        words << tr("R%1 %2 at %3")
                     .arg(rival.id)
                     .arg(Formatter::probability(rival.likeness), Formatter::range(rival.distance_m));
    return words.join(QStringLiteral("   "));
}

}  // namespace echotrail
