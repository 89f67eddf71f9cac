#pragma once

#include "app/io/tracker_link.hpp"
#include "ui/bridge/live_source.hpp"

#include <QThread>

namespace echotrail {

/// A tracker far away as the console's live source: the link on a thread of its own. Nothing runs here but the
/// painting of the picture.
class RemoteConnection : public LiveSource {
public:
    /// `address` is tls, or tcp on this machine; the error, a matter of usage, says what would be accepted. With
    /// `record` a copy of the run is kept in the folder of recordings.
    static Result<std::unique_ptr<LiveSource>> make(const QString& address, bool record);
    RemoteConnection(const LinkAddress& address, bool record);
    ~RemoteConnection() override;

    void start() override;
    std::optional<Scene> takeScene() override { return link_.scenes().take(); }
    std::optional<Timeline> takeTimeline() override { return link_.timelines().take(); }
    LiveState state() const override;
    void setParams(const LiveRunner::Params& params) override;
    void designate(double range_m, Bearing from_bow) override;
    void clearDesignation() override;
    void drop(int track, double range_m, Bearing from_bow) override;
    void restore(int track) override;
    void setEnhanced(bool on) override { link_.setEnhanced(on); }
    std::optional<LiveRunner::Params> takeParams() override { return link_.takeParams(); }
    std::optional<LiveNotice> takeNotice() override;
    void control(TrackerControl action) override;
    void listRecordings() override;
    void fetchRecording(const QString& name) override;
    void cancelFetch() override;

private:
    TrackerLink link_;
    QThread thread_;
};

}  // namespace echotrail
