#pragma once

#include "app/io/byte_channel.hpp"
#include "core/link/link_client.hpp"
#include "core/runtime/latest.hpp"
#include "core/runtime/remote_scene.hpp"

#include <QObject>
#include <QTimer>
#include <atomic>
#include <chrono>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace echotrail {

/// A far tracker at one moment, for a person to read.
struct TrackerLinkState {
    bool up = false;     ///< connected, and greeted
    std::string reason;  ///< why not
    LinkClientStatus client;
    LinkHealth health;  ///< the last that came
    RemoteScene::Params params;
    std::optional<Timestamp> tracker_time;  ///< now, by its clock; none before it has answered
    std::optional<Timestamp> last_ping;
    std::optional<double> age_s;  ///< since the last message
};

/// Something the operator should read.
struct TrackerNotice {
    bool problem = false;
    std::string text;
};

/// The console's end of the link on TCP: it connects, joins, reconnects by itself, and puts the scenes together.
/// Threads: what is marked so from any; all else in the one it lives in, whose event loop runs. It may be moved before
///          open().
class TrackerLink : public QObject {
    Q_OBJECT
public:
    TrackerLink(const LinkAddress& address, const LinkIdentity& identity);
    ~TrackerLink() override;

    void open();
    void close();
    /// Tells the tracker what differs from what is in force there; what comes while an answer is awaited goes together
    /// once it is there.
    void setParams(const RemoteScene::Params& params);
    void designate(double range_m, Bearing from_bow);
    void clearDesignation();
    void drop(int track, double range_m, Bearing from_bow);
    void restore(int track);
    void control(ControlAction action);

    // From any thread
    Latest<Scene>& scenes() { return scenes_; }
    void setEnhanced(bool on) { enhanced_ = on; }
    TrackerLinkState state() const;
    /// Parameters in force at the tracker, where they have changed or differ from what was asked for.
    std::optional<RemoteScene::Params> takeParams();
    std::optional<TrackerNotice> takeNotice();

private:
    void connectChannel();
    void take(const QByteArray& bytes);
    void takeEvents();
    void takeReply(const LinkReply& reply);
    void takeControl(const LinkControl& control);
    void converse();
    void sendParams();
    void lost(const QString& reason);
    void notice(bool problem, const std::string& text);
    void publish();
    void refused(std::uint32_t request, const std::string& what);
    Microseconds now() const;

    const LinkAddress address_;
    std::unique_ptr<ByteChannel> channel_;
    LinkClient client_;
    RemoteScene remote_;
    QTimer* tick_ = nullptr;
    bool wanted_ = false;
    std::string reason_;
    std::optional<RemoteScene::Params> wanted_params_;
    std::uint32_t params_request_ = 0;  ///< that has no answer yet
    std::optional<LinkControl> control_;
    const std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
    Latest<Scene> scenes_;
    std::atomic<bool> enhanced_ = false;

    mutable std::mutex mutex_;
    TrackerLinkState published_;
    std::optional<Microseconds> tracker_offset_;  ///< of its clock from now()
    std::optional<RemoteScene::Params> echo_;
    std::deque<TrackerNotice> notices_;
};

}  // namespace echotrail
