#include "replay_progress.hpp"

#include "core/runtime/processor_time.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace echotrail {

ReplayProgress::ReplayProgress(const SourceInfo& source, bool keep_each)
    : start_(source.start), end_(source.end), keep_each_(keep_each), terminal_(isatty(STDERR_FILENO) == 1) {}

ReplayProgress::~ReplayProgress() {
    if (shown_) std::fputs("\r\033[K", stderr);
}

void ReplayProgress::begin() { begun_s_ = processorSeconds(); }

void ReplayProgress::end(Timestamp ping) {
    const double took = processorSeconds() - begun_s_;
    processing_s_ += took;
    if (keep_each_) each_s_.push_back(took);
    if (terminal_) show(ping);
}

void ReplayProgress::show(Timestamp ping) {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_shown_ < std::chrono::milliseconds(500)) return;
    last_shown_ = now;
    shown_ = true;
    const double whole = std::max(secondsBetween(start_, end_), 1e-6);
    std::fprintf(stderr, "\r%3.0f %%, %.0f s of %.0f s", 100.0 * secondsBetween(start_, ping) / whole,
                 secondsBetween(start_, ping), whole);
}

void ReplayProgress::tellTimings(std::ostream& out) const {
    if (each_s_.empty()) return;
    std::vector<double> sorted = each_s_;
    std::sort(sorted.begin(), sorted.end());
    const auto ms = [&](double share) {
        return 1e3 * sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
    };
    char text[200];
    std::snprintf(
        text, sizeof text,
        "ping to track, CPU time: median %.4f ms, 99 %% below %.4f ms, longest %.4f ms; %.0f times real time\n",
        ms(0.5), ms(0.99), ms(1.0), secondsBetween(start_, end_) / std::max(processing_s_, 1e-9));
    out << text;
}

}  // namespace echotrail
