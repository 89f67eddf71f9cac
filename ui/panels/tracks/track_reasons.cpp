#include "ui/panels/tracks/track_reasons.hpp"

#include "ui/style/formatter.hpp"
#include "ui/views/track_painter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace echotrail {
namespace {

constexpr std::size_t most_rivals = 3;

}  // namespace

QString TrackReasons::ofState(const Track& track, Timestamp now, const LifeParams& params) {
    switch (track.state) {
        case TrackState::Tentative:
            return tr("%1 of %2 echoes, existence %3 of %4")
                .arg(track.looks)
                .arg(params.confirm_looks)
                .arg(Formatter::probability(track.existence), Formatter::probability(params.confirm_existence));
        case TrackState::Confirmed:
            return tr("%1 echoes; lost after %2 looks without").arg(track.looks).arg(params.lost_misses);
        case TrackState::Coasting:
        case TrackState::Lost:
            break;
    }
    const QString why = ofLastMiss(track);
    const QString silence = ofSilence(track, now, params);
    return why.isEmpty() ? silence : silence + " · " + why;
}

/// Of a track that coasts or is lost.
QString TrackReasons::ofSilence(const Track& track, Timestamp now, const LifeParams& params) {
    if (track.state == TrackState::Coasting)
        return tr("%1 of %2 looks without an echo").arg(track.misses).arg(params.lost_misses);
    if (track.misses >= params.lost_misses)
        return tr("lost: %1 looks without an echo, limit %2").arg(track.misses).arg(params.lost_misses);
    if (track.existence < params.lost_existence)
        return tr("lost: existence %1 below %2")
            .arg(Formatter::probability(track.existence), Formatter::probability(params.lost_existence));
    const double silent_s = secondsBetween(track.last_seen, now);
    return tr("lost: no echo for %1, limit %2").arg(Formatter::age(silent_s), Formatter::age(params.lost_after_s));
}

QString TrackReasons::ofLastMiss(const Track& track) {
    if (track.history.empty() || track.history.back().seen) return {};
    switch (track.history.back().no_echo) {
        case NoEcho::OutsideSector:
            return tr("the sector leaves it out");
        case NoEcho::NotYetScanned:
            return tr("the beam has not come by");
        case NoEcho::UnderThreshold:
            return tr("nothing stood out");
        case NoEcho::Merged:
            return tr("run into something larger");
        case NoEcho::TakenByAnother:
            return tr("what was there is another track's");
        case NoEcho::OutscoredByClutter:
            return tr("what was there is more likely clutter");
        case NoEcho::NavigationGap:
            return tr("navigation was missing");
        case NoEcho::PingsMissing:
            return tr("pings were missing");
        case NoEcho::None:
            break;
    }
    return {};
}

/// As logs and files of tracks call it.
QString TrackReasons::word(NoEcho cause) {
    switch (cause) {
        case NoEcho::OutsideSector:
            return tr("outside the sector");
        case NoEcho::NotYetScanned:
            return tr("not yet scanned");
        case NoEcho::UnderThreshold:
            return tr("under the threshold");
        case NoEcho::Merged:
            return tr("merged with clutter");
        case NoEcho::TakenByAnother:
            return tr("taken by another track");
        case NoEcho::OutscoredByClutter:
            return tr("out-scored by clutter");
        case NoEcho::NavigationGap:
            return tr("navigation gap");
        case NoEcho::PingsMissing:
            return tr("pings missing");
        case NoEcho::None:
            break;
    }
    return tr("cause not told");
}

QString TrackReasons::ofLastLooks(const Track& track) {
    const std::size_t looks = std::min(last_looks, track.history.size());
    if (looks == 0) return Formatter::unknown();
    std::array<int, no_echo_causes> misses{};
    for (std::size_t i = track.history.size() - looks; i < track.history.size(); ++i)
        if (!track.history[i].seen) ++misses[static_cast<std::size_t>(track.history[i].no_echo)];
    const int missed = std::accumulate(misses.begin(), misses.end(), 0);
    if (missed == 0) return tr("%1 of %1 with an echo").arg(looks);
    // A lost track's history ends with the loss: "State" goes on to count the looks that search for it.
    const QString share =
        (track.state == TrackState::Lost ? tr("until lost, %1 of %2 without an echo") : tr("%1 of %2 without an echo"))
            .arg(missed)
            .arg(looks);
    if (missed == misses[static_cast<std::size_t>(NoEcho::None)]) return share;  // a tracker that does not tell
    QStringList causes;
    for (std::size_t cause = 0; cause < misses.size(); ++cause) {
        const QString name = word(static_cast<NoEcho>(cause));
        if (misses[cause] == missed) return tr("%1: %2").arg(share, name);
        if (misses[cause] > 0) causes << tr("%1 %2").arg(misses[cause]).arg(name);
    }
    return tr("%1: %2").arg(share, causes.join(tr(", ")));
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
