#include "app/io/byte_channel.hpp"

#include <QFile>
#include <QHostAddress>
#include <QHostInfo>
#include <QSerialPort>
#include <QTcpSocket>
#include <QUdpSocket>
#include <algorithm>

namespace echotrail {
namespace {

constexpr int first_wait_ms = 250, longest_wait_ms = 5'000;
constexpr int connect_patience_ms = 5'000, device_look_ms = 1'000;
constexpr qint64 longest_queue_bytes = 64 * 1024;

class SerialChannel final : public ByteChannel {
public:
    explicit SerialChannel(const LinkAddress& address) : ByteChannel(address) {
        connect(&port_, &QSerialPort::readyRead, this, [this] { take(port_.readAll()); });
        connect(&port_, &QSerialPort::errorOccurred, this, [this](QSerialPort::SerialPortError error) {
            if (error == QSerialPort::NoError || error == QSerialPort::TimeoutError || !port_.isOpen()) return;
            const QString reason = port_.errorString();
            port_.close();
            linkLost(reason);
        });
        // An adapter that was pulled out does not always say so.
        connect(&look_, &QTimer::timeout, this, [this] {
            if (!port_.isOpen() || QFile::exists(port_.portName().startsWith('/') ? port_.portName() : path())) return;
            port_.close();
            linkLost(path() + " is gone: was it unplugged?");
        });
        look_.start(device_look_ms);
    }

private:
    QString path() const { return QString::fromStdString(address().device); }
    void tryOpen() override {
        port_.setPortName(path());
        port_.setBaudRate(address().baud);
        if (port_.open(QIODevice::ReadWrite)) return linkMade();
        const QString why = !QFile::exists(path()) ? QStringLiteral("there is no such device; is it plugged in?")
                            : port_.error() == QSerialPort::PermissionError
                                ? QStringLiteral(
                                      "not permitted; add yourself to the group 'dialout', or another "
                                      "program holds it")
                                : port_.errorString();
        linkLost(path() + ": " + why);
    }
    void shut() override { port_.close(); }
    qint64 waitingBytes() const override { return port_.bytesToWrite(); }
    bool write(const QByteArray& bytes) override { return port_.write(bytes) == bytes.size(); }

    QSerialPort port_;
    QTimer look_;
};

class TcpChannel final : public ByteChannel {
public:
    explicit TcpChannel(const LinkAddress& address) : ByteChannel(address) {
        patience_.setSingleShot(true);
        connect(&socket_, &QTcpSocket::connected, this, [this] {
            patience_.stop();
            socket_.setSocketOption(QAbstractSocket::LowDelayOption, 1);
            socket_.setSocketOption(QAbstractSocket::KeepAliveOption, 1);
            linkMade();
        });
        connect(&socket_, &QTcpSocket::readyRead, this, [this] { take(socket_.readAll()); });
        connect(&socket_, &QTcpSocket::disconnected, this, [this] { linkLost(name() + ": the other side closed"); });
        connect(&socket_, &QTcpSocket::errorOccurred, this, [this] {
            patience_.stop();
            const QString reason = name() + ": " + socket_.errorString();
            socket_.abort();
            linkLost(reason);
        });
        connect(&patience_, &QTimer::timeout, this, [this] {
            socket_.abort();
            linkLost(name() + ": no answer");
        });
    }
    ~TcpChannel() override { socket_.disconnect(this); }

private:
    QString name() const { return QString::fromStdString(toText(address())); }
    void tryOpen() override {
        socket_.abort();
        patience_.start(connect_patience_ms);
        socket_.connectToHost(QString::fromStdString(address().host), address().port);
    }
    void shut() override {
        patience_.stop();
        socket_.disconnectFromHost();
    }
    qint64 waitingBytes() const override { return socket_.bytesToWrite(); }
    bool write(const QByteArray& bytes) override { return socket_.write(bytes) == bytes.size(); }

    QTcpSocket socket_;
    QTimer patience_;
};

/// There is no connection: the link is up when the port is bound. Only the device's own datagrams are heard.
class UdpChannel final : public ByteChannel {
public:
    explicit UdpChannel(const LinkAddress& address) : ByteChannel(address) {
        connect(&socket_, &QUdpSocket::readyRead, this, [this] { readAll(); });
    }

private:
    void tryOpen() override {
        const auto found = QHostInfo::fromName(QString::fromStdString(address().host));
        if (found.addresses().isEmpty()) return linkLost(QString::fromStdString(address().host) + ": no such host");
        peer_ = found.addresses().first();
        const auto any =
            peer_.protocol() == QAbstractSocket::IPv6Protocol ? QHostAddress::AnyIPv6 : QHostAddress::AnyIPv4;
        if (!socket_.bind(any, address().listen))
            return linkLost(QStringLiteral("UDP port %1: %2").arg(address().listen).arg(socket_.errorString()));
        linkMade();
    }
    void readAll() {
        while (socket_.hasPendingDatagrams()) {
            QByteArray bytes(static_cast<int>(socket_.pendingDatagramSize()), Qt::Uninitialized);
            QHostAddress sender;
            const qint64 size = socket_.readDatagram(bytes.data(), bytes.size(), &sender);
            if (size < 0) continue;
            bytes.truncate(static_cast<int>(size));
            if (!sender.isEqual(peer_, QHostAddress::TolerantConversion))
                countForeign();
            else
                take(bytes);
        }
    }
    void shut() override { socket_.close(); }
    qint64 waitingBytes() const override { return 0; }
    bool write(const QByteArray& bytes) override {
        return socket_.writeDatagram(bytes, peer_, address().port) == bytes.size();
    }

    QUdpSocket socket_;
    QHostAddress peer_;
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
    shut();
    if (std::exchange(up_, false)) Q_EMIT wentDown(QStringLiteral("closed"));
}

void ByteChannel::send(const QByteArray& bytes) {
    if (!up_ || waitingBytes() + bytes.size() > longest_queue_bytes || !write(bytes))
        counts_.dropped_bytes += static_cast<std::uint64_t>(bytes.size());
    else
        counts_.bytes_out += static_cast<std::uint64_t>(bytes.size());
}

void ByteChannel::linkMade() {
    up_ = true;
    wait_ms_ = first_wait_ms;
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
    counts_.bytes_in += static_cast<std::uint64_t>(bytes.size());
    Q_EMIT received(bytes);
}

std::unique_ptr<ByteChannel> makeChannel(const LinkAddress& address) {
    switch (address.kind) {
        case LinkAddress::Kind::Tcp:
            return std::make_unique<TcpChannel>(address);
        case LinkAddress::Kind::Udp:
            return std::make_unique<UdpChannel>(address);
        case LinkAddress::Kind::Serial:
        case LinkAddress::Kind::PseudoTerminal:
            break;
    }
    return std::make_unique<SerialChannel>(address);
}

}  // namespace echotrail
