#pragma once

#include "app/io/byte_channel.hpp"
#include "app/io/datagram_seal.hpp"
#include "app/io/record_keeper.hpp"
#include "core/link/link_client.hpp"
#include "core/runtime/latest.hpp"
#include "core/runtime/remote_scene.hpp"
#include "core/runtime/run_timeline.hpp"

#include <QObject>
#include <QThread>
#include <QTimer>
#include <atomic>
#include <chrono>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

class QUdpSocket;

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
    std::optional<double> age_s;                 ///< since the last message
    std::optional<KeptRecording> record;         ///< the copy of the run that is kept here; none where it is not kept
    std::optional<KeptRecording> fetched;        ///< the recording that is fetched, or was the last
    std::vector<LinkRecordingEntry> recordings;  ///< aboard, as last listed
    std::string recordings_error;                ///< why they could not be listed
};

/// Something the operator should read.
struct TrackerNotice {
    bool problem = false;
    std::string text;
};

/// The console's end of the link on TCP, and UDP where the tracker offers it: it connects, joins, reconnects by itself,
/// and puts the scenes together.
/// Threads: what is marked so from any; all else in the one it lives in, whose event loop runs. It may be moved before
///          open().
class TrackerLink : public QObject {
    Q_OBJECT
public:
    /// The runs that are written aboard are kept in `folder`, too; empty: they are not.
    TrackerLink(const LinkAddress& address, const LinkIdentity& identity, const std::string& folder = {},
                bool wants_control = true);
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
    /// The list is in the state, some time later.
    void listRecordings();
    /// Fetches a recording of the list to `folder`; what is under way comes first. A copy that was begun before is gone
    /// on with.
    void fetch(const std::string& name, const std::string& folder);
    void cancelFetch();

    // From any thread
    Latest<Scene>& scenes() { return scenes_; }
    Latest<Timeline>& timelines() { return timelines_; }
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
    void takeJoin();
    void takeLoss();
    void openDatagrams();
    void closeDatagrams();
    void reportDatagrams();
    void tellJoined(RecordKeeper& keeper);
    bool takeRecordEvent(const LinkEvent& event);
    std::unique_ptr<RecordKeeper> makeKeeper(const std::string& folder, const std::string& name);
    void ask(RecordKeeper& keeper, std::uint32_t request);
    void endKeeper(std::unique_ptr<RecordKeeper>& keeper);
    void fetchNext();
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
    RunTimeline timeline_;
    QTimer* tick_ = nullptr;
    QTimer* reopen_ = nullptr;  ///< runs while a connection that was given up here waits to be made again
    bool wanted_ = false;
    std::string reason_;
    std::optional<RemoteScene::Params> wanted_params_;
    std::uint32_t params_request_ = 0;  ///< that has no answer yet
    std::optional<LinkControl> control_;

    std::unique_ptr<QUdpSocket> datagrams_;  ///< where the tracker offers them
    std::unique_ptr<DatagramSeal> seal_;

    struct Asked {
        RecordKeeper* keeper = nullptr;
        Microseconds since{0};
    };
    struct Wanted {
        std::string name, folder;
    };
    const std::string folder_;
    QThread records_thread_;  ///< so that no disk is waited for
    std::unique_ptr<RecordKeeper> keeper_, fetch_;
    std::map<std::uint32_t, Asked> asked_;  ///< by request
    std::uint32_t list_request_ = 0;
    std::deque<Wanted> to_fetch_;

    const std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
    Latest<Scene> scenes_;
    Latest<Timeline> timelines_;
    std::atomic<bool> enhanced_ = false;

    mutable std::mutex mutex_;
    TrackerLinkState published_;
    std::optional<Microseconds> tracker_offset_;  ///< of its clock from now()
    std::optional<RemoteScene::Params> echo_;
    std::deque<TrackerNotice> notices_;
};

}  // namespace echotrail
