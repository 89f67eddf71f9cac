#pragma once

#include "app/io/byte_channel.hpp"

#include <QTcpSocket>
#include <memory>

namespace echotrail {

/// A stream to a server, as its client.
class TcpChannel : public ByteChannel {
public:
    explicit TcpChannel(const LinkAddress& address) : TcpChannel(address, std::make_unique<QTcpSocket>()) {}
    ~TcpChannel() override { socket_->disconnect(this); }

protected:
    TcpChannel(const LinkAddress& address, std::unique_ptr<QTcpSocket> socket);
    QTcpSocket& socket() { return *socket_; }
    void lose(const QString& reason);
    /// The stream may be used: what is due is done, and all are told.
    void ready();
    /// Why the socket says it has failed, for a person.
    virtual QString reasonOf(QAbstractSocket::SocketError error) const;
    QString host() const { return QString::fromStdString(address().host); }

private:
    void tryOpen() override;
    virtual void connectSocket() { socket_->connectToHost(host(), address().port); }
    virtual void connected() { ready(); }
    void setOptions();
    void shut() override;
    qint64 waitingBytes() const override { return socket_->bytesToWrite(); }
    bool write(const QByteArray& bytes) override { return socket_->write(bytes) == bytes.size(); }

    std::unique_ptr<QTcpSocket> socket_;
    QTimer patience_{this};
};

}  // namespace echotrail
