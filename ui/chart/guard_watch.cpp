#include "ui/chart/guard_watch.hpp"

#include <algorithm>
#include <utility>

namespace echotrail {
namespace {

bool isVetoed(const QList<Area>& areas, const Eigen::Vector2f& place, const Pose& vehicle) {
    return std::any_of(areas.begin(), areas.end(),
                       [&](const Area& area) { return area.kind == Area::Kind::Veto && holds(area, place, vehicle); });
}

}  // namespace

void GuardWatch::setScene(const Scene& scene) {
    if (scene.position < position_) inside_.clear();
    position_ = scene.position;
    Visits now;
    for (const Area& area : areas_.areas()) {
        if (area.kind != Area::Kind::Guard) continue;
        for (const Track& track : scene.tracks) {
            const std::pair visit{track.id, QString::fromStdString(area.name)};
            const Eigen::Vector2f place = track.estimate.mean.head<2>().cast<float>();
            const Pose& vehicle = scene.latest.pose;
            const bool seen_inside = track.state == TrackState::Confirmed && holds(area, place, vehicle) &&
                                     !isVetoed(areas_.areas(), place, vehicle);
            const bool stays = track.state == TrackState::Coasting && inside_.contains(visit);
            if (seen_inside || stays) now.insert(visit);
        }
    }
    const Visits before = std::exchange(inside_, now);
    for (const auto& visit : now)
        if (!before.contains(visit)) Q_EMIT guardZoneEntered(visit.first, visit.second);
    for (const auto& visit : before)
        if (!now.contains(visit)) Q_EMIT guardZoneLeft(visit.first, visit.second);
}

}  // namespace echotrail
