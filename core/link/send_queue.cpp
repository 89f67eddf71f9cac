#include "core/link/send_queue.hpp"

#include "core/link/link_limits.hpp"

#include <algorithm>

namespace echotrail {
namespace {

constexpr Microseconds slow{500'000}, quick{100'000};  // delays at which less, or more, is sent
constexpr Microseconds before_less{1'000'000}, before_more{5'000'000};
constexpr Microseconds worthless{2'000'000};  // a picture of then would be shown as of now
constexpr double burst_s = 0.25;              // of the rate

constexpr std::array<std::size_t, 5> room_of_lane{link_limits::urgent_bytes, link_limits::regions_bytes,
                                                  link_limits::particles_bytes, link_limits::picture_bytes,
                                                  link_limits::record_bytes};

}  // namespace

void SendQueue::setRate(double bytes_per_second, Timestamp now) {
    rate_ = bytes_per_second;
    tokens_ = burst_s * rate_;
    refilled_ = now;
}

bool SendQueue::allows(Lane lane, Level level) {
    if (lane == Lane::Particles) return level < NoParticles;
    return lane != Lane::Regions || level < NoRegions;  // a beam without its levels still says where the vehicle is
}

bool SendQueue::add(Lane lane, Frame frame, Timestamp now) {
    judge(now);
    if (!allows(lane, level_)) {
        ++counts_.left_out;
        return true;
    }
    LaneQueue& queue = laneOf(lane);
    const std::size_t room = room_of_lane[static_cast<std::size_t>(lane)];
    if (lane == Lane::Urgent && queue.bytes + frame->size() > room) {
        ++counts_.overflows;
        clear();
        return false;
    }
    while (!queue.frames.empty() && queue.bytes + frame->size() > room) dropOldest(queue);
    if (frame->size() > room) {
        ++counts_.left_out;
        return true;
    }
    if (empty()) waiting_since_ = now;
    queue.bytes += frame->size();
    queue.frames.push_back({std::move(frame), now});
    return true;
}

void SendQueue::take(std::string& out, std::size_t room, Timestamp now) {
    refill(now);
    if (rate_ > 0.0) room = std::min(room, static_cast<std::size_t>(std::max(0.0, tokens_)));
    const std::size_t before = out.size();
    while (room > 0) {
        if (!begun_) {
            const auto lane =
                std::find_if(lanes_.begin(), lanes_.end(), [](const LaneQueue& each) { return !each.frames.empty(); });
            if (lane == lanes_.end()) break;
            begun_ = std::move(lane->frames.front().frame);
            begun_at_ = 0;
            lane->bytes -= begun_->size();
            lane->frames.pop_front();
        }
        const std::size_t part = std::min(room, begun_->size() - begun_at_);
        out.append(*begun_, begun_at_, part);
        begun_at_ += part;
        room -= part;
        if (begun_at_ == begun_->size()) begun_.reset();
    }
    const std::size_t sent = out.size() - before;
    if (sent > 0) waiting_since_ = now;
    counts_.sent_bytes += sent;
    if (rate_ > 0.0) tokens_ -= static_cast<double>(sent);
    judge(now);
}

void SendQueue::refill(Timestamp now) {
    if (rate_ <= 0.0) return;
    tokens_ = std::min(burst_s * rate_, tokens_ + rate_ * std::max(0.0, secondsBetween(refilled_, now)));
    refilled_ = now;
}

/// How long the oldest frame waits that should not.
Microseconds SendQueue::delay(Timestamp now) const {
    Microseconds longest{0};
    for (const LaneQueue& lane : lanes_)
        if (!lane.frames.empty() && &lane != &lanes_.back())
            longest = std::max(longest, std::chrono::duration_cast<Microseconds>(now - lane.frames.front().since));
    return longest;
}

void SendQueue::judge(Timestamp now) {
    const Microseconds waits = delay(now);
    if (waits >= quick) last_delay_ = now;
    if (waits > slow && now - level_changed_ > before_less && level_ < NoPicture) {
        level_ = static_cast<Level>(level_ + 1);
        level_changed_ = now;
    } else if (level_ > Everything && now - std::max(last_delay_, level_changed_) > before_more) {
        level_ = static_cast<Level>(level_ - 1);
        level_changed_ = now;
    }
    for (const Lane lane : {Lane::Regions, Lane::Particles, Lane::Picture}) {
        LaneQueue& queue = laneOf(lane);
        if (!allows(lane, level_)) dropAll(queue);
        while (!queue.frames.empty() && now - queue.frames.front().since > worthless) dropOldest(queue);
    }
}

bool SendQueue::spend(std::size_t bytes, Timestamp now) {
    refill(now);
    if (rate_ <= 0.0) return true;
    if (tokens_ <= 0.0) {
        ++counts_.left_out;
        return false;
    }
    tokens_ -= static_cast<double>(bytes);
    counts_.sent_bytes += bytes;
    return true;
}

void SendQueue::dropOldest(LaneQueue& lane) {
    ++counts_.left_out;
    lane.bytes -= lane.frames.front().frame->size();
    lane.frames.pop_front();
}

void SendQueue::dropAll(LaneQueue& lane) {
    counts_.left_out += lane.frames.size();
    lane = {};
}

void SendQueue::clear() {
    for (LaneQueue& lane : lanes_)
        if (&lane != &lanes_.back()) dropAll(lane);
}

std::size_t SendQueue::waitingBytes() const {
    std::size_t bytes = begun_ ? begun_->size() - begun_at_ : 0;
    for (const LaneQueue& lane : lanes_) bytes += lane.bytes;
    return bytes;
}

Microseconds SendQueue::stuckFor(Timestamp now) const {
    return empty() ? Microseconds{0} : std::chrono::duration_cast<Microseconds>(now - waiting_since_);
}

}  // namespace echotrail
