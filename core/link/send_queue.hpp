#pragma once

#include "core/base/time.hpp"

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>

namespace echotrail {

/// What waits for one console, in lanes: of the lower ones something goes only when the higher ones are empty, so that
/// a picture never delays a track. Bounded in bytes. Where the way is too slow, what is sent becomes less, step by
/// step, in the order that link.proto declares, and more again when the way is free.
/// Order: times never go back.
class SendQueue {
public:
    enum class Lane { Urgent, Regions, Particles, Picture, Record };
    /// How much is left out, each with all before it.
    enum Level { Everything, HalfDetail, QuarterDetail, NoParticles, NoRegions, NoPicture };
    using Frame = std::shared_ptr<const std::string>;  ///< shared by the queues of all consoles

    struct Counts {
        std::uint64_t sent_bytes = 0;
        std::uint64_t left_out = 0;  ///< frames that the level, age or lack of room kept back
        std::uint64_t overflows = 0;
    };

    /// Sends no more than this on average; 0: no limit.
    void setRate(double bytes_per_second, Timestamp now);
    /// False: not even the urgent lane had room; then nothing waits any more, and the console has to be told afresh.
    bool add(Lane lane, Frame frame, Timestamp now);
    /// Appends what may go now, at most about `room` bytes, frames possibly in parts.
    void take(std::string& out, std::size_t room, Timestamp now);
    /// Adapts the level; what has waited too long to be worth sending is dropped. Called by add() and take().
    void judge(Timestamp now);
    /// Nothing that waits is of use any more but rows; a frame that was begun is finished.
    void clear();

    /// So much goes another way, within the same limit. False: it has to stay behind.
    bool spend(std::size_t bytes, Timestamp now);
    /// Something that was to go another way stays behind; it counts, too.
    void leaveOut() { ++counts_.left_out; }
    /// Whether a level lets this lane through.
    static bool allows(Lane lane, Level level);

    Level level() const { return level_; }
    double rate() const { return rate_; }  ///< bytes per second; 0: no limit
    bool empty() const { return waitingBytes() == 0; }
    std::size_t waitingBytes() const;
    std::size_t waitingIn(Lane lane) const { return lanes_[static_cast<std::size_t>(lane)].bytes; }
    /// Nothing could be sent for so long although something waited.
    Microseconds stuckFor(Timestamp now) const;
    const Counts& counts() const { return counts_; }

private:
    struct Waiting {
        Frame frame;
        Timestamp since{};
    };
    struct LaneQueue {
        std::deque<Waiting> frames;
        std::size_t bytes = 0;
    };
    static constexpr std::size_t lane_count = 5;

    LaneQueue& laneOf(Lane lane) { return lanes_[static_cast<std::size_t>(lane)]; }
    void dropOldest(LaneQueue& lane);
    void dropAll(LaneQueue& lane);
    Microseconds delay(Timestamp now) const;
    void refill(Timestamp now);

    std::array<LaneQueue, lane_count> lanes_;
    Frame begun_;  ///< a part of it is under way
    std::size_t begun_at_ = 0;
    Level level_ = Everything;
    Timestamp level_changed_{}, last_delay_{}, waiting_since_{}, refilled_{};
    double rate_ = 0.0, tokens_ = 0.0;
    Counts counts_;
};

}  // namespace echotrail
