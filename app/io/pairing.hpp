#pragma once

#include "app/io/link_address.hpp"
#include "app/io/pairing_code.hpp"
#include "app/io/tls_listener.hpp"
#include "app/io/trust_store.hpp"
#include "core/link/framing.hpp"

#include <QElapsedTimer>
#include <QObject>
#include <QSslSocket>
#include <QTimer>
#include <map>
#include <memory>
#include <string>

namespace echotrail {

/// The tracker's side of a pairing: shows a code (code()), and waits for a console that proves to know it. It is over
/// with the first that does, after five that do not, or after five minutes.
/// Threads: the one it lives in, whose event loop runs.
class PairingServer : public QObject {
    Q_OBJECT
public:
    /// `name`: of this vehicle, for the console's list.
    PairingServer(const PairingCode& code, const TrustStore& trust, const QString& name);
    ~PairingServer() override;

    /// TLS only; port 0 takes any free one. Gives the address that the console has to be told.
    Result<LinkAddress> listen(const LinkAddress& address);

Q_SIGNALS:
    void paired(const TrustStore::Peer& console);
    /// The code is worth nothing any more; one line that says why, and what to do.
    void over(const QString& reason);
    /// Something that a person should see: one line.
    void noted(const QString& text);

private:
    void welcome(QSslSocket* socket);
    void read(QSslSocket* socket);
    void judge(QSslSocket* socket, std::string_view message);
    void say(QSslSocket* socket, const std::string& reason, const QByteArray& proof);
    Microseconds sinceMade() const { return Microseconds{since_made_.nsecsElapsed() / 1000}; }

    PairingDesk desk_;
    TrustStore trust_;
    QString name_;
    OwnCertificate own_;
    QElapsedTimer since_made_;
    QTimer end_{this};
    std::unique_ptr<TlsListener> listener_;
    std::map<QSslSocket*, FrameReader> talking_;
};

/// The console's side: tells a tracker that it knows the code, and trusts it only when the tracker has shown the same.
/// Threads: the one it lives in, whose event loop runs.
class PairingClient : public QObject {
    Q_OBJECT
public:
    /// `name`: of this console, for the tracker's list.
    PairingClient(const PairingCode& code, const TrustStore& trust, const QString& name);
    ~PairingClient() override { socket_.disconnect(this); }

    /// Ends in paired() or failed(), within a quarter of a minute; the error says that it cannot even begin.
    Result<void> begin(const LinkAddress& tracker);

Q_SIGNALS:
    void paired(const TrustStore::Peer& tracker);
    void failed(const QString& reason);

private:
    void prove();
    void read();
    void judge(std::string_view message);
    void end(const QString& reason);

    PairingCode code_;
    TrustStore trust_;
    QString name_;
    OwnCertificate own_;
    QSslSocket socket_{this};
    QTimer patience_{this};
    FrameReader reader_{link_limits::longest_pairing_message};
    bool ended_ = false;
};

}  // namespace echotrail
