#include "app/io/tls_listener.hpp"

#include "app/io/tls_channel.hpp"
#include "core/link/link_limits.hpp"

#include <QHostAddress>
#include <QSslSocket>
#include <QTimer>
#include <algorithm>
#include <cstddef>
#include <utility>

namespace echotrail {
namespace {

constexpr int last_words_ms = 1'000;  // for the refusal to go out
constexpr qint64 read_bytes = 256 * 1024;
constexpr auto pairing_advice =
    "run 'echotrail pair' here, and 'echotrail pair tls://HOST:PORT' there with the code that it shows";

}  // namespace

TlsListener::TlsListener(const OwnCertificate& own, Gate gate, const QByteArray& refusal)
    : own_(own), gate_(std::move(gate)), refusal_(refusal) {}

void TlsListener::incomingConnection(qintptr handle) {
    auto* socket = new QSslSocket(this);
    if (!socket->setSocketDescriptor(handle)) return socket->deleteLater();
    const auto is_neighbour = [&](const auto& each) { return each.first->peerAddress() == socket->peerAddress(); };
    const auto neighbours = std::count_if(outside_.begin(), outside_.end(), is_neighbour);
    if (outside_.size() >= link_limits::most_handshakes ||
        neighbours >= static_cast<std::ptrdiff_t>(link_limits::most_handshakes_each)) {
        ++refused_["too_many"];
        socket->abort();
        return socket->deleteLater();
    }
    outside_[socket] = State::Handshake;
    connect(socket, &QSslSocket::destroyed, this, [this, socket] { outside_.erase(socket); });
    socket->setReadBufferSize(read_bytes);
    // Who has no certificate is told so within TLS; that nobody's word is taken for it is admit()'s business.
    socket->setSslConfiguration(tlsConfiguration(own_, QSslSocket::QueryPeer));
    connect(socket, &QSslSocket::encrypted, this, [this, socket] { admit(socket); });
    connect(socket, &QSslSocket::errorOccurred, this, [this, socket](QAbstractSocket::SocketError error) {
        if (error == QAbstractSocket::RemoteHostClosedError)
            return fail(socket, "broke_off",
                        tr("it broke off, as one does that does not know this machine; %1").arg(pairing_advice));
        fail(socket, "no_tls", tr("it does not speak TLS 1.3; connect with tls://HOST:PORT"));
    });
    QTimer::singleShot(link_limits::handshake_within, socket,
                       [this, socket] { fail(socket, "too_slow", tr("it did not show its certificate in time")); });
    socket->startServerEncryption();
}

void TlsListener::admit(QSslSocket* socket) {
    const auto found = outside_.find(socket);
    if (found == outside_.end() || found->second != State::Handshake) return;
    const QSslCertificate shown = socket->peerCertificate();
    if (shown.isNull()) return fail(socket, "no_certificate", tr("it shows no certificate; connect with a console"));
    if (!gate_(fingerprintOf(shown)))
        return fail(socket, "not_paired",
                    tr("its certificate is not paired with this machine (any more); %1").arg(pairing_advice));
    outside_.erase(found);
    socket->disconnect(this);
    Q_EMIT admitted(socket);
}

void TlsListener::fail(QSslSocket* socket, const std::string& cause, const QString& what) {
    const auto found = outside_.find(socket);
    if (found == outside_.end() || std::exchange(found->second, State::Leaving) == State::Leaving) return;
    ++refused_[cause];
    Q_EMIT turnedAway(tr("a console at %1 was turned away: %2").arg(socket->peerAddress().toString(), what));
    if (!socket->isEncrypted()) {
        socket->abort();
        return socket->deleteLater();
    }
    socket->write(refusal_);
    socket->disconnectFromHost();
    QTimer::singleShot(last_words_ms, socket, [socket] {
        socket->abort();
        socket->deleteLater();
    });
}

}  // namespace echotrail
