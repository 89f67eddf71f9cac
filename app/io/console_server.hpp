#pragma once

#include "app/io/datagram_seal.hpp"
#include "app/io/link_address.hpp"
#include "app/io/tls_listener.hpp"
#include "app/io/trust_store.hpp"
#include "core/link/link_server.hpp"

#include <QHostAddress>
#include <QObject>
#include <QTimer>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class QSslSocket;
class QTcpSocket;
class QUdpSocket;

namespace echotrail {

/// Whether consoles may be served there: by TCP on this machine itself only, by TLS on any of its addresses. The error,
/// a matter of usage, says why not and what to do.
Result<void> checkServable(const LinkAddress& address);

/// The tracker's end of the link on TCP or TLS: sockets about a LinkServer. What a console does not read stays out of
/// the sockets' buffers but for a little, so that it is the LinkServer that decides what is left out. Threads: the one
/// it lives in (moveToThread() before listen()), whose event loop runs; destroyed there, too.
class ConsoleServer : public QObject {
    Q_OBJECT
public:
    using Clock = std::function<Timestamp()>;
    /// Does what is asked for; where that changed the parameters, all of them as they are now.
    using Handler = std::function<Result<std::optional<std::vector<NamedValue>>>(const LinkRequest&)>;

    /// Answers what is asked of recordings; in this object's thread, one after the other.
    using RecordHandler = std::function<Result<LinkRecordAnswer>(const LinkRecordRequest&)>;

    /// `trust` says who may come in by TLS; one who is revoked is dropped within a second.
    ConsoleServer(const LinkIdentity& identity, std::vector<NamedValue> parameters, Clock clock, Handler handler,
                  const TrustStore& trust = TrustStore::ofUser());
    ~ConsoleServer() override;

    /// Consoles may read recordings, too. Before listen().
    void serveRecordings(RecordHandler handler);
    /// Pictures, regions and particles go by UDP to consoles that want it, on the port where they are served. Before
    /// listen().
    void serveDatagrams() { wants_datagrams_ = true; }
    /// Port 0 takes any free one; gives the address that consoles have to be told.
    Result<LinkAddress> listen(const LinkAddress& address);
    void publish(LinkMoment moment);
    void publish(const LinkHealth& health);
    void publish(const LinkLog& line);
    /// What was published goes out; not by itself, so that many moments go in one.
    void flush();

    const LinkServer::Counts& counts() const { return server_.counts(); }
    /// Cause → connections that TLS did not let in.
    std::map<std::string, std::uint64_t> turnedAway() const;
    /// Datagrams that were not from whom they said, or came again.
    std::uint64_t datagramsRefused() const { return datagrams_refused_; }
    std::size_t consoles() const { return server_.consoles(); }
    SendQueue::Level levelOf(std::uint32_t console) const { return server_.levelOf(console, clock_()); }

Q_SIGNALS:
    /// Consoles came, went, took control, misbehaved: one line.
    void noted(const QString& text);

private:
    struct Peer {
        QTcpSocket* socket = nullptr;
        QByteArray fingerprint;  ///< by TLS
        std::optional<Timestamp> closing_since;
        std::unique_ptr<DatagramSeal> seal;  ///< none where it has no datagrams
        QHostAddress datagrams_to;           ///< once it has said so
        quint16 datagrams_port = 0;
    };
    Result<void> makeListener(const LinkAddress& address);
    std::optional<std::uint32_t> welcome(QTcpSocket* socket);
    void welcomeByTls(QSslSocket* socket);
    void dropRevoked();
    void openDatagrams();
    void readDatagrams();
    void sendDatagrams(std::uint32_t console, Peer& peer);
    void read(std::uint32_t console);
    void flush(std::uint32_t console);
    void close(std::uint32_t console);
    void answerRequests();
    void answerRecordRequests();
    void tellNotes();
    void beginNotes();
    void tell(const QString& note);
    void tick();

    Clock clock_;
    Handler handler_;
    RecordHandler record_handler_;
    LinkServer server_;
    TrustStore trust_;
    std::unique_ptr<QTcpServer> listener_;
    TlsListener* tls_ = nullptr;  ///< the same, where it is one
    std::map<std::uint32_t, Peer> peers_;
    bool wants_datagrams_ = false;
    std::unique_ptr<QUdpSocket> datagrams_;
    std::map<std::uint64_t, std::uint32_t> consoles_of_datagrams_;  ///< by session
    std::uint64_t datagrams_refused_ = 0;
    QTimer* tick_ = nullptr;
    std::uint64_t notes_left_ = 0, notes_untold_ = 0;  ///< of this interval
    Timestamp notes_since_{}, trust_checked_{};
};

}  // namespace echotrail
