#include "app/io/link_health.hpp"

namespace echotrail {
namespace {

// The numbers stand in link.proto.
static_assert(static_cast<int>(seanet::HeadState::NoLink) == 0 && static_cast<int>(seanet::HeadState::Waiting) == 1 &&
              static_cast<int>(seanet::HeadState::Identifying) == 2 &&
              static_cast<int>(seanet::HeadState::Centring) == 3 &&
              static_cast<int>(seanet::HeadState::Configuring) == 4 &&
              static_cast<int>(seanet::HeadState::Polling) == 5 && static_cast<int>(seanet::HeadState::Silent) == 6 &&
              static_cast<int>(seanet::HeadState::WrongDevice) == 7);
static_assert(static_cast<int>(DiskState::Good) == 0 && static_cast<int>(DiskState::Low) == 1 &&
              static_cast<int>(DiskState::Full) == 2);

LinkEnd linkEnd(const LinkState& state) {
    LinkEnd end{state.up, state.reason, {}};
    if (state.last_bytes)
        end.age_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - *state.last_bytes).count();
    return end;
}

std::vector<NamedValue> headValues(const HeadSettings& settings) {
    static const auto infos = describeParameters<HeadSettings>();
    const auto values = parameterValues(settings);
    std::vector<NamedValue> named;
    for (std::size_t i = 0; i < infos.size(); ++i) named.emplace_back(infos[i].name, values[i]);
    return named;
}

void tellHead(const seanet::HeadStatus& head, LinkHealth& health) {
    health.head_state = static_cast<std::uint32_t>(head.state);
    health.head = head.head;
    health.head_advice = head.advice;
    health.head_difference = head.difference;
    if (head.confirmed) health.head_confirmed = headValues(*head.confirmed);
    health.head_pings = head.pings;
    health.head_timeouts = head.timeouts;
    health.head_retries = head.retries;
    health.head_resets = head.head_resets;
    health.head_rejected = head.rejected;
}

void tellRun(const LiveStatus& run, LinkHealth& health) {
    health.pings = run.pings;
    health.skipped = run.skipped;
    health.sweeps = run.sweeps;
    health.confirmed = run.confirmed;
    health.without_pose = run.without_pose;
    health.counts = run.counts;
    health.queued = run.queued;
    health.lag_s = run.lag_s;
    health.processing_s = run.processing_s;
    if (run.pings > 0) health.microseconds_per_ping = 1e6 * run.processing_s / static_cast<double>(run.pings);
    health.last_ping = run.last_ping;
    health.heading_kind = run.navigation.heading_kind;
    health.position_kind = run.navigation.position_kind;
    health.heading_time = run.navigation.heading_time;
    health.heading = run.navigation.heading;
    const RecorderStatus& log = run.recorder;
    health.recording = log.recording;
    health.log_path = log.path;
    health.log_bytes = log.bytes;
    health.free_bytes = log.free_bytes;
    health.disk = static_cast<std::uint32_t>(log.disk);
    health.unsaved = log.unsaved;
    health.log_error = log.error;
}

}  // namespace

LinkHealth linkHealth(const HeadLinkState& link, const LiveStatus& run, Timestamp now) {
    LinkHealth health{.time = now, .sonar = linkEnd(link.sonar)};
    if (link.navigation) health.navigation = linkEnd(*link.navigation);
    tellHead(link.head, health);
    tellRun(run, health);
    return health;
}

seanet::HeadStatus headStatusFrom(const LinkHealth& health, const HeadSettings& commanded) {
    seanet::HeadStatus head;
    head.state = static_cast<seanet::HeadState>(health.head_state);
    head.head = health.head;
    head.advice = health.head_advice;
    head.difference = health.head_difference;
    head.commanded = commanded;
    if (!health.head_confirmed.empty()) {
        HeadSettings& confirmed = head.confirmed.emplace(commanded);
        for (const auto& [name, value] : health.head_confirmed)
            static_cast<void>(setParameter(confirmed, name, value));  // another version may say more
    }
    head.pings = health.head_pings;
    head.timeouts = health.head_timeouts;
    head.retries = health.head_retries;
    head.head_resets = health.head_resets;
    head.rejected = health.head_rejected;
    return head;
}

LiveStatus liveStatusFrom(const LinkHealth& health) {
    LiveStatus run;
    run.pings = health.pings;
    run.skipped = health.skipped;
    run.sweeps = health.sweeps;
    run.confirmed = health.confirmed;
    run.without_pose = health.without_pose;
    run.counts = health.counts;
    run.queued = static_cast<std::size_t>(health.queued);
    run.lag_s = health.lag_s;
    run.processing_s = health.processing_s;
    run.last_ping = health.last_ping;
    run.navigation.heading_kind = health.heading_kind;
    run.navigation.position_kind = health.position_kind;
    run.navigation.heading_time = health.heading_time;
    run.navigation.heading = health.heading;
    run.recorder.recording = health.recording;
    run.recorder.path = health.log_path;
    run.recorder.bytes = health.log_bytes;
    run.recorder.free_bytes = health.free_bytes;
    run.recorder.disk = static_cast<DiskState>(health.disk);
    run.recorder.unsaved = health.unsaved;
    run.recorder.error = health.log_error;
    return run;
}

}  // namespace echotrail
