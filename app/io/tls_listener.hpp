#pragma once

#include "app/io/trust_store.hpp"

#include <QByteArray>
#include <QString>
#include <QTcpServer>
#include <cstdint>
#include <functional>
#include <map>
#include <string>

class QSslSocket;

namespace echotrail {

/// Listens for consoles by TLS 1.3. Only who has shown a certificate, proved to hold its key, and passes the gate is
/// admitted; the rest never gets further than here.
/// Threads: the one it lives in, whose event loop runs.
class TlsListener : public QTcpServer {
    Q_OBJECT
public:
    /// Whether who shows the certificate with this fingerprint may come in.
    using Gate = std::function<bool(const QByteArray& fingerprint)>;
    /// `refusal` is sent, within TLS, to who may not; it says what to do.
    TlsListener(const OwnCertificate& own, Gate gate, const QByteArray& refusal);

    /// Cause → connections that were not let in.
    const std::map<std::string, std::uint64_t>& refused() const { return refused_; }

Q_SIGNALS:
    /// The receiver takes care of it from now on; it ends with the listener at the latest.
    void admitted(QSslSocket* socket);
    /// One line.
    void turnedAway(const QString& text);

protected:
    void incomingConnection(qintptr handle) override;

private:
    void admit(QSslSocket* socket);
    void fail(QSslSocket* socket, const std::string& cause, const QString& what);

    OwnCertificate own_;
    Gate gate_;
    QByteArray refusal_;
    enum class State { Handshake, Leaving };
    std::map<QSslSocket*, State> outside_;  ///< not admitted, and not yet gone
    std::map<std::string, std::uint64_t> refused_;
};

}  // namespace echotrail
