#include "app/io/pairing.hpp"

#include "app/io/tls_channel.hpp"
#include "core/link/pairing_message.hpp"

#include <QHostAddress>
#include <optional>
#include <string_view>
#include <utility>

namespace echotrail {
namespace {

/// The message, once it is whole; where it can be none, the reader is broken.
std::optional<std::string_view> readFrom(QSslSocket& socket, FrameReader& reader) {
    const QByteArray bytes = socket.read(static_cast<qint64>(link_limits::longest_pairing_message));
    reader.take({reinterpret_cast<const std::uint8_t*>(bytes.constData()), static_cast<std::size_t>(bytes.size())});
    return reader.next();
}

void sendTo(QSslSocket& socket, const std::string& frame) {
    socket.write(frame.data(), static_cast<qint64>(frame.size()));
}

TrustStore::Peer peerOf(TrustStore::Role role, const QSslSocket& socket, const std::string& name) {
    const QByteArray fingerprint = fingerprintOf(socket.peerCertificate());
    const QString shown =
        name.empty() ? QString::fromLatin1(fingerprint.toHex().left(8)) : QString::fromStdString(name);
    return {role, fingerprint, shown, QDateTime::currentDateTimeUtc()};
}

}  // namespace

PairingServer::PairingServer(const PairingCode& code, const TrustStore& trust, const QString& name)
    : desk_(code), trust_(trust), name_(name) {
    since_made_.start();
    end_.setSingleShot(true);
    connect(&end_, &QTimer::timeout, this,
            [this] { Q_EMIT over(tr("nobody came with the code in five minutes; run echotrail pair again")); });
    end_.start(link_limits::pairing_lasts);
}

PairingServer::~PairingServer() {
    for (auto& [socket, reader] : talking_) socket->disconnect(this);
}

Result<LinkAddress> PairingServer::listen(const LinkAddress& address) {
    const QHostAddress host(QString::fromStdString(address.host));
    if (address.kind != LinkAddress::Kind::Tls || host.isNull())
        return Error{"pairing waits by TLS on an address of this machine in numbers, as tls://0.0.0.0:7001"};
    auto own = trust_.own();
    if (!own) return Error{own.error()};
    own_ = *std::move(own);
    // Everybody with a certificate may try: the code is what counts.
    listener_ = std::make_unique<TlsListener>(
        own_, [](const QByteArray&) { return true; }, QByteArray());
    connect(listener_.get(), &TlsListener::admitted, this, &PairingServer::welcome);
    connect(listener_.get(), &TlsListener::turnedAway, this, &PairingServer::noted);
    if (!listener_->listen(host, address.port))
        return Error{"cannot wait on " + toText(address) + ": " + listener_->errorString().toStdString()};
    LinkAddress real = address;
    real.port = listener_->serverPort();
    return real;
}

void PairingServer::welcome(QSslSocket* socket) {
    connect(socket, &QSslSocket::disconnected, socket, &QSslSocket::deleteLater);
    if (talking_.size() >= link_limits::most_handshakes) return socket->abort();
    talking_.emplace(socket, FrameReader(link_limits::longest_pairing_message));
    connect(socket, &QSslSocket::destroyed, this, [this, socket] { talking_.erase(socket); });
    connect(socket, &QSslSocket::readyRead, this, [this, socket] { read(socket); });
    QTimer::singleShot(link_limits::pairing_answer, socket, [socket] { socket->abort(); });
    if (socket->bytesAvailable() > 0) read(socket);
}

void PairingServer::read(QSslSocket* socket) {
    FrameReader& reader = talking_.at(socket);
    const auto message = readFrom(*socket, reader);
    if (reader.broken()) return socket->abort();
    if (message) judge(socket, *message);
}

void PairingServer::judge(QSslSocket* socket, std::string_view message) {
    socket->disconnect(this);  // it has had its say; what it is from here on is told by the socket's own end
    connect(socket, &QSslSocket::destroyed, this, [this, socket] { talking_.erase(socket); });
    const auto request = readPairRequest(message);
    if (!request) return socket->abort();
    const auto console = peerOf(TrustStore::Role::Console, *socket, request->name);
    const QByteArray own = fingerprintOf(own_.certificate);
    switch (desk_.judge(QByteArray::fromStdString(request->proof), own, console.fingerprint, sinceMade())) {
        case PairingDesk::Verdict::Over:
            return say(socket, "the code is worth nothing any more; run echotrail pair aboard again", {});
        case PairingDesk::Verdict::Wrong:
            say(socket, "the code is wrong, or somebody sits between; look at it and try again", {});
            Q_EMIT noted(tr("%1 ('%2') did not know the code; %3 tries are left")
                             .arg(socket->peerAddress().toString(), console.name)
                             .arg(desk_.triesLeft()));
            if (desk_.triesLeft() == 0)
                Q_EMIT over(tr("five tries did not know the code; see who tries, and run echotrail pair again"));
            return;
        case PairingDesk::Verdict::Right:
            break;
    }
    if (const auto added = trust_.add(console); !added) {
        say(socket, "the tracker cannot remember it: " + added.error(), {});
        return Q_EMIT over(QString::fromStdString(added.error()));
    }
    end_.stop();
    connect(socket, &QSslSocket::disconnected, this, [this, console] { Q_EMIT paired(console); });
    say(socket, {}, desk_.code().proof(PairingCode::Prover::Tracker, own, console.fingerprint));
}

void PairingServer::say(QSslSocket* socket, const std::string& reason, const QByteArray& proof) {
    sendTo(*socket, pairFrame(PairReply{reason.empty(), reason, proof.toStdString(), name_.toStdString()}));
    socket->disconnectFromHost();
}

PairingClient::PairingClient(const PairingCode& code, const TrustStore& trust, const QString& name)
    : code_(code), trust_(trust), name_(name) {
    patience_.setSingleShot(true);
    connect(&patience_, &QTimer::timeout, this, [this] { end(tr("no answer")); });
    // Whoever answers is heard out: it is the proof that says who it is.
    connect(&socket_, &QSslSocket::sslErrors, this, [this] { socket_.ignoreSslErrors(); });
    connect(&socket_, &QSslSocket::encrypted, this, &PairingClient::prove);
    connect(&socket_, &QSslSocket::readyRead, this, &PairingClient::read);
    connect(&socket_, &QSslSocket::errorOccurred, this, [this](QAbstractSocket::SocketError error) {
        end(error == QAbstractSocket::RemoteHostClosedError
                ? tr("the other side closed the connection; is 'echotrail pair' still waiting aboard?")
                : socket_.errorString());
    });
}

Result<void> PairingClient::begin(const LinkAddress& tracker) {
    if (tracker.kind != LinkAddress::Kind::Tls || tracker.port == 0)
        return Error{"a tracker that waits for pairing is reached at tls://HOST:PORT"};
    auto own = trust_.own();
    if (!own) return Error{own.error()};
    own_ = *std::move(own);
    socket_.setSslConfiguration(tlsConfiguration(own_, QSslSocket::VerifyPeer));
    patience_.start(link_limits::pairing_answer + link_limits::handshake_within);
    socket_.connectToHostEncrypted(QString::fromStdString(tracker.host), tracker.port);
    return {};
}

void PairingClient::prove() {
    const QByteArray proof = code_.proof(PairingCode::Prover::Console, fingerprintOf(socket_.peerCertificate()),
                                         fingerprintOf(own_.certificate));
    sendTo(socket_, pairFrame(PairRequest{proof.toStdString(), name_.toStdString()}));
}

void PairingClient::read() {
    const auto message = readFrom(socket_, reader_);
    if (reader_.broken()) return end(tr("what answers there is no tracker that waits for pairing"));
    if (message) judge(*message);
}

void PairingClient::judge(std::string_view message) {
    const auto reply = readPairReply(message);
    if (!reply) return end(tr("what answers there is no tracker that waits for pairing"));
    if (!reply->done) return end(tr("the tracker says: %1").arg(QString::fromStdString(reply->reason)));
    const auto tracker = peerOf(TrustStore::Role::Tracker, socket_, reply->name);
    const QByteArray right =
        code_.proof(PairingCode::Prover::Tracker, tracker.fingerprint, fingerprintOf(own_.certificate));
    if (!isSameProof(QByteArray::fromStdString(reply->proof), right))
        return end(tr("who answers there does not know the code: it is not the tracker that showed it"));
    if (const auto added = trust_.add(tracker); !added) return end(QString::fromStdString(added.error()));
    if (std::exchange(ended_, true)) return;
    patience_.stop();
    socket_.disconnectFromHost();
    Q_EMIT paired(tracker);
}

void PairingClient::end(const QString& reason) {
    if (std::exchange(ended_, true)) return;
    patience_.stop();
    socket_.abort();
    Q_EMIT failed(reason);
}

}  // namespace echotrail
