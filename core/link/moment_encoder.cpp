#include "core/link/moment_encoder.hpp"

#include "core/link/framing.hpp"
#include "core/link/link_limits.hpp"
#include "core/link/wire_values.hpp"

#include <algorithm>

namespace echotrail {
namespace {

constexpr std::array<std::size_t, 4> details{1, 2, 4, 0};

std::size_t pictureOf(SendQueue::Level level) {
    switch (level) {
        case SendQueue::Everything:
            return 0;
        case SendQueue::HalfDetail:
            return 1;
        case SendQueue::QuarterDetail:
        case SendQueue::NoParticles:
        case SendQueue::NoRegions:
            return 2;
        case SendQueue::NoPicture:
            break;
    }
    return 3;
}

SendQueue::Frame frameOf(const wire::ToConsole& message) {
    return std::make_shared<const std::string>(linkFrame(message.SerializeAsString()));
}

/// The region of interest follows the vehicle at every ping; that alone is no news.
wire::Track withoutInterest(wire::Track track) {
    track.clear_interest_north_m();
    track.clear_interest_east_m();
    track.clear_interest_centre_rad();
    track.clear_interest_half_width_rad();
    track.clear_interest_near_m();
    track.clear_interest_far_m();
    return track;
}

}  // namespace

MomentFrames MomentEncoder::encode(LinkMoment moment) {
    MomentFrames frames;
    frames.tracks = encodeTracks(moment);
    frames.particles = encodeParticles(moment);
    if (!moment.regions.empty()) {
        wire::ToConsole message;
        message.set_sequence(++regions_);
        const std::size_t regions = std::min(moment.regions.size(), link_limits::most_regions);
        for (std::size_t i = 0; i < regions; ++i) write(moment.regions[i], *message.mutable_regions()->add_regions());
        frames.regions = frameOf(message);
        recent_regions_.push_back({frames.regions, moment.time});
    }
    tracks_ = std::move(moment.tracks);
    beam_ = std::move(moment.beam);
    if (beam_) {
        ++beams_;
        first_ping_ = beam_->first_ping;
        remember({beamAt(frames, SendQueue::Everything), beam_->ping.time, beam_->update.sweep});
    }
    return frames;
}

SendQueue::Frame MomentEncoder::beamAt(MomentFrames& frames, SendQueue::Level level) const {
    if (!beam_) return nullptr;
    const std::size_t picture = pictureOf(level);
    if (!frames.beam[picture]) frames.beam[picture] = encodeBeam(details[picture]);
    return frames.beam[picture];
}

SendQueue::Frame MomentEncoder::encodeBeam(std::size_t detail) const {
    wire::ToConsole message;
    message.set_sequence(beams_);
    write(*beam_, detail, *message.mutable_beam());
    return frameOf(message);
}

SendQueue::Frame MomentEncoder::encodeTracks(const LinkMoment& moment) {
    wire::ToConsole message;
    wire::Tracks& out = *message.mutable_tracks();
    std::map<int, std::string> now;
    const std::size_t count = std::min(moment.tracks.size(), link_limits::most_tracks);
    for (std::size_t i = 0; i < count; ++i) {
        wire::Track track;
        write(moment.tracks[i], false, track);
        std::string& text = now[moment.tracks[i].id];
        text = withoutInterest(track).SerializeAsString();
        const auto told = told_.find(moment.tracks[i].id);
        if (told == told_.end() || told->second != text) *out.add_tracks() = std::move(track);
    }
    for (const auto& [id, text] : told_)
        if (!now.contains(id)) out.add_gone(id);
    for (std::size_t i = 0; i < std::min(moment.looks.size(), link_limits::most_looks); ++i)
        write(moment.looks[i], *out.add_looks());
    told_ = std::move(now);
    if (out.tracks_size() == 0 && out.gone_size() == 0 && out.looks_size() == 0) return nullptr;
    message.set_sequence(++tracks_sent_);
    return frameOf(message);
}

SendQueue::Frame MomentEncoder::encodeParticles(const LinkMoment& moment) {
    wire::ToConsole message;
    std::map<int, Timestamp> now;
    for (const Track& track : moment.tracks) {
        if (track.particles.position_m.empty()) continue;
        now[track.id] = track.estimate.time;
        const auto told = clouds_told_.find(track.id);
        if (told != clouds_told_.end() && told->second == track.estimate.time) continue;
        write(track.id, track.particles, link_limits::particles_sent, *message.mutable_particles()->add_clouds());
    }
    clouds_told_ = std::move(now);
    if (!message.has_particles()) return nullptr;
    message.set_sequence(++particles_);
    return frameOf(message);
}

void MomentEncoder::remember(RecentBeam beam) {
    recent_bytes_ += beam.frame->size();
    const std::uint64_t sweep = beam.sweep;
    recent_beams_.push_back(std::move(beam));
    // Two whole sweeps: the edge of a sector is painted in one direction of the scan only.
    const auto old = [&] {
        return recent_beams_.front().sweep + 2 < sweep || recent_beams_.size() > link_limits::recent_beams ||
               recent_bytes_ > link_limits::recent_bytes;
    };
    while (recent_beams_.size() > 1 && old()) {
        recent_bytes_ -= recent_beams_.front().frame->size();
        recent_beams_.pop_front();
    }
    const Timestamp oldest = recent_beams_.front().time;
    while (!recent_regions_.empty() &&
           (recent_regions_.front().time < oldest || recent_regions_.size() > link_limits::recent_regions))
        recent_regions_.pop_front();
}

std::vector<SendQueue::Frame> MomentEncoder::recentBeams(std::size_t most_bytes) const {
    auto from = recent_beams_.end();
    for (std::size_t bytes = 0; from != recent_beams_.begin(); --from) {
        bytes += std::prev(from)->frame->size();
        if (bytes > most_bytes) break;
    }
    std::vector<SendQueue::Frame> frames;
    for (; from != recent_beams_.end(); ++from) frames.push_back(from->frame);
    return frames;
}

std::vector<SendQueue::Frame> MomentEncoder::recentRegions() const {
    std::vector<SendQueue::Frame> frames;
    for (const RecentRegions& each : recent_regions_) frames.push_back(each.frame);
    return frames;
}

}  // namespace echotrail
