#include "core/runtime/live_runner.hpp"

#include "core/imaging/local_enhancement.hpp"
#include "core/recording/update_text.hpp"
#include "core/runtime/denormals.hpp"
#include "core/runtime/processor_time.hpp"
#include "core/runtime/prompt_thread.hpp"

#include <string>

namespace echotrail {
namespace {

constexpr std::size_t longest_queue = 100'000;  // some minutes of the reads of a busy link
constexpr Microseconds longest_lag{2'000'000};  // an older ping is skipped: the tracker must see the present
constexpr std::chrono::milliseconds idle_wait{200};

std::vector<std::uint8_t> bytesOf(std::string_view text) { return {text.begin(), text.end()}; }

LiveRunner::Clock sinceNow() {
    return [begun = std::chrono::steady_clock::now()] {
        return std::chrono::duration_cast<Microseconds>(std::chrono::steady_clock::now() - begun);
    };
}

}  // namespace

LiveRunner::LiveRunner(const Params& params, std::uint64_t seed, std::unique_ptr<LogWriter> log, Listener listener,
                       Clock clock)
    : started_(std::chrono::time_point_cast<Microseconds>(std::chrono::system_clock::now())),
      clock_(clock ? std::move(clock) : sinceNow()),
      recorder_(log ? std::make_unique<Recorder>(std::move(log)) : nullptr),
      events_(longest_queue),
      listener_(std::move(listener)),
      pipeline_(params, seed),
      feed_(params.head.sound_speed, params.navigation.longest_navigation_gap_s) {
    setParams(params);
    thread_ = std::jthread([this] { run(); });
}

LiveRunner::~LiveRunner() {
    finish();
    closeLog();
}

void LiveRunner::finish() {
    events_.close();
    if (thread_.joinable()) thread_.join();
}

void LiveRunner::closeLog() {
    if (!recorder_) return;
    if (!summed_up_) record({UpdateKind::Summary, now(), "{\"pings\":" + std::to_string(taken_) + "}"});
    recorder_->close();
}

/// UTC that never jumps: when someone sets the computer's clock in the middle of a run, tracks must not break.
Timestamp LiveRunner::now() const { return started_ + elapsed(); }

void LiveRunner::post(EventKind kind, std::vector<std::uint8_t> payload) {
    const std::scoped_lock lock(post_mutex_);
    postLocked(kind, std::move(payload));
}

void LiveRunner::postLocked(EventKind kind, std::vector<std::uint8_t> payload) {
    const Microseconds monotonic = elapsed();
    Event event{next_number_++, kind, started_ + monotonic, monotonic, std::move(payload)};
    if (recorder_) recorder_->add(event);
    if (kind != EventKind::SentBytes && kind != EventKind::Skip) events_.push(std::move(event));
}

void LiveRunner::setParams(const Params& params) { post(EventKind::Parameters, bytesOf(parameterText(params))); }

void LiveRunner::designate(double range_m, Bearing from_bow) {
    const RunControl wanted{.kind = RunControl::Kind::Designation, .range_m = range_m, .from_bow = from_bow};
    post(EventKind::Designation, bytesOf(designationText(wanted)));
}

void LiveRunner::clearDesignation() { post(EventKind::Designation, {}); }

void LiveRunner::drop(int track, double range_m, Bearing from_bow) {
    const RunControl wanted{.kind = RunControl::Kind::Drop, .range_m = range_m, .from_bow = from_bow, .track = track};
    post(EventKind::Drop, bytesOf(dropText(wanted)));
}

void LiveRunner::restore(int track) {
    post(EventKind::Drop, bytesOf(dropText({.kind = RunControl::Kind::Restore, .track = track})));
}

void LiveRunner::record(ResultRow row) {
    if (!recorder_) return;
    if (row.kind == UpdateKind::Summary) summed_up_ = true;
    recorder_->add(std::move(row));
}

void LiveRunner::run() {
    flushDenormals();
    becomePrompt();  // where that is not granted the tracker works, too
    while (!events_.ended()) {
        auto events = events_.take(idle_wait);
        recordSkips();
        for (const Event& event : events) {
            feed_.take(event);
            takePings(event.monotonic);
            updateStatus(event.monotonic);
        }
    }
    feed_.finish();
    takePings(elapsed());
    recordSkips();
    last_update_ = pipeline_.finish();
    builder_.addFinal(last_update_);
    tell(last_update_, Timestamp::max());
    updateStatus(elapsed());
}

void LiveRunner::takePings(Microseconds arrived) {
    while (const auto ping = feed_.next()) {
        for (const RunControl& control : feed_.takeControls()) apply(control);
        if (!first_ping_) first_ping_ = ping->time;
        if (elapsed() - arrived > longest_lag)
            skip(*ping);
        else
            process(*ping);
    }
}

/// The tracker is so far behind that what it would say were of the past; a recording of the run leaves it out too.
void LiveRunner::skip(const Ping& ping) {
    ++skipped_;
    skips_to_record_.push_back(ping.sequence);
}

/// Only when the queue has just been emptied: whoever posts holds the lock that post() needs, and may be waiting for
/// room in it.
void LiveRunner::recordSkips() {
    for (const std::uint64_t sequence : std::exchange(skips_to_record_, {}))
        post(EventKind::Skip, bytesOf(std::to_string(sequence)));
}

void LiveRunner::process(const Ping& ping) {
    pipeline_.setFanPainting(paint_fan_);
    const double before = processorSeconds();
    last_update_ = pipeline_.process(ping, feed_.navigation());
    const double took_s = processorSeconds() - before;
    processing_s_ += took_s;
    ++taken_;
    without_pose_ += last_update_.navigation_gap;
    {
        const std::scoped_lock lock(status_mutex_);
        sector_ = pipeline_.sector();
    }
    last_ping_ = ping;
    tell(last_update_, pipeline_.settledUntil());  // before the picture: that takes milliseconds at a sweep's end
    builder_.add(last_ping_, last_update_, took_s, pipeline_);
    run_timeline_.see(ping.time, last_update_.sweep, follows_);
    if (run_timeline_.changed() && timelines_.empty()) timelines_.put(run_timeline_.summary());
    if (!scenes_.empty()) return;  // nobody has looked at the last one yet
    Scene scene = builder_.build(pipeline_, last_ping_, last_update_);
    follows_ = anyFollowed(scene.tracks);
    scene.position = taken_;
    scene.counts = feed_.counts();
    scene.navigation_known = !feed_.navigation().empty();
    scene.plane = planeOfPings();
    if (enhanced_) scene.enhanced = enhanceLocally(scene.fan, pipeline_.params().enhancement);
    scenes_.put(std::move(scene));
}

/// The plane of navigation, laid where the vehicle was at the first ping.
std::optional<LocalPlane> LiveRunner::planeOfPings() const {
    const auto plane = feed_.navigationStatus().plane;
    const auto& origin = pipeline_.origin();
    if (!plane || !origin) return std::nullopt;
    return LocalPlane(plane->toGeographic({origin->north_m, origin->east_m}));
}

void LiveRunner::apply(const RunControl& control) {
    if (control.kind != RunControl::Kind::Parameters) return pipeline_.command(control);
    Params params;
    if (!applyRecordedParameters(params, control.parameters)) return;  // the feed has counted it
    pipeline_.setParams(params);
    feed_.setLongestGap(params.navigation.longest_navigation_gap_s);
}

void LiveRunner::tell(const Update& update, Timestamp settled) {
    for (const TrackLook& look : update.looks) record({UpdateKind::Track, look.time, lookText(look)});
    for (const Region& region : update.regions) record({UpdateKind::Region, update.time, regionText(region)});
    if (listener_) listener_(update, settled, pipeline_);
}

void LiveRunner::updateStatus(Microseconds arrived) {
    const std::scoped_lock lock(status_mutex_);
    ++status_.events;
    status_.pings = taken_;
    status_.skipped = skipped_;
    status_.sweeps = pipeline_.sweeps();
    status_.confirmed = pipeline_.confirmedTracks();
    status_.unsynchronised = pipeline_.unsynchronisedPings();
    status_.without_pose = without_pose_;
    status_.counts = feed_.counts();
    status_.navigation = feed_.navigationStatus();
    status_.navigation_expected = feed_.navigationExpected();
    status_.lag_s = std::chrono::duration<double>(elapsed() - arrived).count();
    status_.processing_s = processing_s_;
    status_.first_ping = first_ping_;
    if (taken_ > 0) status_.last_ping = last_ping_.time;
}

std::optional<ScanSector> LiveRunner::sector() const {
    const std::scoped_lock lock(status_mutex_);
    return sector_;
}

LiveStatus LiveRunner::status() const {
    LiveStatus status;
    {
        const std::scoped_lock lock(status_mutex_);
        status = status_;
    }
    status.queued = events_.size();
    if (recorder_) status.recorder = recorder_->status();
    return status;
}

}  // namespace echotrail
