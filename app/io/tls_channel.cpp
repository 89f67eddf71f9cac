#include "app/io/tls_channel.hpp"

namespace echotrail {

QSslConfiguration tlsConfiguration(const OwnCertificate& own, QSslSocket::PeerVerifyMode verify) {
    QSslConfiguration configuration = QSslConfiguration::defaultConfiguration();
    configuration.setProtocol(QSsl::TlsV1_3OrLater);
    configuration.setCaCertificates({});
    configuration.setLocalCertificate(own.certificate);
    configuration.setPrivateKey(own.key);
    configuration.setPeerVerifyMode(verify);
    configuration.setSslOption(QSsl::SslOptionDisableSessionTickets, true);
    configuration.setSslOption(QSsl::SslOptionDisableSessionSharing, true);
    return configuration;
}

TlsChannel::TlsChannel(const LinkAddress& address, const TrustStore& trust)
    : TcpChannel(address, std::make_unique<QSslSocket>()), socket_(static_cast<QSslSocket&>(socket())), trust_(trust) {
    connect(&socket_, &QSslSocket::sslErrors, this, [this] {
        if (isTrusted()) socket_.ignoreSslErrors();  // signed by itself, for any host and time: that is all it can be
    });
    connect(&socket_, &QSslSocket::encrypted, this, [this] {
        if (isTrusted()) return ready();
        lose(reasonOf(QAbstractSocket::SslHandshakeFailedError));
    });
}

bool TlsChannel::isTrusted() const {
    return trust_.isPaired(TrustStore::Role::Tracker, fingerprintOf(socket_.peerCertificate()));
}

void TlsChannel::connectSocket() {
    const auto own = trust_.own();
    if (!own) return lose(QString::fromStdString(own.error()));
    socket_.setSslConfiguration(tlsConfiguration(*own, QSslSocket::VerifyPeer));
    socket_.connectToHostEncrypted(host(), address().port);
}

QString TlsChannel::reasonOf(QAbstractSocket::SocketError error) const {
    if (error != QAbstractSocket::SslHandshakeFailedError) return TcpChannel::reasonOf(error);
    if (socket_.peerCertificate().isNull() || isTrusted())
        return "no TLS 1.3 is spoken there: " + socket_.errorString();
    return QStringLiteral(
        "who answers there is not paired with this machine; run 'echotrail pair' aboard, and 'echotrail pair "
        "tls://HOST:PORT' here with the code that it shows");
}

qint64 TlsChannel::waitingBytes() const { return socket_.bytesToWrite() + socket_.encryptedBytesToWrite(); }

}  // namespace echotrail
