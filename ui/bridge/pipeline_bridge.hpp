#pragma once

#include "core/runtime/replay_runner.hpp"
#include "ui/bridge/source_opener.hpp"

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
    void close();

    bool isOpen() const { return runner_ != nullptr; }
    bool isOpening() const { return opener_.busy(); }
    const QString& openingName() const { return opening_name_; }
    /// Of the source that is open; empty otherwise.
    const SourceInfo& info() const { return info_; }
    const ReplayStatus& status() const { return status_; }
    const Timeline& timeline() const { return timeline_; }
    const std::shared_ptr<const Scene>& scene() const { return scene_; }
    const Params& params() const { return params_; }
    double speed() const { return speed_; }

    void setSeed(std::uint64_t seed) { seed_ = seed; }
    void setParams(const Params& params);
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
    /// Scenes carry the locally enhanced picture too, also those of sources opened later.
    void setEnhanced(bool on);
    /// Hands out what is new. Called by the display timer; tests call it too.
    void poll();

Q_SIGNALS:
    void opening(const QString& name);
    void opened();
    void openFailed(const QString& name, const QString& reason);
    void closed();
    void sceneChanged(std::shared_ptr<const echotrail::Scene> scene);
    void statusChanged(const echotrail::ReplayStatus& status);
    void timelineChanged(const echotrail::Timeline& timeline);

private:
    void pollOpening();
    void adopt(std::unique_ptr<PingSource> source);

    QTimer timer_;
    SourceOpener opener_;
    QString opening_name_;
    SourceInfo info_;
    Params params_;
    std::uint64_t revision_ = 0;
    std::uint64_t seed_ = 0;
    double speed_ = 1.0;
    bool enhanced_ = false;
    ReplayStatus status_;
    Timeline timeline_;
    std::shared_ptr<const Scene> scene_;
    std::unique_ptr<ReplayRunner> runner_;
};

}  // namespace echotrail
