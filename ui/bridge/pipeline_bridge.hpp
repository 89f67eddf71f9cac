#pragma once

#include "core/runtime/replay_runner.hpp"
#include "ui/bridge/live_source.hpp"
#include "ui/bridge/source_opener.hpp"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

namespace echotrail {

/// Where the core's threads meet Qt: the newest scene, status and timeline come out as signals at the display's pace,
/// commands go in as plain calls that return at once.
class PipelineBridge : public QObject {
    Q_OBJECT

public:
    using Params = ScanningSonarPipeline::Params;

    explicit PipelineBridge(QObject* parent = nullptr);
    ~PipelineBridge() override;

    /// Opens a recording in the background; opened() or openFailed() follows. What plays now goes on until then.
    void openRecording(const QString& path);
    void openDemonstration();
    void open(const QString& name, SourceOpener::Opener opener);
    void cancelOpening();
    void setLiveAccess(LiveAccess access) { live_access_ = std::move(access); }
    bool canGoLive() const { return live_access_.open != nullptr; }
    QStringList livePorts() const { return live_access_.ports ? live_access_.ports() : QStringList(); }
    const QString& recordingsFolder() const { return live_access_.recordings; }
    const QList<SimulatedHeadChoice>& simulatedHeads() const { return live_access_.simulated_heads; }
    /// Polls a head instead of what is open: opened(), or connectFailed() and nothing has changed.
    void openLive(const QString& sonar, const QString& navigation, bool record);
    /// Follows a tracker far away instead of what is open; as openLive(). While it is followed the parameters are the
    /// tracker's; afterwards those of before.
    void openTracker(const QString& address, bool record);
    bool canFollow() const { return live_access_.open_tracker != nullptr; }
    bool isTracker() const { return live_ && own_params_; }
    /// Parameters and seed are those of the run that was recorded, as they were at each ping: until someone sets
    /// others. When the recording is closed those of before are back.
    bool isAsRecorded() const { return runner_ && own_params_; }
    /// What is set counts for recordings too, whatever was in force when they were made.
    void setOverridesRecorded(bool on) { overrides_recorded_ = on; }
    void control(TrackerControl action);
    // Of recordings aboard a tracker; what has come is in the live state.
    void listRecordings();
    void fetchRecording(const QString& name);
    void cancelFetch();
    void close();

    bool isOpen() const { return runner_ || live_; }
    bool isLive() const { return live_ != nullptr; }
    bool isOpening() const { return opener_.busy(); }
    const QString& openingName() const { return opening_name_; }
    /// Of the source that is open; empty otherwise.
    const SourceInfo& info() const { return info_; }
    const ReplayStatus& status() const { return status_; }
    const LiveState& liveState() const { return live_state_; }
    const Timeline& timeline() const { return timeline_; }
    const std::shared_ptr<const Scene>& scene() const { return scene_; }
    const Params& params() const { return params_; }
    double speed() const { return speed_; }

    void setSeed(std::uint64_t seed) { seed_ = seed; }
    void setParams(const Params& params);
    /// Whether what was set is known to be in force: at the ping that is shown, or aboard.
    bool paramsInForce() const;
    void setLoop(std::optional<PingSpan> loop);

public Q_SLOTS:
    void play();
    void pause();
    void togglePlay();
    void stepPings(int count);
    void stepSweep(int direction);
    void seekPosition(quint64 position);
    void seekSeconds(double from_start);
    void skipSeconds(double seconds);
    void setSpeed(double factor);
    void cancelSeek();
    void designate(double range_m, double bearing_from_bow_rad);
    void clearDesignation();
    /// As in LiveSource.
    void dropTrack(int track, double range_m, echotrail::Bearing from_bow);
    void restoreTrack(int track);
    /// Scenes carry the locally enhanced picture too, also those of sources opened later.
    void setEnhanced(bool on);
    /// Hands out what is new. Called by the display timer; tests call it too.
    void poll();

Q_SIGNALS:
    void opening(const QString& name);
    void opened();
    void openFailed(const QString& name, const QString& reason);
    void connectFailed(const QString& reason);
    void closed();
    void sceneChanged(std::shared_ptr<const echotrail::Scene> scene);
    void statusChanged(const echotrail::ReplayStatus& status);
    void timelineChanged(const echotrail::Timeline& timeline);
    /// Four times a second while a head is polled.
    void liveChanged(const echotrail::LiveState& state);
    void paramsChanged(const echotrail::ScanningSonarPipeline::Params& params);
    /// They were changed from elsewhere: forms have to show them.
    void paramsAdopted();
    void noticed(const QString& text, bool ok);

private:
    void pollOpening();
    void adopt(std::unique_ptr<PingSource> source);
    void startReplay(std::unique_ptr<PingSource> source);
    /// Ends what is open; says nothing.
    void clear();
    void announce();
    void pollLive();
    void startLive(std::unique_ptr<LiveSource> source, const QString& name);
    void adoptParams(const Params& params);
    void showScene(Scene scene);

    QTimer timer_;
    SourceOpener opener_;
    QString opening_name_;
    SourceInfo info_;
    Params params_;
    bool overrides_recorded_ = false;
    std::optional<Params> own_params_;  ///< of this console, while a tracker or a recorded run has others in force
    std::uint64_t revision_ = 0;
    bool echo_awaited_ = false;           ///< of the parameters that a far tracker was sent
    std::uint64_t in_force_at_ping_ = 0;  ///< of a live run: its queue then holds only what came after they were set
    std::uint64_t seed_ = 0;
    double speed_ = 1.0;
    bool enhanced_ = false;
    ReplayStatus status_;
    Timeline timeline_;
    std::shared_ptr<const Scene> scene_;
    std::unique_ptr<ReplayRunner> runner_;
    LiveAccess live_access_;
    LiveState live_state_;
    QElapsedTimer live_told_;
    std::unique_ptr<LiveSource> live_;  ///< never beside runner_
};

}  // namespace echotrail
