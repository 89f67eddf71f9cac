#include "tests/app/io/slow_way.hpp"

#include <QHostAddress>
#include <algorithm>

namespace echotrail {
namespace {

constexpr int tick_ms = 10, held_bytes = 2048;
constexpr double burst_s = 0.1;

}  // namespace

SlowWay::SlowWay(std::uint16_t to_port, const Params& params) : to_port_(to_port), params_(params) {
    QObject::connect(&listener_, &QTcpServer::newConnection, &listener_, [this] { take(); });
    QObject::connect(&tick_, &QTimer::timeout, &tick_, [this] { tick(); });
    plug();
    clock_.start();
    next_stall_ms_ = params_.stall_every_ms;
    tick_.start(tick_ms);
}

void SlowWay::plug() {
    listener_.listen(QHostAddress::LocalHost, own_port_);
    own_port_ = listener_.serverPort();
}

void SlowWay::unplug() {
    listener_.close();
    cut();
}

void SlowWay::take() {
    while (QTcpSocket* console = listener_.nextPendingConnection()) {
        auto pair = std::make_unique<Pair>();
        console->setParent(nullptr);
        pair->console.reset(console);
        pair->tracker = std::make_unique<QTcpSocket>();
        for (QTcpSocket* socket : {pair->console.get(), pair->tracker.get()}) socket->setReadBufferSize(held_bytes);
        // Before it connects: the window that a socket offers follows its buffer.
        pair->tracker->bind(QHostAddress(QHostAddress::LocalHost));
        pair->tracker->setSocketOption(QAbstractSocket::ReceiveBufferSizeSocketOption, 2 * held_bytes);
        pair->tracker->connectToHost(QHostAddress(QHostAddress::LocalHost), to_port_);
        pair->up = {pair->console.get(), pair->tracker.get(), {}, 0.0};
        pair->down = {pair->tracker.get(), pair->console.get(), {}, 0.0};
        pairs_.push_back(std::move(pair));
    }
}

bool SlowWay::stalled() {
    if (params_.stall_every_ms > 0 && last_ms_ >= next_stall_ms_) {
        ++stalls_;
        stall_until_ms_ = last_ms_ + params_.stall_ms;
        next_stall_ms_ = stall_until_ms_ + params_.stall_every_ms;
    }
    return last_ms_ < stall_until_ms_;
}

void SlowWay::tick() {
    const double passed_s = 1e-3 * static_cast<double>(clock_.elapsed() - last_ms_);
    last_ms_ = clock_.elapsed();
    std::erase_if(pairs_, [](const auto& pair) {
        const bool was_up = pair->tracker->state() == QAbstractSocket::UnconnectedState;
        return was_up || pair->console->state() == QAbstractSocket::UnconnectedState;
    });
    if (stalled()) return;
    for (const auto& pair : pairs_) {
        carry(pair->up, passed_s);
        carry(pair->down, passed_s);
    }
}

void SlowWay::carry(Direction& direction, double passed_s) {
    const double rate = params_.bytes_per_second;
    direction.may_send = std::min(direction.may_send + rate * passed_s, burst_s * rate);
    const qint64 most = rate > 0.0 ? static_cast<qint64>(std::max(direction.may_send, 0.0)) : 1 << 20;
    const QByteArray bytes = direction.from->read(most);
    direction.may_send -= static_cast<double>(bytes.size());
    if (!bytes.isEmpty()) direction.under_way.push_back({last_ms_ + params_.delay_ms, bytes});
    while (!direction.under_way.empty() && direction.under_way.front().due_ms <= last_ms_) {
        direction.to->write(direction.under_way.front().bytes);
        direction.under_way.pop_front();
    }
}

}  // namespace echotrail
