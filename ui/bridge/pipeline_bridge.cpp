#include "ui/bridge/pipeline_bridge.hpp"

#include "core/recording/recording.hpp"
#include "core/simulation/demonstration.hpp"

#include <QFileInfo>
#include <algorithm>

namespace echotrail {
namespace {

constexpr int display_interval_ms = 33;
constexpr int live_state_interval_ms = 250;  // numbers change four times a second at most

}  // namespace

PipelineBridge::PipelineBridge(QObject* parent) : QObject(parent) {
    timer_.setInterval(display_interval_ms);
    connect(&timer_, &QTimer::timeout, this, &PipelineBridge::poll);
}

PipelineBridge::~PipelineBridge() = default;

void PipelineBridge::openRecording(const QString& path) {
    RecordingOptions options;
    const double speed_of_sound = params_.head.sound_speed;
    if (speed_of_sound != HeadSettings{}.sound_speed) options.sound_speed_mps = speed_of_sound;  // else the file's own
    const bool as_recorded = !overrides_recorded_;
    open(QFileInfo(path).fileName(), [path = path.toStdString(), options, as_recorded]() -> SourceOpener::Outcome {
        auto opened = echotrail::openRecording(path, as_recorded ? RecordingOptions{} : options);
        // A run that was recorded brings its own speed of sound, like all its parameters.
        if (!as_recorded || !opened || !options.sound_speed_mps || (*opened)->recordedRun()) return opened;
        return echotrail::openRecording(path, options);
    });
}

void PipelineBridge::openDemonstration() {
    open(tr("demonstration"), [seed = seed_]() -> SourceOpener::Outcome { return makeDemonstration(seed); });
}

void PipelineBridge::open(const QString& name, SourceOpener::Opener opener) {
    opening_name_ = name;
    opener_.start(std::move(opener));
    timer_.start();
    Q_EMIT opening(name);
}

void PipelineBridge::cancelOpening() {
    opener_.cancel();
    opening_name_.clear();
}

void PipelineBridge::openLive(const QString& sonar, const QString& navigation, bool record) {
    cancelOpening();
    if (!canGoLive()) return Q_EMIT connectFailed(tr("this program has no live links"));
    auto made = live_access_.open({sonar, navigation, record, own_params_.value_or(params_), seed_});
    if (!made) return Q_EMIT connectFailed(QString::fromStdString(made.error()));
    clear();  // before the start: a serial port has one owner
    startLive(std::move(*made), sonar);
}

void PipelineBridge::openTracker(const QString& address, bool record) {
    cancelOpening();
    if (!canFollow()) return Q_EMIT connectFailed(tr("this program has no live links"));
    auto made = live_access_.open_tracker(address, record);
    if (!made) return Q_EMIT connectFailed(QString::fromStdString(made.error()));
    clear();
    own_params_ = params_;
    startLive(std::move(*made), address);
}

void PipelineBridge::startLive(std::unique_ptr<LiveSource> source, const QString& name) {
    live_ = std::move(source);
    live_->setEnhanced(enhanced_);
    live_->start();
    info_.name = name.toStdString();
    status_.state = ReplayState::Playing;
    announce();
    pollLive();
    timer_.start();
}

void PipelineBridge::control(TrackerControl action) {
    if (live_) live_->control(action);
}

void PipelineBridge::listRecordings() {
    if (live_) live_->listRecordings();
}

void PipelineBridge::fetchRecording(const QString& name) {
    if (live_ && !name.isEmpty()) live_->fetchRecording(name);
}

void PipelineBridge::cancelFetch() {
    if (live_) live_->cancelFetch();
}

/// Not told to the live source, which said them. An echo of what was commanded here changes nothing.
void PipelineBridge::adoptParams(const Params& params) {
    if (parameterValues(params) == parameterValues(params_)) return;
    params_ = params;
    ++revision_;
    Q_EMIT paramsChanged(params_);
    Q_EMIT paramsAdopted();
}

void PipelineBridge::close() {
    if (!isOpen()) return;
    clear();
    Q_EMIT closed();
}

void PipelineBridge::clear() {
    runner_.reset();  // the old thread ends before a new one starts
    live_.reset();
    if (own_params_) adoptParams(*std::exchange(own_params_, std::nullopt));
    live_state_ = {};
    echo_awaited_ = false;
    in_force_at_ping_ = 0;
    live_told_.invalidate();
    info_ = {};
    status_ = {};
    status_.revision = revision_;
    timeline_ = {};
    scene_.reset();
}

void PipelineBridge::announce() {
    Q_EMIT opened();
    Q_EMIT statusChanged(status_);
    Q_EMIT timelineChanged(timeline_);
}

void PipelineBridge::adopt(std::unique_ptr<PingSource> source) {
    clear();
    info_ = source->info();
    startReplay(std::move(source));
    runner_->setSpeed(speed_);
    runner_->setEnhanced(enhanced_);
    announce();
}

void PipelineBridge::startReplay(std::unique_ptr<PingSource> source) {
    const auto run = overrides_recorded_ ? std::nullopt : source->recordedRun();
    Params recorded;
    if (!run || !applyRecordedParameters(recorded, run->parameters)) {
        runner_ = std::make_unique<ReplayRunner>(std::move(source), params_, seed_);
        return;
    }
    own_params_ = params_;
    runner_ = std::make_unique<ReplayRunner>(std::move(source), recorded, run->seed, true);
    adoptParams(recorded);
}

void PipelineBridge::setParams(const Params& params) {
    if (runner_) own_params_.reset();  // what someone sets while looking at a recording is meant to stay
    params_ = params;
    ++revision_;
    if (runner_) runner_->setParams(params_, revision_);
    if (live_) {
        const LiveStatus run = live_->state().run;
        in_force_at_ping_ = run.pings + run.queued + 1;
        echo_awaited_ = isTracker();
        live_->setParams(params_);
    }
    Q_EMIT paramsChanged(params_);
}

bool PipelineBridge::paramsInForce() const {
    if (runner_) return status_.revision >= revision_;
    if (isTracker()) return !echo_awaited_;
    return !live_ || live_state_.run.pings >= in_force_at_ping_;
}

void PipelineBridge::pollOpening() {
    auto outcome = opener_.take();
    if (!outcome) return;
    const QString name = std::exchange(opening_name_, QString());
    if (*outcome)
        adopt(std::move(**outcome));
    else
        Q_EMIT openFailed(name, QString::fromStdString(outcome->error()));
}

void PipelineBridge::poll() {
    pollOpening();
    if (live_) return pollLive();
    if (!runner_) {
        if (!opener_.busy()) timer_.stop();
        return;
    }
    if (auto timeline = runner_->timelines().take()) {
        timeline_ = std::move(*timeline);
        Q_EMIT timelineChanged(timeline_);
    }
    if (const auto params = runner_->recordedParams().take(); params && isAsRecorded()) adoptParams(*params);
    if (auto scene = runner_->scenes().take()) showScene(std::move(*scene));
    if (auto status = runner_->status(); status != status_) {
        status_ = std::move(status);
        Q_EMIT statusChanged(status_);
    }
}

void PipelineBridge::pollLive() {
    if (auto scene = live_->takeScene()) showScene(std::move(*scene));
    if (const auto params = live_->takeParams()) {
        echo_awaited_ = false;
        adoptParams(*params);
    }
    while (const auto notice = live_->takeNotice()) Q_EMIT noticed(notice->text, notice->ok);
    if (live_told_.isValid() && live_told_.elapsed() < live_state_interval_ms) return;
    live_told_.start();
    if (auto timeline = live_->takeTimeline()) {
        timeline_ = std::move(*timeline);
        Q_EMIT timelineChanged(timeline_);
    }
    live_state_ = live_->state();
    Q_EMIT liveChanged(live_state_);
}

void PipelineBridge::showScene(Scene scene) {
    scene_ = std::make_shared<const Scene>(std::move(scene));
    Q_EMIT sceneChanged(scene_);
}

void PipelineBridge::play() {
    if (runner_) runner_->play();
}
void PipelineBridge::pause() {
    if (runner_) runner_->pause();
}
void PipelineBridge::togglePlay() {
    if (status_.state == ReplayState::Playing)
        pause();
    else
        play();
}
void PipelineBridge::stepPings(int count) {
    if (runner_) runner_->stepPings(count);
}
void PipelineBridge::stepSweep(int direction) {
    if (runner_) runner_->stepSweep(direction);
}
void PipelineBridge::seekPosition(quint64 position) {
    if (runner_) runner_->seek(position);
}

void PipelineBridge::seekSeconds(double from_start) {
    if (!runner_ || timeline_.pings() == 0) return;
    runner_->seekTime(timeline_.ping_times->front() + microsecondsFromSeconds(std::max(0.0, from_start)));
}

void PipelineBridge::skipSeconds(double seconds) {
    if (!runner_ || timeline_.pings() == 0) return;
    const auto& times = *timeline_.ping_times;
    // From where a seek under way is heading, so that repeated keys add up.
    const std::uint64_t from = std::clamp<std::uint64_t>(status_.goal, 1, times.size()) - 1;
    runner_->seekTime(std::max(times.front(), times[from] + microsecondsFromSeconds(seconds)));
}

void PipelineBridge::setSpeed(double factor) {
    speed_ = factor;
    if (runner_) runner_->setSpeed(factor);
}
void PipelineBridge::setLoop(std::optional<PingSpan> loop) {
    if (runner_) runner_->setLoop(loop);
}
void PipelineBridge::cancelSeek() {
    if (runner_) runner_->cancel();
}
void PipelineBridge::designate(double range_m, double bearing_from_bow_rad) {
    const Bearing from_bow = Bearing::radians(bearing_from_bow_rad);
    if (runner_) runner_->designate(range_m, from_bow);
    if (live_) live_->designate(range_m, from_bow);
}
void PipelineBridge::dropTrack(int track, double range_m, Bearing from_bow) {
    if (runner_) runner_->drop(track, range_m, from_bow);
    if (live_) live_->drop(track, range_m, from_bow);
}
void PipelineBridge::restoreTrack(int track) {
    if (runner_) runner_->restore(track);
    if (live_) live_->restore(track);
}
void PipelineBridge::setEnhanced(bool on) {
    enhanced_ = on;
    if (runner_) runner_->setEnhanced(on);
    if (live_) live_->setEnhanced(on);
}
void PipelineBridge::clearDesignation() {
    if (runner_) runner_->clearDesignation();
    if (live_) live_->clearDesignation();
}

}  // namespace echotrail
