#include "core/runtime/run_timeline.hpp"

#include "core/data/event.hpp"
#include "core/recording/log_format.hpp"
#include "core/recording/update_text.hpp"

#include <set>
#include <utility>

namespace echotrail {
namespace {

constexpr std::chrono::seconds longest_rhythm{2};  ///< between pings, beyond the second that each stands for
constexpr std::size_t most_looks = 100;            ///< in a second: no tracker follows more
constexpr std::chrono::hours other_time{24};       ///< a clock that was set by more tells of another run

std::int64_t secondNumber(Timestamp time) {
    return std::chrono::floor<std::chrono::seconds>(time).time_since_epoch().count();
}

/// Which tracks are followed, as far as the recording tells: until it tells otherwise.
void takeLooks(std::set<int>& followed, const std::map<int, bool>& looks) {
    for (const auto& [track, is] : looks) {
        if (is)
            followed.insert(track);
        else
            followed.erase(track);
    }
}

}  // namespace

RunTimeline::Second& RunTimeline::secondOf(Timestamp time) {
    const auto [second, is_new] = seconds_.try_emplace(secondNumber(time));
    if (is_new) second->second.first = time;
    second->second.first = std::min(second->second.first, time);
    changed_ |= is_new;
    return second->second;
}

void RunTimeline::see(Timestamp ping, std::uint64_t sweep, bool followed) {
    if (started_ && (ping - last_ > other_time || last_ - ping > other_time)) *this = {};
    Second& second = secondOf(ping);
    second.seen = true;
    second.sweep_began |= started_ && sweep != sweep_;
    second.followed |= followed;
    started_ = true;
    sweep_ = sweep;
    last_ = std::max(last_, ping);
    if (seconds_.size() <= most_seconds) return;
    looks_.erase(seconds_.begin()->first);
    seconds_.erase(seconds_.begin());
}

void RunTimeline::recall(const LogRows& rows) {
    for (const LogRow& row : rows.rows) {
        const Timestamp time{Microseconds(row.numbers[rows.table == LogTable::Events ? 2 : 1])};
        // What lies farther away is of another run, or damaged; and the edge of what is seen is still to come.
        if (!started_ || time > last_ || time < last_ - std::chrono::seconds(most_seconds)) continue;
        if (const auto known = seconds_.find(secondNumber(time)); known != seconds_.end() && known->second.seen)
            continue;
        if (rows.table == LogTable::Results)
            recallResult(row);
        else if (row.numbers[1] == static_cast<std::int64_t>(EventKind::SonarBytes))
            secondOf(time);
    }
}

void RunTimeline::recallResult(const LogRow& row) {
    if (row.numbers[0] != static_cast<std::int64_t>(UpdateKind::Track)) return;
    const auto look = lookStateFrom({reinterpret_cast<const char*>(row.payload.data()), row.payload.size()});
    if (!look) return;
    const Timestamp time{Microseconds(row.numbers[1])};
    secondOf(time);
    auto& looks = looks_[secondNumber(time)];
    if (looks.size() >= most_looks && !looks.contains(look->track)) return;
    looks[look->track] = isFollowed(look->state);
    changed_ = true;
}

Timeline RunTimeline::summary() {
    changed_ = false;
    Timeline made;
    std::vector<Timestamp> times;
    times.reserve(seconds_.size() + 1);
    std::set<int> followed;
    std::uint64_t index = 0;
    for (const auto& [number, second] : seconds_) {
        if (!times.empty() && second.first - times.back() > longest_rhythm + std::chrono::seconds(1))
            made.gaps.push_back({index - 1, index});
        times.push_back(second.first);
        if (second.seen)
            followed.clear();
        else if (const auto looks = looks_.find(number); looks != looks_.end())
            takeLooks(followed, looks->second);
        extendTimeline(made, index, second.sweep_began, second.seen ? second.followed : !followed.empty());
        if (!second.seen) extendSpans(made.recalled, index);
        ++index;
    }
    if (!times.empty() && last_ > times.back()) times.push_back(last_);
    made.analysed = times.size();
    made.ping_times = std::make_shared<const std::vector<Timestamp>>(std::move(times));
    return made;
}

}  // namespace echotrail
