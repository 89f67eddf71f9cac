#include "app/io/console_server.hpp"

#include <QUdpSocket>

// The part of a ConsoleServer that sends and takes datagrams. Who sends one is believed only once it has been opened
// with his key; nobody gets an answer otherwise.
namespace echotrail {
namespace {

constexpr int most_at_once = 64;  // then the others' turn comes

}  // namespace

/// On the port where consoles are served; where that cannot be had, everything goes by TCP.
void ConsoleServer::openDatagrams() {
    datagrams_ = std::make_unique<QUdpSocket>();
    if (!datagrams_->bind(listener_->serverAddress(), listener_->serverPort())) {
        tell(tr("no datagrams: %1; everything goes by TCP").arg(datagrams_->errorString()));
        datagrams_.reset();
        return;
    }
    connect(datagrams_.get(), &QUdpSocket::readyRead, this, &ConsoleServer::readDatagrams);
}

void ConsoleServer::readDatagrams() {
    for (int i = 0; i < most_at_once && datagrams_->hasPendingDatagrams(); ++i) {
        QByteArray datagram(static_cast<qsizetype>(DatagramSeal::longest), Qt::Uninitialized);
        QHostAddress from;
        quint16 port = 0;
        const qint64 size = datagrams_->readDatagram(datagram.data(), datagram.size(), &from, &port);
        datagram.truncate(std::max<qint64>(size, 0));
        const auto whose = consoles_of_datagrams_.find(DatagramSeal::sessionOf(datagram));
        const auto peer = whose == consoles_of_datagrams_.end() ? peers_.end() : peers_.find(whose->second);
        const auto text = peer == peers_.end() ? std::nullopt : peer->second.seal->open(datagram);
        if (!text) {
            ++datagrams_refused_;
            continue;
        }
        peer->second.datagrams_to = from;
        peer->second.datagrams_port = port;
        server_.receivedDatagram(
            peer->first, clock_(),
            {reinterpret_cast<const std::uint8_t*>(text->data()), static_cast<std::size_t>(text->size())});
        sendDatagrams(peer->first, peer->second);
    }
    if (datagrams_->hasPendingDatagrams())
        QMetaObject::invokeMethod(
            this,
            [this] {
                if (datagrams_) readDatagrams();
            },
            Qt::QueuedConnection);
}

void ConsoleServer::sendDatagrams(std::uint32_t console, Peer& peer) {
    if (!datagrams_ || !peer.seal || peer.datagrams_port == 0) return;
    for (const std::string& text : server_.takeDatagrams(console)) {
        const QByteArray datagram = peer.seal->seal(QByteArray::fromStdString(text));
        // One that the system does not take is lost like any other.
        if (!datagram.isEmpty()) datagrams_->writeDatagram(datagram, peer.datagrams_to, peer.datagrams_port);
    }
}

}  // namespace echotrail
