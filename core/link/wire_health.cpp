#include "core/link/link_limits.hpp"
#include "core/link/wire_values.hpp"

#include <cmath>

namespace echotrail {
namespace {

constexpr std::uint32_t last_head_state = 7, last_disk_state = 2;

/// Paths and reasons come from elsewhere.
std::string shown(const std::string& text) { return cleanText(text, link_limits::longest_text); }

void writeEnd(const LinkEnd& end, wire::LinkEnd& out) {
    out.set_up(end.up);
    out.set_reason(shown(end.reason));
    out.set_age_s(end.age_s.value_or(-1.0));
}

std::optional<LinkEnd> readEnd(const wire::LinkEnd& in) {
    if (!isSane(in.age_s())) return std::nullopt;
    LinkEnd end{in.up(), cleanText(in.reason(), link_limits::longest_text), {}};
    if (in.age_s() >= 0.0) end.age_s = in.age_s();
    return end;
}

/// 0 stands for none.
bool readOptional(std::int64_t us, std::optional<Timestamp>& out) {
    if (us == 0) return true;
    out = timeFrom(us);
    return out.has_value();
}

void writeHead(const LinkHealth& health, wire::Health& out) {
    out.set_head_state(health.head_state);
    out.set_head(shown(health.head));
    out.set_head_advice(shown(health.head_advice));
    out.set_head_difference(shown(health.head_difference));
    for (const NamedValue& value : health.head_confirmed) write(value, *out.add_head_confirmed());
    out.set_head_pings(health.head_pings);
    out.set_head_timeouts(health.head_timeouts);
    out.set_head_retries(health.head_retries);
    out.set_head_resets(health.head_resets);
    out.set_head_rejected(health.head_rejected);
}

bool readHead(const wire::Health& in, LinkHealth& health) {
    auto confirmed = read(in.head_confirmed());
    if (!confirmed || in.head_state() > last_head_state) return false;
    health.head_state = in.head_state();
    health.head = cleanText(in.head(), link_limits::longest_text);
    health.head_advice = cleanText(in.head_advice(), link_limits::longest_text);
    health.head_difference = cleanText(in.head_difference(), link_limits::longest_text);
    health.head_confirmed = *std::move(confirmed);
    health.head_pings = in.head_pings();
    health.head_timeouts = in.head_timeouts();
    health.head_retries = in.head_retries();
    health.head_resets = in.head_resets();
    health.head_rejected = in.head_rejected();
    return true;
}

void writeRun(const LinkHealth& health, wire::Health& out) {
    out.set_pings(health.pings);
    out.set_skipped(health.skipped);
    out.set_sweeps(health.sweeps);
    out.set_confirmed(health.confirmed);
    out.set_without_pose(health.without_pose);
    for (const auto& [what, number] : health.counts.rejected) {
        auto& count = *out.add_rejected();
        count.set_what(shown(what));
        count.set_number(number);
    }
    out.set_lost_records(health.counts.lost_records);
    out.set_skipped_bytes(health.counts.skipped_bytes);
    out.set_queued(health.queued);
    out.set_lag_s(health.lag_s);
    out.set_processing_s(health.processing_s);
    out.set_last_ping_us(optionalMicroseconds(health.last_ping));
    out.set_microseconds_per_ping(health.microseconds_per_ping);
}

bool readRun(const wire::Health& in, LinkHealth& health) {
    if (static_cast<std::size_t>(in.rejected_size()) > link_limits::most_counts || !isSane(in.lag_s()) ||
        !std::isfinite(in.processing_s()) || !isSane(in.microseconds_per_ping()) ||
        !readOptional(in.last_ping_us(), health.last_ping))
        return false;
    health.pings = in.pings();
    health.skipped = in.skipped();
    health.sweeps = in.sweeps();
    health.confirmed = in.confirmed();
    health.without_pose = in.without_pose();
    for (const wire::Count& count : in.rejected())
        health.counts.rejected[cleanText(count.what(), link_limits::longest_word)] = count.number();
    health.counts.lost_records = in.lost_records();
    health.counts.skipped_bytes = in.skipped_bytes();
    health.queued = in.queued();
    health.lag_s = in.lag_s();
    health.processing_s = in.processing_s();
    health.microseconds_per_ping = in.microseconds_per_ping();
    return true;
}

bool readNavigation(const wire::Health& in, LinkHealth& health) {
    if (!readOptional(in.heading_us(), health.heading_time) || !isSane(in.heading_rad())) return false;
    health.heading_kind = cleanText(in.heading_kind(), link_limits::longest_word);
    health.position_kind = cleanText(in.position_kind(), link_limits::longest_word);
    if (health.heading_time) health.heading = Bearing::radians(in.heading_rad());
    return true;
}

void writeLog(const LinkHealth& health, wire::Health& out) {
    out.set_recording(health.recording);
    out.set_log_path(shown(health.log_path));
    out.set_log_bytes(health.log_bytes);
    out.set_free_bytes(health.free_bytes);
    out.set_disk(health.disk);
    out.set_unsaved(health.unsaved);
    out.set_log_error(shown(health.log_error));
}

bool readLog(const wire::Health& in, LinkHealth& health) {
    if (in.disk() > last_disk_state) return false;
    health.recording = in.recording();
    health.log_path = cleanText(in.log_path(), link_limits::longest_text);
    health.log_bytes = in.log_bytes();
    health.free_bytes = in.free_bytes();
    health.disk = in.disk();
    health.unsaved = in.unsaved();
    health.log_error = cleanText(in.log_error(), link_limits::longest_text);
    return true;
}

}  // namespace

void write(const LinkHealth& health, wire::Health& out) {
    out.set_time_us(microsecondsOf(health.time));
    writeEnd(health.sonar, *out.mutable_sonar());
    if (health.navigation) writeEnd(*health.navigation, *out.mutable_navigation());
    writeHead(health, out);
    writeRun(health, out);
    out.set_heading_kind(shown(health.heading_kind));
    out.set_heading_us(optionalMicroseconds(health.heading_time));
    out.set_heading_rad(health.heading.value_or(Bearing()).inRadians());
    out.set_position_kind(shown(health.position_kind));
    writeLog(health, out);
    out.set_consoles(health.consoles);
}

std::optional<LinkHealth> read(const wire::Health& in) {
    LinkHealth health;
    const auto time = timeFrom(in.time_us());
    const auto sonar = readEnd(in.sonar());
    if (!time || !sonar || !readHead(in, health) || !readRun(in, health) || !readNavigation(in, health) ||
        !readLog(in, health))
        return std::nullopt;
    health.time = *time;
    health.sonar = *sonar;
    if (in.has_navigation()) {
        health.navigation = readEnd(in.navigation());
        if (!health.navigation) return std::nullopt;
    }
    health.consoles = in.consoles();
    return health;
}

}  // namespace echotrail
