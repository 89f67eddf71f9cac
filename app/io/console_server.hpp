#pragma once

#include "app/io/link_address.hpp"
#include "core/link/link_server.hpp"

#include <QObject>
#include <QTcpServer>
#include <QTimer>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class QTcpSocket;

namespace echotrail {

/// Whether consoles may be served there: on TCP, on this machine itself only. The error, a matter of usage, says why
/// not and what to do.
Result<void> checkServable(const LinkAddress& address);

/// The tracker's end of the link on TCP: sockets about a LinkServer. What a console does not read stays out of the
/// sockets' buffers but for a little, so that it is the LinkServer that decides what is left out.
/// Threads: the one it lives in (moveToThread() before listen()), whose event loop runs; destroyed there, too.
class ConsoleServer : public QObject {
    Q_OBJECT
public:
    using Clock = std::function<Timestamp()>;
    /// Does what is asked for; where that changed the parameters, all of them as they are now.
    using Handler = std::function<Result<std::optional<std::vector<NamedValue>>>(const LinkRequest&)>;

    ConsoleServer(const LinkIdentity& identity, std::vector<NamedValue> parameters, Clock clock, Handler handler);
    ~ConsoleServer() override;

    /// Port 0 takes any free one; gives the address that consoles have to be told.
    Result<LinkAddress> listen(const LinkAddress& address);
    void publish(LinkMoment moment);
    void publish(const LinkHealth& health);
    void publish(const LinkLog& line);
    /// What was published goes out; not by itself, so that many moments go in one.
    void flush();

    const LinkServer::Counts& counts() const { return server_.counts(); }
    std::size_t consoles() const { return server_.consoles(); }

Q_SIGNALS:
    /// Consoles came, went, took control, misbehaved: one line.
    void noted(const QString& text);

private:
    struct Peer {
        QTcpSocket* socket = nullptr;
        std::optional<Timestamp> closing_since;
    };
    void welcome(QTcpSocket* socket);
    void read(std::uint32_t console);
    void flush(std::uint32_t console);
    void close(std::uint32_t console);
    void answerRequests();
    void tellNotes();
    void tick();

    Clock clock_;
    Handler handler_;
    LinkServer server_;
    std::unique_ptr<QTcpServer> listener_;
    std::map<std::uint32_t, Peer> peers_;
    QTimer* tick_ = nullptr;
    std::uint64_t notes_left_ = 0, notes_untold_ = 0;  ///< of this interval
    Timestamp notes_since_{};
};

}  // namespace echotrail
