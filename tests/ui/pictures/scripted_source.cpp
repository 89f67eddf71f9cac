#include "scripted_source.hpp"

namespace echotrail::test {

ScriptedHead::ScriptedHead(std::string_view scenario)
    : source_(openSimulation(scenario, 1).value()), pipeline_({}, 1) {}

void ScriptedHead::goTo(double seconds) {
    const Timestamp until = source_->info().start + microsecondsFromSeconds(seconds);
    while (now() < until) {
        auto next = source_->next();
        if (!next) return;
        ping_ = *std::move(next);
        latest_ = pipeline_.process(ping_, source_->navigation());
        builder_.add(ping_, latest_, 0.0, pipeline_);
        if (!latest_.looks.empty()) follows_ = anyFollowed(pipeline_.tracks());
        timeline_.see(ping_.time, latest_.sweep, follows_);
        ++pings_;
        sweeps_ += latest_.sweep_ended;
    }
}

Scene ScriptedHead::scene() const {
    Scene scene = builder_.build(pipeline_, ping_, latest_);
    scene.position = pings_;
    scene.navigation_known = true;
    return scene;
}

LiveState ScriptedHead::state() const {
    LiveState state;
    state.sonar = {true, {}, 0.1};
    state.navigation = LiveLink{true, {}, 0.1};
    state.head.state = seanet::HeadState::Polling;
    state.head.head = "SeaKing DFS, serial 4711, node 2, 325/675 kHz";
    state.head.confirmed = state.head.commanded;
    state.head.pings = pings_;
    state.run.pings = pings_;
    state.run.sweeps = sweeps_;
    state.run.first_ping = source_->info().start;
    state.run.last_ping = now();
    state.run.navigation_expected = true;
    state.run.navigation.heading_kind = "HDT";
    state.run.navigation.heading_time = now();
    state.run.navigation.heading = latest_.pose.heading;
    state.run.recorder.recording = true;
    state.run.recorder.path = "2026-01-01T000000Z-0001.echotrail";
    state.run.recorder.bytes = 2'000 * pings_;
    state.run.recorder.free_bytes = 212'400'000'000;
    state.ping_age_s = 0.1;
    state.heading_age_s = 0.1;
    return state;
}

}  // namespace echotrail::test
