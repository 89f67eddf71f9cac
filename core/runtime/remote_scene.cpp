#include "core/runtime/remote_scene.hpp"

#include "core/imaging/local_enhancement.hpp"
#include "core/imaging/ray.hpp"
#include "core/runtime/timeline.hpp"

#include <algorithm>

namespace echotrail {
namespace {

constexpr std::size_t longest_history = 64;  // as long as aboard

}  // namespace

void RemoteScene::take(const LinkEvent& event) {
    if (const auto* welcome = std::get_if<LinkWelcome>(&event)) {
        if (run_ && *run_ != welcome->run) *this = {};  // another run: another local frame, other tracks
        run_ = welcome->run;
    }
    if (const auto* snapshot = std::get_if<LinkSnapshot>(&event)) takeSnapshot(*snapshot);
    if (const auto* beam = std::get_if<LinkBeam>(&event)) takeBeam(*beam);
    if (const auto* regions = std::get_if<LinkRegions>(&event)) builder_.addFinal({.regions = regions->regions});
    if (const auto* tracks = std::get_if<LinkTracks>(&event)) takeTracks(*tracks);
    if (const auto* clouds = std::get_if<LinkClouds>(&event)) takeClouds(*clouds);
    if (const auto* health = std::get_if<LinkHealth>(&event)) health_ = *health;
    if (const auto* parameters = std::get_if<LinkParameters>(&event)) takeParameters(*parameters);
    changed_ |= has_beam_;
}

void RemoteScene::takeSnapshot(const LinkSnapshot& snapshot) {
    takeParameters(snapshot.parameters);
    health_ = snapshot.health;
    tracks_.clear();
    for (const Track& track : snapshot.tracks) tracks_[track.id] = track;
    builder_ = {};  // the last sweeps follow; the picture that is there stays until they do
    break_off_ = true;
}

void RemoteScene::takeBeam(const LinkBeam& beam) {
    beam_ = beam;
    has_beam_ = true;
    builder_.add(beam.ping, beam.update, 0.0);
    if (beam.ping.levels.empty()) {
        break_off_ = true;  // nobody knows what was there
        return;
    }
    const Ray ray = makeRay(beam_.ping, beam.update.pose, beam.update.later_pose, beam.mount, beam.first_ping);
    fan_.add(ray, beam.ping.range_scale_m, beam.update.broke_off || break_off_);
    break_off_ = false;
    builder_.addPicture(fan_.image(), beam.update);
    builder_.addLine(lineOf(beam.ping, beam.update));
}

void RemoteScene::takeTracks(const LinkTracks& tracks) {
    for (const Track& track : tracks.tracks) {
        Track& known = tracks_[track.id];
        auto history = std::move(known.history);
        auto particles = std::move(known.particles);
        known = track;
        known.history = std::move(history);
        known.particles = std::move(particles);
    }
    for (const TrackLook& look : tracks.looks) {
        const auto known = tracks_.find(look.track);
        if (known == tracks_.end()) continue;  // its last look came with its end
        auto& history = known->second.history;
        if (history.size() >= longest_history) history.erase(history.begin());
        history.push_back(look);
    }
    for (const int id : tracks.gone) tracks_.erase(id);
}

void RemoteScene::takeClouds(const LinkClouds& clouds) {
    for (const auto& [id, cloud] : clouds.clouds)
        if (const auto known = tracks_.find(id); known != tracks_.end()) known->second.particles = cloud;
}

void RemoteScene::takeParameters(const LinkParameters& parameters) {
    passed_over_.clear();
    for (const auto& [name, value] : parameters.values)
        if (const auto set = setParameter(params_, name, value); !set) passed_over_.push_back(set.error());
    fan_.setParams(params_.fan);
}

std::optional<Timestamp> RemoteScene::lastPing() const {
    if (!has_beam_) return std::nullopt;
    return beam_.ping.time;
}

bool RemoteScene::follows() const {
    return std::any_of(tracks_.begin(), tracks_.end(), [](const auto& each) { return isFollowed(each.second.state); });
}

Scene RemoteScene::build(bool enhanced) {
    changed_ = false;
    std::vector<Track> tracks;
    for (const auto& [id, track] : tracks_) tracks.push_back(track);
    Scene scene = builder_.build(fan_.image(), std::move(tracks), beam_.ping, beam_.update);
    scene.position = beam_.ping.sequence + 1;
    scene.counts = health_.counts;
    scene.navigation_known = beam_.navigation_known;
    scene.microseconds_per_ping = health_.microseconds_per_ping;
    if (enhanced) scene.enhanced = enhanceLocally(scene.fan, params_.enhancement);
    return scene;
}

}  // namespace echotrail
