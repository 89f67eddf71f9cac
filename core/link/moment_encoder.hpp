#pragma once

#include "core/link/link_values.hpp"
#include "core/link/send_queue.hpp"

#include <array>
#include <deque>
#include <map>
#include <string>
#include <vector>

namespace echotrail {

/// One moment aboard as frames that all consoles share.
struct MomentFrames {
    SendQueue::Frame tracks, regions, particles;  ///< none where nothing has changed
    std::array<SendQueue::Frame, 4> beam;         ///< as pictureOf() numbers them; made when first wanted
};

/// Turns moments into frames, only what has changed, and keeps what who comes late needs.
/// Order: moments as they happen.
class MomentEncoder {
public:
    MomentFrames encode(LinkMoment moment);
    /// The moment's beam with the detail that a level allows.
    SendQueue::Frame beamAt(MomentFrames& frames, SendQueue::Level level) const;

    const std::vector<Track>& tracks() const { return tracks_; }  ///< the last, with histories
    const std::optional<Timestamp>& firstPing() const { return first_ping_; }
    /// Beams of this sweep and the last two, oldest first: the newest of them in so many bytes.
    std::vector<SendQueue::Frame> recentBeams(std::size_t most_bytes) const;
    /// What the beam left meanwhile.
    std::vector<SendQueue::Frame> recentRegions() const;

private:
    struct RecentBeam {
        SendQueue::Frame frame;
        Timestamp time{};
        std::uint64_t sweep = 0;
    };
    struct RecentRegions {
        SendQueue::Frame frame;
        Timestamp time{};
    };
    SendQueue::Frame encodeBeam(std::size_t detail) const;
    SendQueue::Frame encodeTracks(const LinkMoment& moment);
    SendQueue::Frame encodeParticles(const LinkMoment& moment);
    void remember(RecentBeam beam);

    std::optional<LinkBeam> beam_;  ///< of the last moment
    std::vector<Track> tracks_;
    std::map<int, std::string> told_;       ///< each track as it was last sent
    std::map<int, Timestamp> clouds_told_;  ///< of when the particles last sent were
    std::optional<Timestamp> first_ping_;
    std::deque<RecentBeam> recent_beams_;
    std::size_t recent_bytes_ = 0;
    std::deque<RecentRegions> recent_regions_;
    std::uint64_t beams_ = 0, regions_ = 0, tracks_sent_ = 0, particles_ = 0;  ///< sequence numbers
};

}  // namespace echotrail
