#pragma once

#include "app/io/live_addresses.hpp"
#include "core/runtime/live_runner.hpp"
#include "core/seanet/head_session.hpp"

#include <QObject>
#include <QTimer>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace echotrail {

/// A link at one moment, for a person to read.
struct LinkState {
    bool up = false;
    std::string reason;  ///< why it is down, one line; empty while it is up or was never tried
    ChannelCounts counts;
    std::optional<std::chrono::steady_clock::time_point> last_bytes;
};

/// Both links of a live run and what the head said, at one moment.
struct HeadLinkState {
    LinkState sonar;
    std::optional<LinkState> navigation;  ///< none where no navigation was asked for
    seanet::HeadStatus head;
};

/// A live run's two links: the channel to the head with the session that speaks on it, and the navigation's channel.
/// All bytes, read and sent, go to the runner (and so to the log) first.
/// Threads: state() from any; all else in the one it lives in, whose event loop runs. It may be moved before open();
///          the runner must outlive it.
class HeadLink : public QObject {
    Q_OBJECT
public:
    HeadLink(const LiveAddresses& addresses, const HeadSettings& settings, LiveRunner& runner);
    ~HeadLink() override;

    void open();
    /// Ends both links; open() may follow.
    void close();
    /// The operator's: the head scans their sector, or where it follows the target what the runner wants of it.
    void setSettings(const HeadSettings& settings);
    HeadLinkState state() const;

Q_SIGNALS:
    /// A link came or went, or the head told something new: one line.
    void noted(const QString& text);

private:
    void connectSonar();
    void connectNavigation();
    void aim();
    void converse();
    void noteHead(const seanet::HeadStatus& status);
    void publish();
    Microseconds now() const;

    const LiveAddresses addresses_;
    LiveRunner& runner_;
    HeadSettings settings_;  ///< the operator's
    bool follows_ = false;   ///< the head has been told other sectors than theirs since they were set
    seanet::HeadSession session_;
    std::unique_ptr<ByteChannel> sonar_, navigation_;
    QTimer deadline_{this};
    const std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
    HeadLinkState current_;  ///< this thread's own

    mutable std::mutex mutex_;
    HeadLinkState published_;
};

/// "scanning"
std::string headStateText(seanet::HeadState state);

}  // namespace echotrail
