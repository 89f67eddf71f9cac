#include "core/simulation/link_faults.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace echotrail {

using namespace std::chrono_literals;

namespace {

constexpr std::uint64_t fault_numbers = 0x4C696E6B;  // the streams of this purpose, apart from all others
constexpr Microseconds longest_join = 50ms;          // a read that waits for another does not wait longer
constexpr std::size_t longest_garbage = 64;

RandomStream stream(std::uint64_t seed, std::uint64_t index) { return {seed, fault_numbers, index}; }

}  // namespace

LinkFaults::LinkFaults(const LinkFaultParams& params, std::uint64_t seed)
    : params_(params),
      bytes_(stream(seed, 0)),
      reads_(stream(seed, 1)),
      processes_{Process{stream(seed, 2), params.garbage_rate, {}}, Process{stream(seed, 3), params.stall_rate, {}},
                 Process{stream(seed, 4), params.disconnect_rate, {}},
                 Process{stream(seed, 5), params.reboot_rate, {}}} {
    for (std::size_t event = 0; event < events; ++event) schedule(static_cast<Event>(event), 0us);
}

void LinkFaults::schedule(Event event, Microseconds after) {
    Process& process = processes_[event];
    if (process.rate <= 0.0) return;
    process.next = after + microsecondsFromSeconds(-std::log(process.random.uniform()) / process.rate) + 1us;
}

std::optional<Microseconds> LinkFaults::deadline() const {
    std::optional<Microseconds> next;
    const auto consider = [&](const std::optional<Microseconds>& at) {
        if (at && (!next || *at < *next)) next = at;
    };
    for (const Process& process : processes_) consider(process.next);
    consider(up_at_);
    consider(release_at_);
    if (!output_.empty()) consider(output_.front().at);
    return next;
}

void LinkFaults::tick(Microseconds now) {
    const auto due = [&](const std::optional<Microseconds>& at, Microseconds until) { return at && *at <= until; };
    for (;;) {
        std::optional<Event> earliest;
        for (std::size_t event = 0; event < events; ++event)
            if (processes_[event].next && (!earliest || *processes_[event].next < *processes_[*earliest].next))
                earliest = static_cast<Event>(event);
        const Microseconds until = earliest ? std::min(now, *processes_[*earliest].next) : now;
        if (due(release_at_, until)) {
            release(*release_at_);
        } else if (due(up_at_, until)) {
            put(LinkHappening::Kind::Up, *std::exchange(up_at_, std::nullopt));
        } else if (earliest && due(processes_[*earliest].next, now)) {
            happen(*earliest, *std::exchange(processes_[*earliest].next, std::nullopt));
        } else {
            return;
        }
    }
}

void LinkFaults::happen(Event event, Microseconds at) {
    RandomStream& random = processes_[event].random;
    schedule(event, at);
    switch (event) {
        case Garbage: {
            std::vector<std::uint8_t> bytes(1 + random.bits() % longest_garbage);
            for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.bits());
            if (down()) return;
            count("garbage");
            return deliver(at, bytes);
        }
        case Stall:
            stalled_until_ = std::max(stalled_until_, at + microsecondsFromSeconds(params_.stall_s * random.uniform()));
            if (release_at_) release_at_ = stalled_until_;
            return count("stall");
        case Disconnect: {
            const Microseconds lasts = microsecondsFromSeconds(params_.disconnect_s * random.uniform());
            if (down()) return;
            count("disconnect");
            count("lost_while_down", waiting_.size());
            waiting_.clear();
            release_at_.reset();
            stalled_until_ = at;
            up_at_ = at + lasts;
            return put(LinkHappening::Kind::Down, at);
        }
        case Reboot:
            count("reboot");
            return put(LinkHappening::Kind::Reboot, at);
        case events:
            break;
    }
}

void LinkFaults::send(Microseconds at, std::span<const std::uint8_t> bytes) {
    tick(at);
    if (down()) return count("lost_while_down", bytes.size());
    deliver(at, damaged(bytes));
}

std::vector<std::uint8_t> LinkFaults::damaged(std::span<const std::uint8_t> bytes) {
    std::vector<std::uint8_t> result;
    result.reserve(bytes.size());
    const double corrupted = params_.corrupted_bytes, lost = corrupted + params_.lost_bytes;
    const double doubled = lost + params_.doubled_bytes;
    if (doubled <= 0.0) return {bytes.begin(), bytes.end()};
    for (const std::uint8_t byte : bytes) {
        const double fate = bytes_.uniform();
        if (fate < corrupted) {
            count("corrupted");
            result.push_back(static_cast<std::uint8_t>(byte ^ (1 + bytes_.bits() % 255)));  // never as it was
        } else if (fate < lost) {
            count("lost");
        } else {
            result.push_back(byte);
            if (fate >= doubled) continue;
            count("doubled");
            result.push_back(byte);
        }
    }
    return result;
}

void LinkFaults::deliver(Microseconds at, std::span<const std::uint8_t> bytes) {
    if (bytes.empty()) return;
    waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
    if (at < stalled_until_) {
        release_at_ = stalled_until_;
    } else if (chance(params_.joined_reads)) {
        count("joined");
        if (!release_at_) release_at_ = at + longest_join;
    } else {
        release(at);
    }
}

void LinkFaults::release(Microseconds at) {
    release_at_.reset();
    std::vector<std::uint8_t> read = std::exchange(waiting_, {});
    if (read.size() > 1 && chance(params_.split_reads)) {
        count("split");
        const auto middle = read.begin() + 1 + static_cast<std::ptrdiff_t>(reads_.bits() % (read.size() - 1));
        put(LinkHappening::Kind::Read, at, {read.begin(), middle});
        read.erase(read.begin(), middle);
    }
    put(LinkHappening::Kind::Read, at, std::move(read));
}

void LinkFaults::put(LinkHappening::Kind kind, Microseconds at, std::vector<std::uint8_t> bytes) {
    output_.push_back({kind, at, std::move(bytes)});
}

std::vector<LinkHappening> LinkFaults::takeOutput(Microseconds now) {
    tick(now);
    std::vector<LinkHappening> out;
    for (; !output_.empty() && output_.front().at <= now; output_.pop_front())
        out.push_back(std::move(output_.front()));
    return out;
}

}  // namespace echotrail
