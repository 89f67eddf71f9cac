#include "core/navigation/navigation_stream.hpp"

#include "core/navigation/nmea.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace echotrail {
namespace {

constexpr std::size_t longest_line = 1024;         // ten times what the standard allows
constexpr Microseconds longest_bridge{2'000'000};  // between neighbours that are interpolated; longer is a gap
constexpr Microseconds kept_poses{600'000'000};    // far more than a ping ever waits for one
constexpr Microseconds longest_wait{10'000'000};   // of a heading for a position, or the other way round

LocalPosition blend(const LocalPosition& a, const LocalPosition& b, double u) {
    return {a.north_m + u * (b.north_m - a.north_m), a.east_m + u * (b.east_m - a.east_m)};
}
Bearing blend(Bearing a, Bearing b, double u) { return a + u * (b - a); }

/// The two samples about `time`, which the series must cover, and how far it lies between them.
template <class Series>
auto around(const Series& series, Timestamp time) {
    assert(!series.empty() && series.front().time <= time && time <= series.back().time);
    const auto after =
        std::find_if(series.begin(), series.end(), [&](const auto& sample) { return sample.time >= time; });
    const auto before = after->time == time ? after : std::prev(after);
    const double span_s = secondsBetween(before->time, after->time);
    return std::tuple{*before, *after, span_s > 0.0 ? secondsBetween(before->time, time) / span_s : 0.0};
}

/// Drops what no later moment needs: all but the last sample at or before `time`.
template <class Series>
void prune(Series& series, Timestamp time) {
    while (series.size() > 1 && series[1].time <= time) series.pop_front();
}

/// Adds a sample; after a gap the series begins anew, so that nothing is interpolated across.
template <class Series, class Sample>
bool append(Series& series, const Sample& sample) {
    if (!series.empty() && sample.time <= series.back().time) return false;
    if (!series.empty() && sample.time - series.back().time > longest_bridge) series.clear();
    series.push_back(sample);
    return true;
}

/// The kind that came first is the one that is used.
bool isChosen(std::string& chosen, const std::string& id) {
    if (chosen.empty()) chosen = id;
    return chosen == id;
}

}  // namespace

void NavigationStream::take(Timestamp arrival, std::span<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) {
        if (byte == '\n') {
            takeLine(arrival);
        } else if (line_.size() == longest_line) {
            line_too_long_ = true;
        } else {
            line_.push_back(static_cast<char>(byte));
        }
    }
}

void NavigationStream::linkChanged() {
    if (!line_.empty()) reject(nmea_cause::malformed);
    line_.clear();
    line_too_long_ = false;
}

void NavigationStream::takeLine(Timestamp arrival) {
    const std::string line = std::move(line_);
    line_.clear();
    if (std::exchange(line_too_long_, false)) return reject(nmea_cause::malformed);
    if (line.find_first_not_of(" \r") == std::string::npos) return;
    const auto sentence = parseNmeaLine(line);
    if (!sentence) return reject(sentence.error());
    const Timestamp time = sentence->time.value_or(arrival);
    const std::string& id = sentence->id;
    if (id == "HDT" || id == "HDG") return takeHeading(*sentence, time);
    if (id == "RMC" || id == "GGA") return takeFix(*sentence, time);
    if (id == "VTG" || id == "VBW") return takeSpeed(*sentence, time);
    if (id == "DPT" || id == "DBT") return takeDepth(*sentence);
    ++status_.unused[id];
}

void NavigationStream::takeHeading(const NmeaSentence& sentence, Timestamp time) {
    const bool is_true = sentence.id == "HDT";
    if (!is_true && status_.heading_kind == "HDT") {
        ++status_.unused[sentence.id];
        return;
    }
    const auto reading = readHeading(sentence);
    if (!reading) return reject(reading.error());
    if (!append(headings_, TimedHeading{time, reading->heading})) return reject(nmea_cause::out_of_order);
    status_.heading_kind = is_true ? "HDT" : reading->magnetic ? "HDG, magnetic" : "HDG";
    status_.heading_time = time;
    status_.heading = reading->heading;
    ++status_.used[sentence.id];
    emitCovered();
}

void NavigationStream::takeFix(const NmeaSentence& sentence, Timestamp time) {
    const auto fix = readPosition(sentence);
    if (!fix) return reject(fix.error());
    if (!isChosen(fix_kind_, sentence.id)) {
        ++status_.unused[sentence.id];
        return;
    }
    if (fix_time_ && time <= *fix_time_) return reject(nmea_cause::out_of_order);
    if (!status_.plane) status_.plane.emplace(*fix, place_);
    place_ = status_.plane->toLocal(*fix);
    place_time_ = fix_time_ = time;
    status_.position_kind = sentence.id;
    ++status_.used[sentence.id];
    addPosition(time);
}

void NavigationStream::takeSpeed(const NmeaSentence& sentence, Timestamp time) {
    const auto speed = readVelocity(sentence);
    if (!speed) return reject(speed.error());
    const bool has_heading = status_.heading_time && std::chrono::abs(time - *status_.heading_time) <= longest_bridge;
    if (!isChosen(speed_kind_, sentence.id) || (speed->along_vehicle && !has_heading)) {
        ++status_.unused[sentence.id];
        return;
    }
    if (place_time_ && time < *place_time_) return reject(nmea_cause::out_of_order);
    const double turn = speed->along_vehicle ? status_.heading->inRadians() : 0.0;
    const double c = std::cos(turn), s = std::sin(turn);
    const LocalPosition velocity{c * speed->north_or_ahead_mps - s * speed->east_or_starboard_mps,
                                 s * speed->north_or_ahead_mps + c * speed->east_or_starboard_mps};
    if (place_time_ && time - *place_time_ <= longest_bridge) {
        const LocalPosition mean = blend(velocity_.value_or(velocity), velocity, 0.5);
        const double passed_s = secondsBetween(*place_time_, time);
        place_.north_m += mean.north_m * passed_s;
        place_.east_m += mean.east_m * passed_s;
    }
    velocity_ = velocity;
    place_time_ = time;
    ++status_.used[sentence.id];
    if (fix_time_ && time - *fix_time_ <= longest_bridge) return;  // fixes are there: they say it better
    status_.position_kind = sentence.id;
    addPosition(time);
}

void NavigationStream::takeDepth(const NmeaSentence& sentence) {
    const auto depth = readDepth(sentence);
    if (!depth) return reject(depth.error());
    status_.depth_m = *depth;
    ++status_.used[sentence.id];
}

void NavigationStream::addPosition(Timestamp time) {
    // A fix and a speed may come at one moment: the later word counts, for what is not said yet.
    if (!positions_.empty() && positions_.back().time == time)
        positions_.back().position = place_;
    else if (!append(positions_, TimedPosition{time, place_}))
        return reject(nmea_cause::out_of_order);
    status_.position_time = time;
    emitCovered();
}

/// A pose at every time of a heading or a position that both series have reached, the other interpolated.
void NavigationStream::emitCovered() {
    if (headings_.empty()) return;
    const bool heading_only = status_.position_kind.empty();
    if (!heading_only && positions_.empty()) return;
    const Timestamp from =
        heading_only ? headings_.front().time : std::max(headings_.front().time, positions_.front().time);
    const Timestamp until =
        heading_only ? headings_.back().time : std::min(headings_.back().time, positions_.back().time);
    std::vector<Timestamp> times;
    const auto collect = [&](const auto& series) {
        for (const auto& sample : series)
            if (sample.time >= from && sample.time <= until && (!reached_ || sample.time > *reached_))
                times.push_back(sample.time);
    };
    collect(headings_);
    collect(positions_);
    std::ranges::sort(times);
    const auto doubled = std::ranges::unique(times);
    times.erase(doubled.begin(), doubled.end());
    for (const Timestamp time : times) {
        const auto [h0, h1, u] = around(headings_, time);
        LocalPosition place;
        if (!heading_only) {
            const auto [p0, p1, v] = around(positions_, time);
            place = blend(p0.position, p1.position, v);
        }
        poses_.add({time, {place.north_m, place.east_m, blend(h0.heading, h1.heading, u)}});
        reached_ = time;
    }
    if (reached_) poses_.forgetBefore(*reached_ - kept_poses);
    // Where one series stands still, the other waits for it, but not for ever.
    prune(headings_, std::max(until, headings_.back().time - longest_wait));
    if (!positions_.empty()) prune(positions_, std::max(until, positions_.back().time - longest_wait));
}

}  // namespace echotrail
