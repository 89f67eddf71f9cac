#include "app/io/byte_server.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <QHostAddress>
#include <QNetworkDatagram>
#include <QSocketNotifier>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTimer>
#include <QUdpSocket>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

namespace echotrail {
namespace {

constexpr qint64 longest_queue_bytes = 1 << 20;
constexpr int release_ms = 200;

Error notOurs(const LinkAddress& address) {
    return Error{"cannot listen on " + toText(address) + ": say an address of this machine in numbers, or localhost"};
}

QHostAddress hostOf(const LinkAddress& address) {
    if (address.host == "localhost") return QHostAddress(QHostAddress::LocalHost);
    return QHostAddress(QString::fromStdString(address.host));
}

class TcpByteServer final : public ByteServer {
public:
    ~TcpByteServer() override {
        if (peer_) peer_->disconnect(this);
    }
    Result<void> start(const LinkAddress& address) {
        address_ = address;
        const QHostAddress host = hostOf(address);
        if (host.isNull()) return notOurs(address);
        if (!server_.listen(host, address.port))
            return Error{"cannot listen on " + toText(address) + ": " + server_.errorString().toStdString()};
        address_.port = server_.serverPort();
        connect(&server_, &QTcpServer::newConnection, this, [this] {
            while (QTcpSocket* peer = server_.nextPendingConnection()) welcome(peer);
        });
        return {};
    }
    std::string address() const override { return toText(address_); }
    void send(const QByteArray& bytes) override {
        if (peer_ && peer_->bytesToWrite() + bytes.size() <= longest_queue_bytes)
            peer_->write(bytes);
        else
            countDropped(bytes.size());
    }
    void drop() override {
        if (!peer_) return;
        QTcpSocket* old = std::exchange(peer_, nullptr);
        old->disconnect(this);
        old->abort();
        old->deleteLater();
        Q_EMIT peerDown();
    }

private:
    void welcome(QTcpSocket* peer) {
        drop();
        peer_ = peer;
        peer->setSocketOption(QAbstractSocket::LowDelayOption, 1);
        connect(peer, &QTcpSocket::readyRead, this, [this, peer] { Q_EMIT received(peer->readAll()); });
        connect(peer, &QTcpSocket::disconnected, this, [this, peer] {
            if (peer == peer_) drop();
        });
        Q_EMIT peerUp();
    }

    QTcpServer server_;
    QTcpSocket* peer_ = nullptr;
    LinkAddress address_;
};

/// Whoever spoke last is the peer.
class UdpByteServer final : public ByteServer {
public:
    Result<void> start(const LinkAddress& address) {
        address_ = address;
        const QHostAddress host = hostOf(address);
        if (host.isNull()) return notOurs(address);
        if (!socket_.bind(host, address.port))
            return Error{"cannot listen on " + toText(address) + ": " + socket_.errorString().toStdString()};
        address_.port = socket_.localPort();
        connect(&socket_, &QUdpSocket::readyRead, this, [this] {
            while (socket_.hasPendingDatagrams()) {
                const QNetworkDatagram datagram = socket_.receiveDatagram();
                if (!datagram.isValid()) return;
                hear(datagram);
            }
        });
        return {};
    }
    std::string address() const override { return toText(address_); }
    void send(const QByteArray& bytes) override {
        constexpr int longest_datagram = 1400;
        if (!has_peer_) return countDropped(bytes.size());
        for (int at = 0; at < bytes.size(); at += longest_datagram)
            if (socket_.writeDatagram(bytes.mid(at, longest_datagram), peer_, peer_port_) < 0)
                countDropped(std::min<qint64>(longest_datagram, bytes.size() - at));
    }
    void drop() override {
        if (std::exchange(has_peer_, false)) Q_EMIT peerDown();
    }

private:
    void hear(const QNetworkDatagram& datagram) {
        peer_ = datagram.senderAddress();
        peer_port_ = static_cast<quint16>(datagram.senderPort());
        if (!std::exchange(has_peer_, true)) Q_EMIT peerUp();
        Q_EMIT received(datagram.data());
    }

    QUdpSocket socket_;
    QHostAddress peer_;
    quint16 peer_port_ = 0;
    bool has_peer_ = false;
    LinkAddress address_;
};

/// A pair of character devices: this side is the head, the other a serial port. The other side is held open here too,
/// so that its users may come and go.
class PseudoTerminal final : public ByteServer {
public:
    ~PseudoTerminal() override {
        notifier_.reset();
        if (other_side_ >= 0) ::close(other_side_);
        if (side_ >= 0) ::close(side_);
    }
    Result<void> start() {
        side_ = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
        std::array<char, 128> name{};
        if (side_ < 0 || grantpt(side_) != 0 || unlockpt(side_) != 0 || ptsname_r(side_, name.data(), name.size()) != 0)
            return Error{std::string("cannot make a pseudo-terminal: ") + std::strerror(errno)};
        name_ = name.data();
        other_side_ = ::open(name_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
        termios settings{};
        if (other_side_ < 0 || tcgetattr(other_side_, &settings) != 0)
            return Error{"cannot open " + name_ + ": " + std::strerror(errno)};
        cfmakeraw(&settings);
        tcsetattr(other_side_, TCSANOW, &settings);
        // A client that was killed leaves the device marked as its own as long as we hold it open, and the next one
        // would be refused.
        connect(&release_, &QTimer::timeout, this, [this] { ::ioctl(other_side_, TIOCNXCL); });
        release_.start(release_ms);
        notifier_ = std::make_unique<QSocketNotifier>(side_, QSocketNotifier::Read);
        connect(notifier_.get(), &QSocketNotifier::activated, this, [this] { readAll(); });
        return {};
    }
    std::string address() const override { return "serial://" + name_; }
    void send(const QByteArray& bytes) override {
        // A full line discipline means that nobody reads: like a cable without a listener.
        const auto written = ::write(side_, bytes.constData(), static_cast<std::size_t>(bytes.size()));
        countDropped(bytes.size() - std::max<qint64>(written, 0));
    }
    void drop() override {
        if (std::exchange(has_peer_, false)) Q_EMIT peerDown();
    }

private:
    void readAll() {
        std::array<char, 4096> buffer{};
        const auto size = ::read(side_, buffer.data(), buffer.size());
        if (size <= 0) return;
        if (!std::exchange(has_peer_, true)) Q_EMIT peerUp();
        Q_EMIT received(QByteArray(buffer.data(), static_cast<int>(size)));
    }

    int side_ = -1, other_side_ = -1;
    std::string name_;
    bool has_peer_ = false;
    QTimer release_;
    std::unique_ptr<QSocketNotifier> notifier_;
};

template <class Server, class... Arguments>
Result<std::unique_ptr<ByteServer>> started(const Arguments&... arguments) {
    auto server = std::make_unique<Server>();
    if (auto begun = server->start(arguments...); !begun) return Error{begun.error()};
    return std::unique_ptr<ByteServer>(std::move(server));
}

}  // namespace

Result<std::unique_ptr<ByteServer>> ByteServer::listen(const LinkAddress& address) {
    switch (address.kind) {
        case LinkAddress::Kind::Tcp:
            return started<TcpByteServer>(address);
        case LinkAddress::Kind::Udp:
            return started<UdpByteServer>(address);
        case LinkAddress::Kind::PseudoTerminal:
            return started<PseudoTerminal>();
        case LinkAddress::Kind::Serial:
        case LinkAddress::Kind::Tls:
            break;
    }
    return Error{"nothing can listen on " + toText(address) + "; say tcp://ADDR:PORT, udp://ADDR:PORT or pty"};
}

}  // namespace echotrail
