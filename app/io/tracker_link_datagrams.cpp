#include "app/io/tracker_link.hpp"

#include <QUdpSocket>

// The part of a TrackerLink that takes datagrams: only those that are the tracker's and have not come before.
namespace echotrail {

void TrackerLink::openDatagrams() {
    closeDatagrams();
    const auto& offer = client_.status().welcome.datagrams;
    if (!offer) return;
    seal_ = std::make_unique<DatagramSeal>(DatagramKey{offer->session, QByteArray::fromStdString(offer->key)},
                                           DatagramSeal::Side::Console);
    datagrams_ = std::make_unique<QUdpSocket>();
    connect(datagrams_.get(), &QUdpSocket::readyRead, this, [this] {
        while (datagrams_->hasPendingDatagrams()) {
            QByteArray datagram(static_cast<qsizetype>(DatagramSeal::longest), Qt::Uninitialized);
            datagram.truncate(std::max<qint64>(datagrams_->readDatagram(datagram.data(), datagram.size()), 0));
            if (const auto text = seal_->open(datagram))
                client_.receivedDatagram(
                    now(), seal_->newest(),
                    {reinterpret_cast<const std::uint8_t*>(text->data()), static_cast<std::size_t>(text->size())});
        }
        converse();
    });
    datagrams_->connectToHost(QString::fromStdString(address_.host), offer->port);
}

/// Later, as it may be the socket's own signal that has led here.
void TrackerLink::closeDatagrams() {
    if (QUdpSocket* socket = datagrams_.release()) {
        socket->disconnect(this);
        socket->deleteLater();
    }
    seal_.reset();
}

void TrackerLink::reportDatagrams() {
    if (!datagrams_ || datagrams_->state() != QAbstractSocket::ConnectedState) return;
    if (const auto text = client_.datagramToSend(now()))
        datagrams_->write(seal_->seal(QByteArray::fromStdString(*text)));
}

}  // namespace echotrail
