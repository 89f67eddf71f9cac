#include "app/io/byte_channel.hpp"

#include "app/io/tls_channel.hpp"

#include <QFile>
#include <QHostAddress>
#include <QHostInfo>
#include <QNetworkDatagram>
#include <QSerialPort>
#include <QUdpSocket>
#include <algorithm>
#include <optional>
#include <utility>

namespace echotrail {
namespace {

constexpr int first_wait_ms = 250, longest_wait_ms = 5'000;
constexpr int device_look_ms = 1'000;

class SerialChannel final : public ByteChannel {
public:
    explicit SerialChannel(const LinkAddress& address) : ByteChannel(address) {
        connect(&port_, &QSerialPort::readyRead, this, [this] { take(port_.readAll()); });
        connect(&port_, &QSerialPort::errorOccurred, this, [this](QSerialPort::SerialPortError error) {
            if (error == QSerialPort::NoError || error == QSerialPort::TimeoutError || !isUp()) return;
            lose(isThere() ? port_.errorString() : QStringLiteral("is gone; was it unplugged?"));
        });
        // An adapter that was pulled out does not always say so.
        connect(&look_, &QTimer::timeout, this, [this] {
            if (isUp() && !isThere()) lose(QStringLiteral("is gone; was it unplugged?"));
        });
        look_.start(device_look_ms);
    }
    ~SerialChannel() override { port_.disconnect(this); }

private:
    QString path() const { return QString::fromStdString(address().device); }
    bool isThere() const { return QFile::exists(path()); }
    void lose(const QString& reason) {
        port_.close();
        linkLost(path() + ": " + reason);
    }
    void tryOpen() override {
        port_.setPortName(path());
        port_.setBaudRate(address().baud);
        if (!port_.open(QIODevice::ReadWrite)) return linkLost(path() + ": " + whyNotOpened());
        // What came before would get the time of now.
        port_.clear(QSerialPort::Input);
        linkMade();
    }
    QString whyNotOpened() const {
        if (!isThere()) return QStringLiteral("there is no such device; is it plugged in?");
        if (port_.error() != QSerialPort::PermissionError) return port_.errorString();
        return QStringLiteral("not permitted; another program holds it, or you are not in the group 'dialout'");
    }
    void shut() override { port_.close(); }
    qint64 waitingBytes() const override { return port_.bytesToWrite(); }
    bool write(const QByteArray& bytes) override { return port_.write(bytes) == bytes.size(); }

    QSerialPort port_{this};
    QTimer look_{this};
};

/// There is no connection: the link is up when the port is bound. Only the device's own datagrams are heard, from
/// whichever port of it they come.
class UdpChannel final : public ByteChannel {
public:
    explicit UdpChannel(const LinkAddress& address) : ByteChannel(address) {
        connect(&socket_, &QUdpSocket::readyRead, this, [this] { readAll(); });
    }
    ~UdpChannel() override { stopLookUp(); }

private:
    void tryOpen() override {
        shut();
        look_up_ = QHostInfo::lookupHost(QString::fromStdString(address().host), this, [this](const QHostInfo& found) {
            if (found.lookupId() != look_up_) return;  // of before a close()
            look_up_.reset();
            bindTo(found.addresses());
        });
    }
    void bindTo(const QList<QHostAddress>& found) {
        if (found.isEmpty()) return linkLost(QString::fromStdString(address().host) + ": no such host");
        // Serial servers speak IPv4; "localhost" gives both.
        const auto is_v4 = [](const QHostAddress& a) { return a.protocol() == QAbstractSocket::IPv4Protocol; };
        const auto v4 = std::find_if(found.begin(), found.end(), is_v4);
        peer_ = v4 != found.end() ? *v4 : found.first();
        if (!socket_.bind(is_v4(peer_) ? QHostAddress::AnyIPv4 : QHostAddress::AnyIPv6, address().listen))
            return linkLost(QStringLiteral("UDP port %1: %2").arg(address().listen).arg(socket_.errorString()));
        linkMade();
    }
    void readAll() {
        while (isUp() && socket_.hasPendingDatagrams()) {
            const QNetworkDatagram datagram = socket_.receiveDatagram();
            if (!datagram.isValid()) return;
            if (datagram.senderAddress().isEqual(peer_, QHostAddress::TolerantConversion))
                take(datagram.data());
            else
                countForeign();
        }
    }
    void stopLookUp() {
        if (look_up_) QHostInfo::abortHostLookup(*std::exchange(look_up_, std::nullopt));
    }
    void shut() override {
        stopLookUp();
        socket_.close();
    }
    qint64 waitingBytes() const override { return 0; }
    bool write(const QByteArray& bytes) override {
        return socket_.writeDatagram(bytes, peer_, address().port) == bytes.size();
    }

    QUdpSocket socket_{this};
    QHostAddress peer_;
    std::optional<int> look_up_;
};

}  // namespace

ByteChannel::ByteChannel(const LinkAddress& address) : address_(address), wait_ms_(first_wait_ms) {
    retry_.setSingleShot(true);
    connect(&retry_, &QTimer::timeout, this, [this] { tryOpen(); });
}

void ByteChannel::open() {
    if (std::exchange(wanted_, true)) return;
    wait_ms_ = first_wait_ms;
    tryOpen();
}

void ByteChannel::close() {
    wanted_ = false;
    retry_.stop();
    const bool was_up = std::exchange(up_, false);
    last_reason_.clear();
    shut();
    if (was_up) Q_EMIT wentDown(QStringLiteral("closed"));
}

bool ByteChannel::send(const QByteArray& bytes) {
    const bool taken = up_ && waitingBytes() + bytes.size() <= longest_queue_bytes_ && write(bytes);
    (taken ? counts_.bytes_out : counts_.dropped_bytes) += static_cast<std::uint64_t>(bytes.size());
    return taken;
}

void ByteChannel::linkMade() {
    up_ = true;
    retry_.stop();
    last_reason_.clear();
    ++counts_.times_up;
    Q_EMIT wentUp();
}

void ByteChannel::linkLost(const QString& reason) {
    const bool was_up = std::exchange(up_, false);
    if (!wanted_) return;
    if (!retry_.isActive()) {
        retry_.start(wait_ms_);
        wait_ms_ = std::min(2 * wait_ms_, longest_wait_ms);
    }
    if (!was_up && reason == last_reason_) return;
    last_reason_ = reason;
    Q_EMIT wentDown(reason);
}

void ByteChannel::take(const QByteArray& bytes) {
    if (bytes.isEmpty()) return;
    // Not at the connection: some servers take every client and throw it out at once.
    wait_ms_ = first_wait_ms;
    counts_.bytes_in += static_cast<std::uint64_t>(bytes.size());
    Q_EMIT received(bytes);
}

std::unique_ptr<ByteChannel> makeChannel(const LinkAddress& address) {
    switch (address.kind) {
        case LinkAddress::Kind::Tcp:
            return std::make_unique<TcpChannel>(address);
        case LinkAddress::Kind::Tls:
            return std::make_unique<TlsChannel>(address, TrustStore::ofUser());
        case LinkAddress::Kind::Udp:
            return std::make_unique<UdpChannel>(address);
        case LinkAddress::Kind::Serial:
        case LinkAddress::Kind::PseudoTerminal:
            break;
    }
    return std::make_unique<SerialChannel>(address);
}

}  // namespace echotrail
