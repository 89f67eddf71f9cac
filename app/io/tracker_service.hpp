#pragma once

#include "app/io/console_server.hpp"
#include "app/io/head_link.hpp"
#include "app/io/recording_shelf.hpp"
#include "core/runtime/live_runner.hpp"

#include <QObject>
#include <QThread>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace echotrail {

/// Serves a live run to consoles: what it brings about goes out, what they ask for goes in. All sockets live on a
/// thread of its own; the pipeline leaves moments in a mailbox that never makes it wait.
/// Order:   start() once; stop() (or destruction) while runner and head link still live.
/// Threads: take() on the pipeline's; say() on any; all else in the one it was made in, which is the head link's.
class TrackerService : public QObject {
    Q_OBJECT
public:
    struct Counts {
        LinkServer::Counts link;
        std::map<std::string, std::uint64_t> turned_away;  ///< cause → connections that TLS did not let in
        std::uint64_t datagrams_refused = 0;               ///< not from whom they said, or again
        std::uint64_t missed = 0;                          ///< moments that the consoles' thread was too slow for
    };

    /// Consoles may read what `shelf` holds.
    TrackerService(const LiveRunner::Params& params, LiveRunner& runner, HeadLink& head, const std::string& program,
                   RecordingShelf shelf);
    ~TrackerService() override;

    /// Gives the address that consoles have to be told; the error says why nobody can be served there. With `datagrams`
    /// pictures go by UDP to those who want it.
    Result<LinkAddress> start(const LinkAddress& address, bool datagrams = false);
    void stop();
    void take(const Ping& ping, const Update& update, const ScanningSonarPipeline& pipeline);
    void say(LinkLog::Weight weight, const std::string& text);
    /// After stop().
    const Counts& counts() const { return counts_; }

Q_SIGNALS:
    void noted(const QString& text);

private:
    using Answer = Result<std::optional<std::vector<NamedValue>>>;
    Answer answer(const LinkRequest& request);
    Answer setParameters(const LinkSetParameters& wanted);
    void drain();

    LiveRunner& runner_;
    HeadLink& head_;
    LiveRunner::Params params_;  ///< the consoles' thread's own
    RecordingShelf shelf_;       ///< the same
    QThread thread_;
    std::unique_ptr<ConsoleServer> server_;  ///< lives there
    std::unique_ptr<QTimer> health_;         ///< there, too

    std::mutex mutex_;  ///< of the mailbox; held for moments only
    std::deque<LinkMoment> mailbox_;
    std::uint64_t missed_ = 0;
    bool gap_ = false, stopped_ = true;
    std::optional<Timestamp> first_ping_;  ///< the pipeline thread's own
    std::optional<Timestamp> last_ping_;
    Counts counts_;
};

}  // namespace echotrail
