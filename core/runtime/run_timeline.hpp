#pragma once

#include "core/data/log_rows.hpp"
#include "core/runtime/timeline.hpp"

#include <cstdint>
#include <map>
#include <vector>

namespace echotrail {

/// The time line of a run while it lasts, second by second: what was seen here, and, of seconds that were not, what the
/// recording of the run tells, whose rows come afterwards and in any order.
class RunTimeline {
public:
    void see(Timestamp ping, std::uint64_t sweep, bool followed);
    /// Rows of an Echotrail log, which are not trusted: those that cannot be read say nothing.
    void recall(const LogRows& rows);
    /// Whether there is more than at the last summary().
    bool changed() const { return changed_; }

    /// A "ping" of it stands for a second: the first ping of each, and the last of all.
    Timeline summary();

    static constexpr std::size_t most_seconds = 3 * 24 * 3600;  ///< older ones are forgotten

private:
    struct Second {
        Timestamp first{};
        bool seen = false;  ///< here; else only the recording knows it
        bool sweep_began = false;
        bool followed = false;  ///< of one that was seen
    };
    Second& secondOf(Timestamp time);
    void recallResult(const LogRow& row);

    std::map<std::int64_t, Second> seconds_;
    /// In seconds that were not seen: tracks, and whether they were followed then.
    std::map<std::int64_t, std::map<int, bool>> looks_;
    Timestamp last_{};
    std::uint64_t sweep_ = 0;
    bool started_ = false, changed_ = false;
};

}  // namespace echotrail
