#pragma once

#include "app/io/tcp_channel.hpp"
#include "app/io/trust_store.hpp"

#include <QSslConfiguration>
#include <QSslSocket>

namespace echotrail {

/// What both sides of the link ask of TLS: version 1.3, the own certificate, nobody's word for another's, and no
/// session taken up again, so that whoever is revoked stays out.
QSslConfiguration tlsConfiguration(const OwnCertificate& own, QSslSocket::PeerVerifyMode verify);

/// A stream to a tracker that this machine is paired with: TLS 1.3, both certificates pinned. Whoever shows another
/// certificate is told nothing.
class TlsChannel final : public TcpChannel {
public:
    TlsChannel(const LinkAddress& address, const TrustStore& trust);

private:
    void connectSocket() override;
    void connected() override {}  // that is TCP's; there is no secret yet
    QString reasonOf(QAbstractSocket::SocketError error) const override;
    qint64 waitingBytes() const override;
    bool isTrusted() const;

    QSslSocket& socket_;  ///< TcpChannel's
    TrustStore trust_;
};

}  // namespace echotrail
