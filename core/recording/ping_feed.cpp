#include "core/recording/ping_feed.hpp"

#include "core/data/head_settings.hpp"

#include <charconv>
#include <cmath>

namespace echotrail {
namespace {

std::string textOf(const Event& event) { return {event.payload.begin(), event.payload.end()}; }

std::optional<double> numberAt(std::string_view& text) {
    double value = 0.0;
    const auto [stop, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc() || !std::isfinite(value)) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
    return value;
}

std::string placeText(const RunControl& control) {
    return ParameterInfo::toText(control.range_m) + " " + ParameterInfo::toText(control.from_bow.inDegrees());
}

/// `control` with the place that is all of the text.
std::optional<RunControl> placeFrom(std::string_view text, RunControl control) {
    const auto range = numberAt(text);
    if (!range || *range < 0.0 || text.empty() || text.front() != ' ') return std::nullopt;
    text.remove_prefix(1);
    const auto bearing = numberAt(text);
    if (!bearing || !text.empty()) return std::nullopt;
    control.range_m = *range;
    control.from_bow = Bearing::degrees(*bearing);
    return control;
}

}  // namespace

std::string designationText(const RunControl& designation) {
    return designation.kind == RunControl::Kind::ClearDesignation ? std::string() : placeText(designation);
}

std::optional<RunControl> designationFrom(std::string_view text) {
    if (text.empty()) return RunControl{.kind = RunControl::Kind::ClearDesignation};
    return placeFrom(text, {.kind = RunControl::Kind::Designation});
}

std::string dropText(const RunControl& drop) {
    const std::string track = std::to_string(drop.track);
    if (drop.kind == RunControl::Kind::Restore) return track;
    return track + " " + placeText(drop);
}

std::optional<RunControl> dropFrom(std::string_view text) {
    RunControl control{.kind = RunControl::Kind::Restore};
    const auto [stop, failure] = std::from_chars(text.data(), text.data() + text.size(), control.track);
    if (failure != std::errc() || control.track <= 0) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
    if (text.empty()) return control;
    if (text.front() != ' ') return std::nullopt;
    control.kind = RunControl::Kind::Drop;
    return placeFrom(text.substr(1), control);
}

PingFeed::PingFeed(double sound_speed_mps, double longest_gap_s, std::set<std::uint64_t> skips)
    : receiver_(sound_speed_mps), longest_gap_s_(longest_gap_s), skips_(std::move(skips)) {}

void PingFeed::take(const Event& event) {
    now_ = event.monotonic;
    const auto hold = [&](Ping&& ping) { queue_.emplace_back(Held{std::move(ping), event.monotonic}); };
    switch (event.kind) {
        case EventKind::SonarBytes:
            receiver_.take(event.utc, event.payload, hold);
            break;
        case EventKind::SonarLink:
            receiver_.reset(hold);
            break;
        case EventKind::NavigationBytes:
            navigation_expected_ = true;
            navigation_.take(event.utc, event.payload);
            break;
        case EventKind::NavigationLink:
            navigation_expected_ = true;
            navigation_.linkChanged();
            break;
        case EventKind::Parameters: {
            const std::string text = textOf(event);
            HeadSettings head;
            if (!applyRecordedParameters(head, text)) {
                ++bad_controls_;
                break;
            }
            receiver_.setSoundSpeed(head.sound_speed);
            queue_.emplace_back(RunControl{.kind = RunControl::Kind::Parameters, .parameters = text});
            break;
        }
        case EventKind::Designation:
            takeControl(designationFrom(textOf(event)));
            break;
        case EventKind::Drop:
            takeControl(dropFrom(textOf(event)));
            break;
        case EventKind::SentBytes:
        case EventKind::Skip:
        case EventKind::Annotation:
            break;  // change nothing
    }
}

void PingFeed::takeControl(std::optional<RunControl> control) {
    if (control)
        queue_.emplace_back(*std::move(control));
    else
        ++bad_controls_;
}

void PingFeed::finish() {
    finished_ = true;
    receiver_.finish([&](Ping&& ping) { queue_.emplace_back(Held{std::move(ping), now_}); });
}

bool PingFeed::isReady(const Held& held) const {
    if (!navigation_expected_ || finished_) return true;
    const double flight_s = held.ping.bin_interval_s * static_cast<double>(held.ping.levels.size());
    const auto reached = navigation_.reachedUntil();
    if (reached && *reached >= held.ping.time + microsecondsFromSeconds(flight_s)) return true;
    return now_ > held.received + microsecondsFromSeconds(longest_gap_s_);
}

std::optional<Ping> PingFeed::next() {
    while (!queue_.empty()) {
        if (auto* control = std::get_if<RunControl>(&queue_.front())) {
            controls_.push_back(std::move(*control));
            queue_.pop_front();
            continue;
        }
        Held& held = std::get<Held>(queue_.front());
        if (!isReady(held)) return std::nullopt;
        Ping ping = std::move(held.ping);
        queue_.pop_front();
        if (skips_.contains(ping.sequence)) {
            ++skipped_;
            continue;
        }
        return ping;
    }
    return std::nullopt;
}

SourceCounts PingFeed::counts() const {
    SourceCounts counts = receiver_.counts();
    if (bad_controls_ > 0) counts.rejected["bad_control"] += bad_controls_;
    return counts;
}

}  // namespace echotrail
