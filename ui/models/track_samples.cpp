#include "ui/models/track_samples.hpp"

#include <algorithm>

namespace echotrail {

void TrackSamples::add(const Scene& scene) {
    if (scene.latest.time < latest_) clear();
    latest_ = scene.latest.time;
    std::erase_if(samples_, [&](const auto& entry) {
        return std::none_of(scene.tracks.begin(), scene.tracks.end(),
                            [&](const Track& track) { return track.id == entry.first; });
    });
    for (const Track& track : scene.tracks) {
        auto& samples = samples_[track.id];
        // A track is born by its first echo, which had nothing to be compared with.
        if (track.looks < 2 || (!samples.empty() && samples.back().time >= track.last_seen)) continue;
        if (samples.size() == most_samples) samples.erase(samples.begin());
        const auto particles = static_cast<double>(track.particles.size());
        samples.push_back(
            {track.last_seen, track.score, track.nis, particles > 0.0 ? track.particles.effective / particles : 0.0});
    }
}

const std::vector<TrackSample>& TrackSamples::of(int track) const {
    static const std::vector<TrackSample> none;
    const auto found = samples_.find(track);
    return found == samples_.end() ? none : found->second;
}

std::vector<double> missedShares(const std::vector<TrackLook>& history) {
    std::vector<double> shares;
    double missed = 0.0;
    for (const TrackLook& look : history) {
        missed += look.seen ? 0.0 : 1.0;
        shares.push_back(missed / static_cast<double>(shares.size() + 1));
    }
    return shares;
}

}  // namespace echotrail
