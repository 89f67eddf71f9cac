#pragma once

#include "app/io/byte_channel.hpp"
#include "app/io/byte_server.hpp"

#include <QStringList>
#include <functional>
#include <memory>
#include <string>

namespace echotrail {

/// Runs the event loop until the condition holds; the limit is there only so that a failing test ends.
bool becomes(const std::function<bool()>& condition);

/// A server that must start; what it hears and whether it has a peer.
struct Listener {
    explicit Listener(const std::string& address);
    std::string address() const { return server->address(); }

    std::unique_ptr<ByteServer> server;
    QByteArray heard;
    int ups = 0, downs = 0;
};

/// An opened channel; what it hears and says.
struct Caller {
    explicit Caller(const std::string& address);

    std::unique_ptr<ByteChannel> channel;
    QByteArray heard;
    QStringList reasons;
};

/// Every value a byte can have, the ones terminals like to change among them.
QByteArray everyByte();

}  // namespace echotrail
