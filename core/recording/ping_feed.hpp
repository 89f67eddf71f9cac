#pragma once

#include "core/data/event.hpp"
#include "core/data/source.hpp"
#include "core/navigation/navigation_stream.hpp"
#include "core/seanet/ping_receiver.hpp"

#include <deque>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace echotrail {

/// The payload of EventKind::Designation, and back; nothing for a text that is none.
std::string designationText(const RunControl& designation);
std::optional<RunControl> designationFrom(std::string_view text);
/// The same of EventKind::Drop.
std::string dropText(const RunControl& drop);
std::optional<RunControl> dropFrom(std::string_view text);

/// From the numbered events of a run to its pings, in one way for a live run and for its recording, so that both see
/// the same pings with the same poses and the same controls before them.
/// With navigation a ping is held until the poses reach the moment its last echo came back, or until none can be
/// expected any more: `longest_gap_s` longer by the events' monotonic time.
/// Order: take() events as they are numbered; after each, next() until it gives nothing; at the end finish(), next().
class PingFeed {
public:
    PingFeed(double sound_speed_mps, double longest_gap_s, std::set<std::uint64_t> skips = {});

    void take(const Event& event);
    /// No event follows: what was held is given.
    void finish();
    std::optional<Ping> next();
    /// What takes effect before the ping that next() gave last; each is given once.
    std::vector<RunControl> takeControls() { return std::exchange(controls_, {}); }
    void setSoundSpeed(double mps) { receiver_.setSoundSpeed(mps); }
    void setLongestGap(double seconds) { longest_gap_s_ = seconds; }

    const PoseHistory& navigation() const { return navigation_.poses(); }
    const NavigationStatus& navigationStatus() const { return navigation_.status(); }
    bool navigationExpected() const { return navigation_expected_; }
    SourceCounts counts() const;
    std::uint64_t skippedPings() const { return skipped_; }

private:
    struct Held {
        Ping ping;
        Microseconds received{0};  ///< monotonic
    };
    bool isReady(const Held& held) const;
    void takeControl(std::optional<RunControl> control);

    seanet::PingReceiver receiver_;
    NavigationStream navigation_;
    bool navigation_expected_ = false;
    double longest_gap_s_;
    std::set<std::uint64_t> skips_;
    std::deque<std::variant<Held, RunControl>> queue_;
    std::vector<RunControl> controls_;
    Microseconds now_{0};
    bool finished_ = false;
    std::uint64_t skipped_ = 0;
    std::uint64_t bad_controls_ = 0;
};

}  // namespace echotrail
