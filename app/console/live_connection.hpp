#pragma once

#include "app/io/head_link.hpp"
#include "ui/bridge/live_source.hpp"

#include <QThread>

namespace echotrail {

/// The console's live source: links and session on a thread of their own, so that painting never delays the next
/// ping, and the runner behind them.
class LiveConnection : public LiveSource {
public:
    /// With `request.record` the log is made here, in the folder of recordings.
    static Result<std::unique_ptr<LiveSource>> make(const LiveRequest& request);
    LiveConnection(const LiveAddresses& addresses, const LiveRunner::Params& params, std::uint64_t seed,
                   std::unique_ptr<LogWriter> log);
    ~LiveConnection() override;

    void start() override;
    std::optional<Scene> takeScene() override { return runner_.scenes().take(); }
    std::optional<Timeline> takeTimeline() override { return runner_.timelines().take(); }
    LiveState state() const override;
    void setParams(const LiveRunner::Params& params) override;
    void designate(double range_m, Bearing from_bow) override { runner_.designate(range_m, from_bow); }
    void clearDesignation() override { runner_.clearDesignation(); }
    void drop(int track, double range_m, Bearing from_bow) override { runner_.drop(track, range_m, from_bow); }
    void restore(int track) override { runner_.restore(track); }
    void setEnhanced(bool on) override { runner_.setEnhanced(on); }

private:
    LiveRunner runner_;
    HeadLink link_;
    QThread thread_;
};

/// What a window needs to reach heads: real ones, and one for each built-in scenario.
LiveAccess liveAccess();

/// "serial:///dev/ttyUSB0" of every serial port that this computer has now.
QStringList serialPorts();

}  // namespace echotrail
