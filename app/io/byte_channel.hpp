#pragma once

#include "app/io/link_address.hpp"

#include <QByteArray>
#include <QObject>
#include <QString>
#include <QTimer>
#include <cstdint>
#include <memory>

namespace echotrail {

/// What went over a channel since it was made.
struct ChannelCounts {
    std::uint64_t bytes_in = 0, bytes_out = 0;
    std::uint64_t dropped_bytes = 0;  ///< that were to be sent while the link was down, or too slow
    std::uint64_t foreign = 0;        ///< datagrams from someone else
    std::uint64_t times_up = 0;
};

/// A two-way stream of bytes to a device: a serial port, TCP or TLS as client, or UDP. It keeps trying: where the link
/// cannot be made, or breaks, it is made again after a quarter of a second, and then after longer and longer, up to 5
/// s, until bytes come again. Threads: the one it lives in (moveToThread() before open()), whose event loop runs.
class ByteChannel : public QObject {
    Q_OBJECT
public:
    ~ByteChannel() override = default;

    void open();
    void close();
    bool isUp() const { return up_; }
    /// Drops and counts what cannot be taken whole, and says so: the link is down, or too much waits already.
    bool send(const QByteArray& bytes);
    /// How many bytes may wait to be sent; 64 KiB unless said otherwise.
    void setLongestQueue(qint64 bytes) { longest_queue_bytes_ = bytes; }
    const ChannelCounts& counts() const { return counts_; }
    const LinkAddress& address() const { return address_; }

Q_SIGNALS:
    void wentUp();
    /// `reason` is one line for a person; said once for every cause, not at every attempt.
    void wentDown(const QString& reason);
    void received(const QByteArray& bytes);

protected:
    explicit ByteChannel(const LinkAddress& address);
    virtual void tryOpen() = 0;  ///< ends, now or later, in linkMade() or linkLost()
    virtual void shut() = 0;
    virtual qint64 waitingBytes() const = 0;
    virtual bool write(const QByteArray& bytes) = 0;
    void linkMade();
    void linkLost(const QString& reason);
    void take(const QByteArray& bytes);
    void countForeign() { ++counts_.foreign; }

private:
    LinkAddress address_;
    bool wanted_ = false, up_ = false;
    QString last_reason_;
    QTimer retry_{this};
    int wait_ms_;
    qint64 longest_queue_bytes_ = 64 * 1024;
    ChannelCounts counts_;
};

std::unique_ptr<ByteChannel> makeChannel(const LinkAddress& address);

}  // namespace echotrail
