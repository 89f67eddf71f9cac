#pragma once

#include "core/base/parameters.hpp"
#include "core/base/random.hpp"
#include "core/base/time.hpp"

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace echotrail {

/// How bad a link is; without faults by default.
struct LinkFaultParams {
    double corrupted_bytes = 0.0;
    double lost_bytes = 0.0;
    double doubled_bytes = 0.0;
    double split_reads = 0.0;
    double joined_reads = 0.0;
    double garbage_rate = 0.0;
    double stall_rate = 0.0;
    double stall_s = 2.0;
    double disconnect_rate = 0.0;
    double disconnect_s = 3.0;
    double reboot_rate = 0.0;
};

template <>
struct Described<LinkFaultParams> {
    using P = LinkFaultParams;
    static constexpr std::string_view group = "Faults of a simulated link";
    static constexpr auto fields = std::tuple{
        Field{&P::corrupted_bytes, "corrupted_bytes", "", 0, 0.3, "Part of all bytes that arrive as another value"},
        Field{&P::lost_bytes, "lost_bytes", "", 0, 0.3, "Part of all bytes that do not arrive"},
        Field{&P::doubled_bytes, "doubled_bytes", "", 0, 0.3, "Part of all bytes that arrive twice"},
        Field{&P::split_reads, "split_reads", "", 0, 1, "Part of all reads that arrive as two"},
        Field{&P::joined_reads, "joined_reads", "", 0, 1, "Part of all reads that wait for the next one"},
        Field{&P::garbage_rate, "garbage_rate", "1/s", 0, 100, "Bursts of up to 64 random bytes"},
        Field{&P::stall_rate, "stall_rate", "1/s", 0, 10, "Times at which the link stands still"},
        Field{&P::stall_s, "stall_s", "s", 0, 60, "Longest time that it then stands still; what waited comes at once"},
        Field{&P::disconnect_rate, "disconnect_rate", "1/s", 0, 10, "Times at which the link breaks"},
        Field{&P::disconnect_s, "disconnect_s", "s", 0, 60, "Longest time until it is there again"},
        Field{&P::reboot_rate, "reboot_rate", "1/s", 0, 10, "Times at which the device starts anew"}};
};

/// What comes out of a faulty link.
struct LinkHappening {
    enum class Kind { Read, Down, Up, Reboot };
    Kind kind = Kind::Read;
    Microseconds at{};
    std::vector<std::uint8_t> bytes;  ///< of a read
};

/// One way of a link whose bytes get damaged, wait, or are lost; without any fault every read comes out as it went in.
/// Single faults (per byte and read) and events (a Poisson process for each kind) draw from streams of their own: the
/// rate of one changes nothing about the others. All depends on the seed, and the bytes with their times, alone.
/// Calls in order of time; it begins, up, at 0. State: bytes that wait for the end of a stall or the next read.
class LinkFaults {
public:
    LinkFaults(const LinkFaultParams& params, std::uint64_t seed);

    void send(Microseconds at, std::span<const std::uint8_t> bytes);
    /// Lets all happen that is due.
    void tick(Microseconds now);
    /// What has come out by `now`, in order; the owner breaks the connection, or starts the device anew, as it says.
    std::vector<LinkHappening> takeOutput(Microseconds now);
    /// When something happens next by itself.
    std::optional<Microseconds> deadline() const;

    bool down() const { return up_at_.has_value(); }
    /// Cause → how many faults there were (bytes, of "corrupted", "lost", "doubled" and "lost_while_down").
    const std::map<std::string, std::uint64_t>& counts() const { return counts_; }

private:
    enum Event : std::size_t { Garbage, Stall, Disconnect, Reboot, events };
    struct Process {
        RandomStream random;
        double rate = 0.0;  ///< 1/s
        std::optional<Microseconds> next;
    };
    void schedule(Event event, Microseconds after);
    void happen(Event event, Microseconds at);
    std::vector<std::uint8_t> damaged(std::span<const std::uint8_t> bytes);
    void deliver(Microseconds at, std::span<const std::uint8_t> bytes);
    void release(Microseconds at);
    void put(LinkHappening::Kind kind, Microseconds at, std::vector<std::uint8_t> bytes = {});
    bool chance(double part) { return part > 0.0 && reads_.uniform() < part; }
    void count(const char* cause, std::uint64_t number = 1) { counts_[cause] += number; }

    LinkFaultParams params_;
    RandomStream bytes_, reads_;
    std::array<Process, events> processes_;
    std::optional<Microseconds> up_at_;       ///< while it is down
    std::optional<Microseconds> release_at_;  ///< of what waits
    Microseconds stalled_until_{};
    std::vector<std::uint8_t> waiting_;
    std::deque<LinkHappening> output_;
    std::map<std::string, std::uint64_t> counts_;
};

}  // namespace echotrail
