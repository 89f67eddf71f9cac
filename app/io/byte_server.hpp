#pragma once

#include "app/io/link_address.hpp"
#include "core/base/result.hpp"

#include <QByteArray>
#include <QObject>
#include <cstdint>
#include <memory>

namespace echotrail {

/// The other end of a ByteChannel: what a simulated device listens on. One peer at a time; with TCP a new one takes
/// the place of the old, as with a serial server.
/// Threads: the one it lives in, whose event loop runs.
class ByteServer : public QObject {
    Q_OBJECT
public:
    ~ByteServer() override = default;
    /// TCP and UDP with port 0 take any free one; a pseudo-terminal is made.
    static Result<std::unique_ptr<ByteServer>> listen(const LinkAddress& address);

    /// What a client has to be told: `tcp://…`, `udp://…`, `serial:///dev/pts/…`.
    virtual std::string address() const = 0;
    /// Bytes without a peer, or more than it takes, are dropped and counted.
    virtual void send(const QByteArray& bytes) = 0;
    /// Drops the peer, as a pulled cable would; it may come back.
    virtual void drop() = 0;
    std::uint64_t droppedBytes() const { return dropped_bytes_; }

Q_SIGNALS:
    void peerUp();
    void peerDown();
    void received(const QByteArray& bytes);

protected:
    void countDropped(qint64 bytes) { dropped_bytes_ += static_cast<std::uint64_t>(bytes); }

private:
    std::uint64_t dropped_bytes_ = 0;
};

}  // namespace echotrail
