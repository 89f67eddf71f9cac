#pragma once

#include "core/data/source.hpp"

#include <chrono>
#include <ostream>
#include <vector>

namespace echotrail {

/// Takes the time of every ping, and shows how far a long run has come where someone sits before a terminal.
class ReplayProgress {
public:
    /// With `keep_each` the times of all pings are kept, for tellTimings().
    ReplayProgress(const SourceInfo& source, bool keep_each);
    ~ReplayProgress();
    ReplayProgress(const ReplayProgress&) = delete;
    ReplayProgress& operator=(const ReplayProgress&) = delete;

    void begin();
    void end(Timestamp ping);

    double processingSeconds() const { return processing_s_; }  ///< CPU time of this thread between begin and end
    void tellTimings(std::ostream& out) const;

private:
    void show(Timestamp ping);

    Timestamp start_, end_;
    bool keep_each_;
    bool terminal_;
    bool shown_ = false;
    double begun_s_ = 0.0, processing_s_ = 0.0;
    std::vector<double> each_s_;
    std::chrono::steady_clock::time_point last_shown_ = std::chrono::steady_clock::now();
};

}  // namespace echotrail
