#include "app/io/tcp_channel.hpp"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <QSignalBlocker>
#include <utility>

namespace echotrail {
namespace {

constexpr int connect_patience_ms = 5'000, unanswered_ms = 10'000;

}  // namespace

TcpChannel::TcpChannel(const LinkAddress& address, std::unique_ptr<QTcpSocket> socket)
    : ByteChannel(address), socket_(std::move(socket)) {
    socket_->setParent(this);  // it moves to another thread with the channel; its owner is the pointer all the same
    patience_.setSingleShot(true);
    connect(socket_.get(), &QTcpSocket::connected, this, [this] { connected(); });
    connect(socket_.get(), &QTcpSocket::readyRead, this, [this] { take(socket_->readAll()); });
    connect(socket_.get(), &QTcpSocket::errorOccurred, this,
            [this](QAbstractSocket::SocketError error) { lose(reasonOf(error)); });
    connect(&patience_, &QTimer::timeout, this, [this] { lose(QStringLiteral("no answer")); });
}

QString TcpChannel::reasonOf(QAbstractSocket::SocketError error) const {
    return error == QAbstractSocket::RemoteHostClosedError ? QStringLiteral("the other side closed the connection")
                                                           : socket_->errorString();
}

void TcpChannel::tryOpen() {
    shut();
    patience_.start(connect_patience_ms);
    connectSocket();
}

void TcpChannel::lose(const QString& reason) {
    shut();
    linkLost(QString::fromStdString(toText(address())) + ": " + reason);
}

void TcpChannel::ready() {
    patience_.stop();
    setOptions();
    linkMade();
}

void TcpChannel::setOptions() {
    socket_->setSocketOption(QAbstractSocket::LowDelayOption, 1);
    socket_->setSocketOption(QAbstractSocket::KeepAliveOption, 1);
    // A pulled cable says nothing: without these the system finds out after hours.
    const auto set = [this](int option, int value) {
        ::setsockopt(static_cast<int>(socket_->socketDescriptor()), IPPROTO_TCP, option, &value, sizeof value);
    };
    set(TCP_KEEPIDLE, 5);
    set(TCP_KEEPINTVL, 2);
    set(TCP_KEEPCNT, 3);
    set(TCP_USER_TIMEOUT, unanswered_ms);
}

void TcpChannel::shut() {
    patience_.stop();
    const QSignalBlocker silent(*socket_);  // our own closing is no event
    socket_->abort();
}

}  // namespace echotrail
